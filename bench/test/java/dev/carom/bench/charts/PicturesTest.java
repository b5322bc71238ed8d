// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PicturesTest {

  private static final String[] NAMES = {"initial", "middle", "final", "frame-times"};
  private static final double BUDGET = 1000.0 / 60;

  @TempDir static Path temp;
  private static Path first;
  private static Path second;

  @BeforeAll
  static void writeTwice() throws IOException {
    first = temp.resolve("new/first");
    second = temp.resolve("second");
    Pictures.write(scene(), 10, nanos(), BUDGET, first);
    Pictures.write(scene(), 10, nanos(), BUDGET, second);
  }

  private static Scene scene() {
    SceneBuilder builder =
        Scene.builder().collide(false).bounds(0, 0, 80, 60).line(30, 20, 50, 40).peg(60, 30, 3);
    return builder.circle(20, 30, 5, 4, 3).circle(60, 50, 5, -2, 0).build();
  }

  private static double[] nanos() {
    double[] nanos = new double[10];
    Arrays.setAll(nanos, i -> 500 + 10 * i);
    return nanos;
  }

  private static long colors(BufferedImage image) {
    int w = image.getWidth();
    return Arrays.stream(image.getRGB(0, 0, w, image.getHeight(), null, 0, w)).distinct().count();
  }

  @Test
  void everyPngCanBeDecodedAndIsNotEmpty() throws IOException {
    for (String name : NAMES) {
      BufferedImage image = ImageIO.read(first.resolve(name + ".png").toFile());
      assertThat(image.getWidth()).as(name).isGreaterThan(800);
      assertThat(colors(image)).as(name).isGreaterThan(9);
    }
  }

  @Test
  void everySvgIsWellFormed() throws Exception {
    for (String name : NAMES) {
      DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
      var svg = builder.parse(first.resolve(name + ".svg").toFile()).getDocumentElement();
      assertThat(svg.getTagName()).isEqualTo("svg");
      assertThat(svg.getAttribute("viewBox")).isNotEmpty();
      assertThat(svg.getElementsByTagName("title").item(0).getTextContent()).isNotBlank();
    }
  }

  @Test
  void theSameInputGivesTheSameBytes() throws IOException {
    try (Stream<Path> files = Files.list(first)) {
      assertThat(files)
          .hasSize(9)
          .allSatisfy(
              file -> assertThat(second.resolve(file.getFileName())).hasSameBinaryContentAs(file));
    }
  }

  @Test
  void replacesWhatIsThere() throws IOException {
    Path dir = Files.createDirectory(temp.resolve("used"));
    Files.writeString(dir.resolve("final.svg"), "old");
    Pictures.write(scene(), 10, nanos(), BUDGET, dir);
    assertThat(dir.resolve("final.svg")).hasSameBinaryContentAs(first.resolve("final.svg"));
  }

  @Test
  void drawsASceneWithNothingInItAndARunOfNoFrames() throws IOException {
    Path dir = temp.resolve("nothing");
    Pictures.write(Scene.builder().build(), 0, new double[] {0}, BUDGET, dir);
    assertThat(dir.resolve("motion.svg")).isNotEmptyFile();
  }

  @Test
  void aFailureNamesTheFile() throws IOException {
    Path dir = Files.createDirectories(temp.resolve("blocked"));
    Files.createDirectory(dir.resolve("middle.svg"));
    assertThatThrownBy(() -> Pictures.write(scene(), 10, nanos(), BUDGET, dir))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(dir.resolve("middle.svg").toString());
  }

  @Test
  void aFailureNamesTheFolder() throws IOException {
    Path file = Files.writeString(temp.resolve("file"), "");
    assertThatThrownBy(() -> Pictures.write(scene(), 10, nanos(), BUDGET, file))
        .isInstanceOf(IOException.class)
        .hasMessageContaining(file.toString());
  }

  @Test
  void refusesWhatCannotBeDrawn() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Pictures.write(scene(), -1, nanos(), BUDGET, temp))
        .withMessageContaining("frames is -1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Pictures.write(scene(), 1, new double[0], BUDGET, temp))
        .withMessageContaining("frameNanos is empty");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Pictures.write(scene(), 1, new double[] {1, Double.NaN}, BUDGET, temp))
        .withMessageContaining("frameNanos[1] is NaN");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Pictures.write(scene(), 1, nanos(), 0, temp))
        .withMessageContaining("budgetMillis is 0.0");
  }
}
