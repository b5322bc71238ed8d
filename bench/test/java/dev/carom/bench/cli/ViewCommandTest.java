// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

class ViewCommandTest {

  @TempDir private Path folder;

  @Test
  @Tag("long")
  void recordsBothSides() throws Exception {
    Path file = folder.resolve("new/corner.svg");

    Cli run = Cli.run("view --preset corner --against published --slow 2 --record", file);

    assertThat(run).isEqualTo(new Cli(0, "", ""));
    Element svg = parse(Files.readString(file));
    // Both sides share one clock: an svg element within another has its own in some browsers.
    assertThat(svg.getElementsByTagName("svg").getLength()).isZero();
    assertThat(texts(svg))
        .containsExactly(
            "Carom",
            "0 of 4 lost",
            "the published algorithm",
            "0 of 4 lost",
            "1 of 4 lost",
            "2 of 4 lost",
            "2 times slower. Circles ignore each other. Orange: lost through a line or a wall; in the end 0 and 2.");
    Element first = (Element) svg.getElementsByTagName("animate").item(0);
    assertThat(first.getAttribute("dur")).isEqualTo("10.0s");
  }

  @Test
  void recordsAFlightAsAPage() throws Exception {
    Path scene = folder.resolve("fall.csv");
    Files.writeString(scene, "gravity,0,-1\nwall,0,0,100,100\ncircle,50,10,10,0,9\n");
    Path file = folder.resolve("fall.html");

    Cli run = Cli.run("view --frames 30 --scene", scene, "--record", file);

    assertThat(run).isEqualTo(new Cli(0, "", ""));
    String page = Files.readString(file);
    assertThat(page).contains("<button>Pause</button>", "<input type=\"range\"");
    String svg = page.substring(page.indexOf("<svg"), page.lastIndexOf("</svg>") + 6);
    Element rise = (Element) parse(svg).getElementsByTagName("animate").item(0);
    assertThat(rise.getAttribute("attributeName")).isEqualTo("cy");
    assertThat(rise.getAttribute("keyTimes")).isEqualTo("0;0.3;0.6;0.9;1");
    assertThat(rise.getAttribute("values")).isEqualTo("10;50.5;10;50.5;46");
    assertThat(rise.getAttribute("keySplines"))
        .startsWith(".333 0.667 .667 1;.333 0 .667 0.333;.333 0.667");
  }

  private static Element parse(String svg) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(svg)))
        .getDocumentElement();
  }

  private static List<String> texts(Element svg) {
    NodeList texts = svg.getElementsByTagName("text");
    return IntStream.range(0, texts.getLength())
        .mapToObj(i -> texts.item(i).getTextContent().strip())
        .toList();
  }

  @Test
  void drawsASceneWithoutAScreen() throws IOException {
    Path file = folder.resolve("new/scene.png");
    Cli run = Cli.run("view --circles 3 --frames 20 --png", file);
    assertThat(run).isEqualTo(new Cli(0, "", ""));
    assertThat(ImageIO.read(file.toFile()).getWidth()).isGreaterThan(800);
  }

  @Test
  void noRivalIsLetInAmongObstaclesThatMove() throws IOException {
    Path scene = folder.resolve("lift.csv");
    Files.writeString(scene, "line,0,0,9,0,vy=1\ncircle,5,9,1,0,0\n");

    Cli run = Cli.run("view --scene", scene, "--against", "dyn4j");

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err())
        .contains("--against plays scenes whose obstacles rest: a line or a peg moves");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          view --preset slow --circles 3      | --preset excludes the options of other scenes
          view --preset slow --record x.gif   | --record is x.gif: expected a name that ends in .svg or .html
          view --against dyn4j --dt 0.5       | --dt is 0.5
          view --against bullet               | 'bullet' is none of [box2d, dyn4j, jbox2d, published
          view --preset none                  | 'none' is none of [fast, gap, corner, shallow, slow
          view --against dyn4j --frames -1    | --frames
          """)
  void tellsWhatIsWrong(String line, String message) {
    Cli run = Cli.run(line);

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains(message).hasLineCount(1);
  }
}
