// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.methods.PlainScene;
import java.util.Locale;
import java.util.function.Function;

/** The figures for people: what was replayed, the verdict, and one column a method. */
public final class ReplayTable {

  private static final int LABEL = 38;
  private static final int COLUMN = 16;

  private final ReplayResult result;
  private final StringBuilder text = new StringBuilder();

  private ReplayTable(ReplayResult result) {
    this.result = result;
  }

  /**
   * Renders the figures.
   *
   * @param result what a run found
   * @return lines of text, the last one ended as the others are
   */
  public static String render(ReplayResult result) {
    ReplayTable table = new ReplayTable(result);
    table.head();
    table.verdict();
    table.times();
    table.budget();
    table.work();
    table.foot();
    return table.text.toString();
  }

  private void head() {
    ReplayPlan plan = result.plan();
    Scene scene = plan.scene();
    Machine machine = result.machine();
    line("scene    %s", plan.name());
    line(
        "         %s, %s, %s",
        Counted.of(scene.count(Kind.CIRCLE), "circle"),
        Counted.of(scene.count(Kind.LINE), "line"),
        Counted.of(scene.count(Kind.PEG), "peg"));
    line(
        "run      %s, %s in each of %s per method",
        Counted.of(plan.frames(), "frame"),
        Counted.of(plan.replays(), "replay"),
        Counted.of(plan.forks(), "fresh virtual machine"));
    line("machine  %s; %s %s", machine.cpu(), machine.jdk(), machine.flags());
    line("");
  }

  /** By the typical replay, so that one hiccup of the machine in minutes does not decide. */
  private void verdict() {
    Figures carom = result.figures(Methods.CAROM);
    line(
        "%s: the slowest frame of a replay takes %s us of the %,.0f us that 60 FPS allow;",
        carom.worst() <= Budget.MICROS ? "BUDGET MET" : "BUDGET MISSED",
        us(carom.worst()),
        Budget.MICROS);
    line("%,d of all %,d frames exceeded them.", carom.framesOverBudget(), carom.samples());
    if (result.ratioToPoster().isPresent()) {
      double medians = result.figures(Methods.POSTER).median() / carom.median();
      line(
          "A frame of carom takes %s us on average: %s times as fast as poster in the same run",
          us(carom.mean()), us(result.ratioToPoster().getAsDouble()));
      line("(%s times by the medians).", us(medians));
    } else {
      line(
          "A frame of carom takes %s us on average. The published algorithm knows no circles",
          us(carom.mean()));
      line("that collide or fall, and no obstacles that move: it does not replay this scene.");
    }
    line("");
  }

  private void times() {
    row("us per frame", Figures::name, "published 2010");
    row("mean", f -> us(f.mean()), us(Budget.PUBLISHED_MICROS));
    row("  by fork, least and most", f -> us(f.leastForkMean()) + " .. " + us(f.mostForkMean()));
    row("median", f -> us(f.median()));
    row("p95", f -> us(f.p95()));
    row("p99", f -> us(f.p99()));
    String frames = whole(result.plan().frames());
    row("worst of " + frames + " (median over replays)", f -> us(f.worst()));
    row("worst of all", f -> us(f.worstOfAll()));
    int cold = Math.min(Figures.COLD_FRAMES, result.plan().frames());
    row("cold start, first %d frames: mean".formatted(cold), f -> us(f.coldMean()));
    row("cold start, first %d frames: worst".formatted(cold), f -> us(f.coldWorst()));
    line("");
  }

  private void budget() {
    row("frames per second", f -> whole(Math.round(f.fps())), us(Budget.PUBLISHED_FPS));
    row(
        "share of the 16.67 ms budget",
        f -> percent(f.shareOfBudget()),
        percent(Budget.PUBLISHED_MICROS / Budget.MICROS));
    row(
        "frames over budget, of " + whole(result.figures(Methods.CAROM).samples()),
        f -> whole(f.framesOverBudget()));
    line("");
  }

  private void work() {
    int frames = result.plan().frames();
    boolean collide = PlainScene.collides(result.plan().scene());
    String impacts =
        collide ? "impacts with lines, pegs and circles" : "impacts with lines and pegs";
    row(impacts, f -> whole(f.counts().impacts()));
    row("impacts with walls", f -> whole(f.counts().wallImpacts()));
    row("square roots per frame", f -> us((double) f.counts().squareRoots() / frames));
    row("bytes allocated per frame", f -> us(f.bytesPerFrame()));
    line("");
  }

  private void foot() {
    line(
        "Times include two time stamps a frame; an empty pair takes %.0f ns. Walls cost their time",
        result.figures(Methods.CAROM).emptyPairNanos());
    line("but are not counted as lines. Square roots are those of times of impact, as counted by");
    line("each method. Published: 100 circles and 100 lines, Java 6, Core 2 Duo.");
  }

  private void row(String label, Function<Figures, String> cell, String... published) {
    text.append(pad(label, -LABEL));
    for (Figures figures : result.figures()) {
      text.append(pad(cell.apply(figures), COLUMN));
    }
    for (String cellOfPublished : published) {
      text.append(pad(cellOfPublished, COLUMN));
    }
    text.append('\n');
  }

  private void line(String format, Object... values) {
    text.append(String.format(Locale.ROOT, format, values).stripTrailing()).append('\n');
  }

  private static String pad(String cell, int width) {
    return String.format(Locale.ROOT, "%" + width + "s", cell);
  }

  private static String whole(long value) {
    return String.format(Locale.ROOT, "%,d", value);
  }

  /** Three places are enough below a thousand, none above. */
  private static String us(double value) {
    if (value == 0 || value >= 1000) {
      return whole(Math.round(value));
    }
    return String.format(Locale.ROOT, value < 10 ? "%.2f" : "%.1f", value);
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, share < 0.1 ? "%.4f %%" : "%.0f %%", 100 * share);
  }
}
