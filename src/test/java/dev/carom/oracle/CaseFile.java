// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;

/**
 * The committed cases {@code cases/*.csv}: queries of each family with the answers that a third
 * program, in another language, gave with thousands of bits. A row has the numbers of the query,
 * then hit, feature, t, tdouble, nx, ny.
 *
 * @param query the question
 * @param part the feature, {@link Part#NONE} for a miss
 * @param time the correctly rounded time, NaN for a miss
 * @param nx the normal, NaN for a miss
 * @param ny the normal, NaN for a miss
 * @param digits the time to 40 digits, null for a miss
 */
public record CaseFile(
    Query query, Part part, double time, double nx, double ny, BigDecimal digits) {

  /** The names of the files. */
  public static List<String> names() {
    return Stream.of(
            ("seg_uniform seg_near_graze seg_voronoi_edge seg_start_touching seg_start_overlapping"
                    + " seg_start_on_line seg_fast seg_slow seg_shallow seg_far seg_tiny_scale"
                    + " seg_huge_scale seg_radius_zero seg_radius_small seg_radius_large"
                    + " seg_segment_short seg_collinear seg_parallel_at_r seg_window_end"
                    + " seg_tie_plus_tiny seg_extreme_magnitude seg_poster_cases circ_concentric"
                    + " circ_extreme_magnitude circ_far circ_fast circ_head_on circ_near_graze"
                    + " circ_overlapping circ_same_velocity circ_size_ratio circ_touching"
                    + " circ_uniform")
                .split(" "))
        .toList();
  }

  /** The cases of one file. */
  public static List<CaseFile> read(String name) {
    String path = "/cases/" + name + ".csv";
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(
                CaseFile.class.getResourceAsStream(path), StandardCharsets.UTF_8))) {
      boolean pair = name.startsWith("circ_");
      return reader.lines().skip(1).map(row -> parse(row.split(","), pair)).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(path, e);
    }
  }

  private static CaseFile parse(String[] fields, boolean pair) {
    int count = pair ? 11 : 10;
    double[] numbers = Stream.of(fields).limit(count).mapToDouble(Double::parseDouble).toArray();
    return new CaseFile(
        pair ? PairQuery.of(numbers) : SegmentQuery.of(numbers),
        Part.valueOf(fields[count + 1]),
        Double.parseDouble(fields[count + 3]),
        Double.parseDouble(fields[count + 4]),
        Double.parseDouble(fields[count + 5]),
        digits(fields[count + 2]));
  }

  private static BigDecimal digits(String text) {
    return text.equals("NaN") ? null : new BigDecimal(text);
  }
}
