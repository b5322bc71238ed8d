// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.io.Console;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** A bar on the terminal during long work; nothing at all where the output is piped. */
final class Progress implements AutoCloseable {

  private final ProgressBar bar;

  private Progress(ProgressBar bar) {
    this.bar = bar;
  }

  static Progress start(String task, int steps) {
    return new Progress(isTerminal() ? builder(task, steps).build() : null);
  }

  /** A bar without a remaining time of its own: the messages of its steps tell it. */
  static Progress withoutTime(String task, int steps) {
    return new Progress(isTerminal() ? builder(task, steps).hideEta().build() : null);
  }

  private static ProgressBarBuilder builder(String task, int steps) {
    return new ProgressBarBuilder()
        .setTaskName(task)
        .setInitialMax(steps)
        .setStyle(ProgressBarStyle.ASCII)
        .clearDisplayOnFinish();
  }

  /** From JDK 22 on there is a console without a terminal, too, and it can be asked. */
  @SuppressWarnings("SystemConsoleNull") // it is, before JDK 22
  private static boolean isTerminal() {
    Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      return (boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (ReflectiveOperationException e) {
      return true;
    }
  }

  /** Whether there is a bar to be seen. */
  boolean isShown() {
    return bar != null;
  }

  /** A step, and what it was. */
  void step(String what) {
    if (bar != null) {
      bar.setExtraMessage(what);
      bar.step();
    }
  }

  void step() {
    if (bar != null) {
      bar.step();
    }
  }

  @Override
  public void close() {
    if (bar != null) {
      bar.close();
    }
  }
}
