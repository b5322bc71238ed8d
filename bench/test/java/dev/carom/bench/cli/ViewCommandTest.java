// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ViewCommandTest {

  @TempDir private Path folder;

  @Test
  @Tag("long")
  void recordsBothSides() throws IOException {
    Path file = folder.resolve("new/slow.gif");

    Cli run = Cli.run("view --preset slow --against substeps --frames 20 --record", file);

    assertThat(run.err()).isEmpty();
    assertThat(run.exitCode()).isZero();
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream in = ImageIO.createImageInputStream(new File(file.toString()))) {
      reader.setInput(in);
      assertThat(reader.getNumImages(true)).isEqualTo(11);
      assertThat(reader.getWidth(0)).isEqualTo(800);
    } finally {
      reader.dispose();
    }
    assertThat(Files.size(file)).isLessThan(2_000_000);
  }

  @Test
  void drawsASceneWithoutAScreen() throws IOException {
    Path file = folder.resolve("new/scene.png");
    Cli run = Cli.run("view --circles 3 --frames 20 --png", file);
    assertThat(run).isEqualTo(new Cli(0, "", ""));
    assertThat(ImageIO.read(file.toFile()).getWidth()).isGreaterThan(800);
  }

  /** The README's. */
  @Test
  void theRecordingThatIsKeptIsSmall() throws IOException {
    assertThat(Files.size(Path.of("results/side-by-side.gif"))).isBetween(10_000L, 2_000_000L);
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
          view --preset slow --record x.gif   | --against is missing
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
