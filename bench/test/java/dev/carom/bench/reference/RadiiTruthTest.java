// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Feature;
import dev.carom.Kind;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The scene {@code radii} against what another program, with other numbers, made of it. */
class RadiiTruthTest {

  private static final int FRAMES = 600;

  private static Truth truth;

  @BeforeAll
  static void compute() throws IOException {
    truth = Truth.of(References.scene("radii"), FRAMES, () -> {});
  }

  private static void forEachRow(String file, Consumer<String[]> action) throws IOException {
    try (InputStream raw = References.class.getResourceAsStream("/dev/carom/bench/scenes/" + file);
        InputStream plain = file.endsWith(".gz") ? new GZIPInputStream(raw) : raw;
        BufferedReader in =
            new BufferedReader(new InputStreamReader(plain, StandardCharsets.US_ASCII))) {
      in.readLine(); // the header
      in.lines().map(line -> line.split(",")).forEach(action);
    }
  }

  @Test
  void placesAreTheSameToTheLastBit() throws IOException {
    int[] count = new int[1];
    forEachRow(
        "radii-positions.csv.gz",
        row -> {
          int frame = Integer.parseInt(row[0]);
          int circle = Integer.parseInt(row[1]);
          assertThat(truth.x(frame, circle)).isEqualTo(Double.parseDouble(row[2]));
          assertThat(truth.y(frame, circle)).isEqualTo(Double.parseDouble(row[3]));
          count[0]++;
        });
    assertThat(count[0]).isEqualTo(FRAMES * 100);
  }

  /** To the two decimals given there. */
  @Test
  void conditioningIsTheSame() throws IOException {
    forEachRow(
        "radii-conditioning.csv.gz",
        row -> {
          double ours = truth.log10Conditioning(Integer.parseInt(row[0]), Integer.parseInt(row[1]));
          assertThat(Math.abs(ours - Double.parseDouble(row[2]))).isLessThan(0.00501);
        });
  }

  private static int column(Hit hit) {
    if (hit.kind() == Kind.WALL) {
      return 4;
    }
    return hit.feature() == Feature.SIDE ? 1 : hit.feature() == Feature.START ? 2 : 3;
  }

  @Test
  void impactsAndLastVelocitiesAreTheSame() throws IOException {
    forEachRow(
        "radii-impacts.csv",
        row -> {
          int circle = Integer.parseInt(row[0]);
          List<Hit> hits = truth.proofs().get(circle).hits();
          for (int column = 1; column <= 4; column++) {
            int c = column;
            assertThat(hits.stream().filter(hit -> column(hit) == c).count())
                .as("circle %s, column %s", circle, c)
                .isEqualTo(Long.parseLong(row[column]));
          }
          assertThat(truth.vx(FRAMES, circle)).isEqualTo(Double.parseDouble(row[5]));
          assertThat(truth.vy(FRAMES, circle)).isEqualTo(Double.parseDouble(row[6]));
        });
  }
}
