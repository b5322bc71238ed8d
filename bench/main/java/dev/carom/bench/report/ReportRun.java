// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.measures.Part;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.ResultsJson;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Runs the parts of a report. The rows of each finished part are kept in a folder, so that a run
 * that was interrupted goes on where it was: a later one takes them if all that they depend on is
 * the same.
 */
public final class ReportRun {

  /** The metric of a row whose stat is the reason why something was not measured. */
  public static final String FAILURE = "failure";

  /** Is told of each part. */
  @FunctionalInterface
  public interface Listener {

    /**
     * A part is done.
     *
     * @param kept whether its rows are those of an earlier run
     */
    void finished(Part part, int done, int of, boolean kept);
  }

  private final Metadata metadata;
  private final Path folder;

  /**
   * Prepares a run.
   *
   * @param folder where rows are kept
   */
  public ReportRun(Metadata metadata, Path folder) {
    this.metadata = metadata;
    this.folder = folder;
  }

  /**
   * Runs what is not kept.
   *
   * @param listener is told of each
   * @return the rows of all parts, in their order; a part that broke down leaves one that says why
   * @throws IOException if rows cannot be kept
   */
  public Results run(List<Part> parts, Listener listener) throws IOException {
    Files.createDirectories(folder);
    List<Row> rows = new ArrayList<>();
    int done = 0;
    for (Part part : parts) {
      Optional<List<Row>> kept = kept(part);
      rows.addAll(kept.isPresent() ? kept.get() : measure(part));
      done++;
      listener.finished(part, done, parts.size(), kept.isPresent());
    }
    return new Results(metadata, rows);
  }

  private List<Row> measure(Part part) throws IOException {
    List<Row> rows;
    try {
      rows = part.run();
    } catch (RuntimeException e) {
      String reason = e.getMessage() == null ? e.toString() : e.getMessage();
      return List.of(new Row(part.id(), "", "", FAILURE, reason, Double.NaN, "1", 1, -1));
    }
    ResultsJson.write(new Results(metadata, rows), file(part));
    return rows;
  }

  /**
   * Rows of an earlier run. A part is measured again if its file is unreadable or from elsewhere.
   */
  private Optional<List<Row>> kept(Part part) {
    if (!Files.exists(file(part))) {
      return Optional.empty();
    }
    try {
      Results results = ResultsJson.read(file(part));
      return results.metadata().matches(metadata) ? Optional.of(results.rows()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private Path file(Part part) {
    return folder.resolve(part.id().replaceAll("[^A-Za-z0-9.+-]", "_") + ".json");
  }

  /**
   * Throws away what was kept, once the whole is stored elsewhere.
   *
   * @throws IOException if the folder cannot be emptied
   */
  public void forget() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }
}
