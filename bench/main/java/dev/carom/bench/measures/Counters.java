// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.bench.methods.Method;
import dev.carom.bench.results.Row;
import java.util.List;

/**
 * Work that does not depend on the machine, per frame: pairs of circle and line looked at together,
 * square roots, uses of more precision than a double, impacts. NaN where the method does not tell.
 */
final class Counters {

  private long frames;
  private double pairTests;
  private double roots;
  private double fallbacks;
  private double impacts;
  private double wallImpacts;

  void add(Method method) {
    frames++;
    pairTests += known(method.pairTests());
    roots += known(method.squareRoots());
    fallbacks += known(method.fallbacks());
    impacts += known(method.impacts());
    wallImpacts += known(method.wallImpacts());
  }

  private static double known(long count) {
    return count == Method.UNKNOWN ? Double.NaN : count;
  }

  List<Row> rows(Trial trial) {
    return List.of(
        perFrame(trial, "pair_tests", pairTests),
        perFrame(trial, "roots", roots),
        perFrame(trial, "fallbacks", fallbacks),
        perFrame(trial, "impacts", impacts),
        perFrame(trial, "wall_impacts", wallImpacts));
  }

  private Row perFrame(Trial trial, String metric, double sum) {
    return trial.row(metric, "mean", frames == 0 ? Double.NaN : sum / frames, Trial.ONE, frames);
  }
}
