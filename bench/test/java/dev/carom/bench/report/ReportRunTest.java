// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dev.carom.bench.measures.Part;
import dev.carom.bench.results.Metadata;
import dev.carom.bench.results.Results;
import dev.carom.bench.results.Row;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReportRunTest {

  /** A part that counts how often it was run, or breaks down. */
  private static final class FakePart implements Part {
    private final String id;
    private final Throwable failure;
    private int runs;

    FakePart(String id, Throwable failure) {
      this.id = id;
      this.failure = failure;
    }

    @Override
    public String id() {
      return id;
    }

    @Override
    public double seconds() {
      return 1;
    }

    @Override
    public List<Row> run() {
      runs++;
      if (failure instanceof RuntimeException e) {
        throw e;
      }
      if (failure instanceof Error e) {
        throw e;
      }
      return List.of(new Row("s", id, "", "frame_time", "median", runs, "ns", 1, 0));
    }
  }

  private final List<String> told = new ArrayList<>();
  private final FakePart first = new FakePart("scene/base-1/carom", null);
  private final FakePart second = new FakePart("scene/base-1/poster", null);

  @TempDir Path temp;

  private Results run(Metadata metadata, Part... parts) throws IOException {
    told.clear();
    return new ReportRun(metadata, temp.resolve("parts"))
        .run(
            List.of(parts),
            (part, done, of, kept) -> told.add(done + "/" + of + " " + part.id() + " " + kept));
  }

  @Test
  void anInterruptedRunGoesOnWhereItWas() throws IOException {
    FakePart cut = new FakePart("cut", new StackOverflowError("interrupted"));
    assertThatThrownBy(() -> run(Sample.METADATA, first, cut, second))
        .isInstanceOf(StackOverflowError.class);

    Results results = run(Sample.METADATA, first, new FakePart("cut", null), second);

    assertThat(first.runs).isEqualTo(1);
    assertThat(results.rows()).extracting(Row::method).containsExactly(first.id, "cut", second.id);
    assertThat(told)
        .containsExactly(
            "1/3 scene/base-1/carom true", "2/3 cut false", "3/3 scene/base-1/poster false");
  }

  @Test
  void rowsOfAnotherCommitAreMeasuredAgain() throws IOException {
    Metadata m = Sample.METADATA;
    run(m, first);
    Metadata other =
        new Metadata(
            m.cpu(),
            m.cores(),
            m.os(),
            m.jdk(),
            m.flags(),
            "fedc",
            m.scenes(),
            m.seeds(),
            "",
            true);
    assertThat(run(other, first).rows().get(0).value()).isEqualTo(2);
  }

  @Test
  void rowsThatCannotBeReadAreMeasuredAgain() throws IOException {
    run(Sample.METADATA, first);
    Files.writeString(temp.resolve("parts/scene_base-1_carom.json"), "{");
    assertThat(run(Sample.METADATA, first).rows().get(0).value()).isEqualTo(2);
  }

  @Test
  void aPartThatBreaksDownDoesNotEndTheRun() throws IOException {
    FakePart broken = new FakePart("broken", new IllegalStateException("no natives here"));
    Results results = run(Sample.METADATA, broken, second);
    Row row = results.rows().get(0);
    assertThat(row.metric()).isEqualTo("failure");
    assertThat(row.stat()).isEqualTo("no natives here");
    assertThat(results.rows()).hasSize(2);
    run(Sample.METADATA, broken, second);
    assertThat(broken.runs).isEqualTo(2);
  }

  @Test
  void whatIsStoredElsewhereIsForgotten() throws IOException {
    run(Sample.METADATA, first);
    new ReportRun(Sample.METADATA, temp.resolve("parts")).forget();
    assertThat(temp).isEmptyDirectory();
  }
}
