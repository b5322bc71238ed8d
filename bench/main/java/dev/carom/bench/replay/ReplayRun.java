// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.methods.Contender;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/**
 * Carries out a {@link ReplayPlan}. Each fork is a JMH run of its own, and the contenders take
 * turns, in each round in another order: what the machine does besides falls on all alike.
 */
public final class ReplayRun implements AutoCloseable {

  private final ReplayPlan plan;
  private final Exchange exchange;
  private boolean failed;

  private ReplayRun(ReplayPlan plan, Exchange exchange) {
    this.plan = plan;
    this.exchange = exchange;
  }

  /**
   * Measures all of a plan.
   *
   * @param progress called after each of the plan's steps
   * @return the figures, and the frame times behind them
   * @throws IOException if the temporary folder cannot be used
   * @throws RunnerException if a fork fails; the message names the log that tells why
   */
  public static ReplayResult run(ReplayPlan plan, Runnable progress)
      throws IOException, RunnerException {
    try (ReplayRun run = open(plan)) {
      return new ReplayResult(plan, run.forks(progress), Machine.current());
    }
  }

  /**
   * Prepares to measure fork by fork.
   *
   * @return the run, to be closed
   * @throws IOException if the temporary folder cannot be made
   */
  public static ReplayRun open(ReplayPlan plan) throws IOException {
    return new ReplayRun(plan, Exchange.create(plan.scene(), plan.others()));
  }

  /**
   * The order in which contenders take their turns in a round.
   *
   * @param round its number
   * @return the same, shuffled; the same shuffle for the same number
   */
  public static List<Contender> shuffled(List<Contender> contenders, int round) {
    List<Contender> order = new ArrayList<>(contenders);
    Collections.shuffle(order, new Random(round));
    return order;
  }

  private Map<Contender, List<Samples>> forks(Runnable progress)
      throws IOException, RunnerException {
    Map<Contender, List<Samples>> samples = new LinkedHashMap<>();
    for (int round = 0; round < plan.forks(); round++) {
      for (Contender contender : shuffled(plan.contenders(), round)) {
        samples.computeIfAbsent(contender, none -> new ArrayList<>()).add(fork(contender, round));
        progress.run();
      }
    }
    return samples;
  }

  /**
   * Measures one contender in a fresh virtual machine.
   *
   * @param contender who replays
   * @param fork the number of the fork, not used before with this contender
   * @return the frame times
   * @throws IOException if the temporary folder cannot be used
   * @throws RunnerException if the fork fails; the message names the log that tells why
   */
  public Samples fork(Contender contender, int fork) throws IOException, RunnerException {
    try {
      new Runner(options(contender, fork)).run();
    } catch (RunnerException e) {
      failed = true;
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("no reason given");
      throw new RunnerException(
          "a replay of %s failed: %s (its log: %s)"
              .formatted(contender.id(), reason, exchange.log(contender, fork)),
          e);
    }
    return Samples.read(exchange.samples(contender, fork));
  }

  private Options options(Contender contender, int fork) {
    return new OptionsBuilder()
        .include(ReplayBenchmark.class.getName())
        .param("method", contender.id())
        .param("frames", Integer.toString(plan.frames()))
        .param("warmUpMillis", Integer.toString(plan.warmUpMillis()))
        .param("folder", exchange.folder().toString())
        .param("fork", Integer.toString(fork))
        .measurementIterations(plan.replays())
        .forks(1)
        .shouldFailOnError(true)
        .output(exchange.log(contender, fork).toString())
        .build();
  }

  /**
   * Deletes the temporary folder, unless a fork failed: then its log is left.
   *
   * @throws IOException if it cannot be deleted
   */
  @Override
  public void close() throws IOException {
    if (!failed) {
      exchange.delete();
    }
  }
}
