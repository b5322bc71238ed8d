// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.stability;

import dev.carom.bench.measures.Part;
import dev.carom.bench.results.Row;
import java.util.List;

/** One map as a part of the report. It takes no times. */
public record StabilityPart(FailureMap map) implements Part {

  /** About a minute for all six. */
  private static final double SECONDS = 10;

  /**
   * All maps.
   *
   * @param quick whether every third value of each axis will do
   */
  public static List<Part> all(boolean quick) {
    return FailureMap.all(quick).stream().<Part>map(StabilityPart::new).toList();
  }

  @Override
  public String id() {
    return "stability/" + map.name();
  }

  @Override
  public double seconds() {
    return SECONDS;
  }

  @Override
  public List<Row> run() {
    return Survey.of(map, Survey.contenders());
  }
}
