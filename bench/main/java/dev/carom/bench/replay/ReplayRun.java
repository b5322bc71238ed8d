// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.bench.methods.Methods;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/**
 * Carries out a {@link ReplayPlan}. Each fork is a JMH run of its own, and the methods take turns,
 * each round in the reverse order of the one before: what the machine does besides falls on all
 * alike.
 */
public final class ReplayRun {

  private final ReplayPlan plan;
  private final Exchange exchange;

  private ReplayRun(ReplayPlan plan, Exchange exchange) {
    this.plan = plan;
    this.exchange = exchange;
  }

  /**
   * Measures.
   *
   * @param plan what to replay
   * @param progress called after each of the plan's steps
   * @return the figures, and the frame times behind them
   * @throws IOException if the temporary folder cannot be used
   * @throws RunnerException if a fork fails; the message names the log that tells why
   */
  public static ReplayResult run(ReplayPlan plan, Runnable progress)
      throws IOException, RunnerException {
    Exchange exchange = Exchange.create(plan.scene(), plan.others());
    Map<Methods, List<Samples>> samples = new ReplayRun(plan, exchange).runForks(progress);
    exchange.delete();
    return new ReplayResult(plan, samples, Machine.current());
  }

  private Map<Methods, List<Samples>> runForks(Runnable progress)
      throws IOException, RunnerException {
    Map<Methods, List<Samples>> samples = new EnumMap<>(Methods.class);
    List<Methods> order = new ArrayList<>(List.of(Methods.values()));
    for (int fork = 0; fork < plan.forks(); fork++) {
      for (Methods method : order) {
        samples.computeIfAbsent(method, none -> new ArrayList<>()).add(runFork(method, fork));
        progress.run();
      }
      Collections.reverse(order);
    }
    return samples;
  }

  private Samples runFork(Methods method, int fork) throws IOException, RunnerException {
    try {
      new Runner(options(method, fork)).run();
    } catch (RunnerException e) {
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("no reason given");
      throw new RunnerException(
          "a replay of %s failed: %s (its log: %s)"
              .formatted(method.label(), reason, exchange.log(method, fork)),
          e);
    }
    return Samples.read(exchange.samples(method, fork));
  }

  private Options options(Methods method, int fork) {
    return new OptionsBuilder()
        .include(ReplayBenchmark.class.getName())
        .param("method", method.label())
        .param("frames", Integer.toString(plan.frames()))
        .param("warmUpMillis", Integer.toString(plan.warmUpMillis()))
        .param("folder", exchange.folder().toString())
        .param("fork", Integer.toString(fork))
        .forks(1)
        .shouldFailOnError(true)
        .output(exchange.log(method, fork).toString())
        .build();
  }
}
