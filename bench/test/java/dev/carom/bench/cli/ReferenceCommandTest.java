// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.bench.examples.Photon;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReferenceCommandTest {

  @Test
  void tellsWhatItTook() {
    Cli run = Cli.run("reference base-1 radii --frames 5");

    assertThat(run.exitCode()).isZero();
    List<String> rows = run.out().lines().toList();
    assertThat(rows).hasSize(3);
    assertThat(rows.get(1)).startsWith("base-1").hasSize(rows.get(0).length());
    assertThat(rows.get(2)).startsWith("radii ").hasSize(rows.get(0).length());
  }

  @Test
  void writesFiles(@TempDir Path folder) {
    Path target = folder.resolve("references");

    Cli run = Cli.run("reference base-1 --frames 5 --write", target);

    assertThat(run.exitCode()).isZero();
    assertThat(target.resolve("base-1.flights")).isNotEmptyFile();
  }

  @Test
  void namesTheScenesItKnows() {
    Cli run = Cli.run("reference base-9");

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains("SCENE is base-9: expected one of [base-1");
  }

  /**
   * How far the photon of the SIAM 100-Digit Challenge is from the origin at the end: a hundred
   * digits. The first 79 are published (F. Bornemann, D. Laurie, S. Wagon and J. Waldvogel, The
   * SIAM 100-Digit Challenge, 2004). All of them are also those of a program of 30 lines in Python,
   * in decimal numbers of 170 digits and of 300.
   */
  private static final String PHOTON =
      "0.99526291944335416089031180942672162102946692273415"
          + "43498032088580729861796228306320991749818976188760";

  @Test
  void printsAHundredDigitsOfThePhoton(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("photon.csv");
    Photon.scene().write(file);

    Cli run = Cli.run("reference --scene", file, "--frames", 300, "--digits", 110);

    assertThat(run.exitCode()).as(run.err()).isZero();
    List<String> rows = run.out().lines().toList();
    assertThat(rows).hasSize(2).first().isEqualTo("circle,x,y");
    String[] fields = rows.get(1).split(",", -1);
    BigDecimal x = new BigDecimal(fields[1]);
    BigDecimal y = new BigDecimal(fields[2]);
    assertThat(x.scale()).isEqualTo(110);
    MathContext digits = new MathContext(120);
    BigDecimal distance =
        x.multiply(x).add(y.multiply(y)).sqrt(digits).divide(BigDecimal.valueOf(30), digits);
    assertThat(distance.setScale(100, RoundingMode.DOWN)).isEqualTo(new BigDecimal(PHOTON));
  }

  @Test
  void playsOneSceneOrOthers(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("one.csv"), "circle,15,3,5,1,0\n");

    Cli run = Cli.run("reference base-1 --scene", file);
    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains("--scene excludes SCENE and --write");

    Cli ofDigits = Cli.run("reference base-1 --digits 5");
    assertThat(ofDigits.exitCode()).isEqualTo(2);
    assertThat(ofDigits.err()).contains("--digits needs --scene");

    Cli one = Cli.run("reference --scene", file, "--frames", 2, "--digits", 3);
    assertThat(one.out().lines()).containsExactly("circle,x,y", "0,17.000,3.000");
  }
}
