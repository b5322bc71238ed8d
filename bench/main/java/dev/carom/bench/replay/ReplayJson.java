// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import com.fasterxml.jackson.databind.PropertyNamingStrategies;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.carom.bench.results.WholeFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * The figures for machines. The names of the components are those of the file, there in snake case;
 * their order is the file's, too. The ratio is null where the published algorithm did not replay.
 */
public record ReplayJson(
    String scene,
    int frames,
    double budgetMs,
    double publishedFps,
    List<Row> methods,
    Double ratioToPoster,
    Machine machine) {

  /** One method: times in microseconds, impacts of one replay with lines and pegs. */
  public record Row(
      String name,
      long impacts,
      double meanUs,
      double medianUs,
      double p95Us,
      double p99Us,
      double worstUs,
      long framesOverBudget,
      double fps,
      double allocBytesPerFrame) {

    static Row of(Figures f) {
      return new Row(
          f.name(),
          f.counts().impacts(),
          f.mean(),
          f.median(),
          f.p95(),
          f.p99(),
          f.worst(),
          f.framesOverBudget(),
          f.fps(),
          f.bytesPerFrame());
    }
  }

  public static ReplayJson of(ReplayResult result) {
    return new ReplayJson(
        result.plan().name(),
        result.plan().frames(),
        Budget.MILLIS,
        Budget.PUBLISHED_FPS,
        result.figures().stream().map(Row::of).toList(),
        result.ratioToPoster().isPresent() ? result.ratioToPoster().getAsDouble() : null,
        result.machine());
  }

  public void write(Path file) throws IOException {
    JsonMapper mapper =
        JsonMapper.builder()
            .propertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE)
            .enable(SerializationFeature.INDENT_OUTPUT)
            .build();
    WholeFile.write(file, mapper.writeValueAsBytes(this));
  }
}
