// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * A run of a world: all its impacts in order, and how its circles move at the end. Two runs are
 * equal if they are so to the bit: records compare doubles by their bits.
 */
public record Run(List<Impact> impacts, List<State> end) {

  /** Where a circle is, and its velocity. */
  public record State(double x, double y, double vx, double vy) {}

  /** Advances a world to each of the given times in turn. */
  public static Run advance(World world, double... times) {
    List<Impact> impacts = new ArrayList<>();
    for (double time : times) {
      world.advanceTo(time);
      impacts.addAll(rows(world.impacts()));
    }
    return new Run(impacts, states(world));
  }

  /** Steps a world a number of times. */
  public static Run step(World world, double dt, int count) {
    List<Impact> impacts = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      world.step(dt);
      impacts.addAll(rows(world.impacts()));
    }
    return new Run(impacts, states(world));
  }

  /** The usual budget of a world without circles. */
  public static final long WORK = 2_000_000;

  /**
   * The budget that lets each circle of a world make so many impacts of its own, if they ignore
   * each other, and all together 2,000 times as many besides.
   */
  public static long work(World world, int ofEach) {
    return (WORK / 1_000 + world.count(Kind.CIRCLE)) * ofEach;
  }

  /** Advances a world to a time in as many calls as that takes, and returns all impacts. */
  public static List<Impact> finish(World world, double t, long work) {
    List<Impact> impacts = new ArrayList<>();
    boolean complete;
    do {
      complete = world.advanceTo(t, work);
      impacts.addAll(rows(world.impacts()));
    } while (!complete);
    return impacts;
  }

  /** The rows of a log. */
  public static List<Impact> rows(ImpactLog log) {
    List<Impact> rows = new ArrayList<>();
    log.forEach(rows::add);
    return rows;
  }

  /** The states of all circles now. */
  public static List<State> states(World world) {
    List<State> states = new ArrayList<>();
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      states.add(new State(world.x(i), world.y(i), world.vx(i), world.vy(i)));
    }
    return states;
  }

  /** This run's impacts of one circle. */
  public List<Impact> of(int circle) {
    return impacts.stream().filter(row -> row.circle() == circle).toList();
  }

  /** The impacts, each changed. */
  public List<Impact> map(UnaryOperator<Impact> change) {
    return impacts.stream().map(change).toList();
  }
}
