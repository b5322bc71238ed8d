// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.experiment;

import dev.carom.Scene;
import dev.carom.SceneBuilder;
import java.util.Arrays;

/**
 * A gas of circles of all sizes that collide, in square bounds: radii from 1 to {@code spread}, as
 * many in each octave as in any other (log-uniform), placed at random, the largest first, so that
 * small ones stand between large ones. Velocities are those of a gas of temperature 1. The same
 * numbers give the same bits on every machine, as in {@link Gas}.
 *
 * @param circles how many circles, at least 1
 * @param packing the part of the bounds that circles cover, more than 0 and at most 0.4: beyond,
 *     places at random soon run out
 * @param spread the largest radius, from 1 to 1e6
 * @param heavy whether a circle's mass is its radius squared; else all masses are 1
 */
public record MixedGas(int circles, double packing, double spread, boolean heavy, long seed) {

  private static final int TRIES = 100_000;

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if a number is outside of its range
   */
  public MixedGas {
    Gas.check(circles >= 1, "circles", circles, "at least 1");
    Gas.check(packing > 0 && packing <= 0.4, "packing", packing, "more than 0 and at most 0.4");
    Gas.check(spread >= 1 && spread <= 1e6, "spread", spread, "from 1 to 1e6");
  }

  /**
   * Generates the scene.
   *
   * @return the scene; its circles collide, the largest is circle 0
   * @throws CannotPlaceException if a circle finds no room
   */
  public Scene scene() throws CannotPlaceException {
    SplitMix random = new SplitMix(seed);
    double[] radii = radii(random);
    double squares = Arrays.stream(radii).map(r -> r * r).sum();
    double side = StrictMath.sqrt(StrictMath.PI * squares / packing);
    Room room = new Room(side, radii);
    SceneBuilder builder = Scene.builder().bounds(0, 0, side, side).collide(true);
    for (int i = 0; i < circles; i++) {
      double r = radii[i];
      room.place(random, i);
      double mass = heavy ? r * r : 1;
      double speed = Gas.speed(random, mass);
      double angle = random.between(0, 2 * StrictMath.PI);
      double vx = speed * StrictMath.cos(angle);
      double vy = speed * StrictMath.sin(angle);
      builder.circle(room.x[i], room.y[i], r, vx, vy).mass(mass);
    }
    return builder.build();
  }

  /** The largest first. */
  private double[] radii(SplitMix random) {
    double[] logarithms = new double[circles];
    for (int i = 0; i < circles; i++) {
      logarithms[i] = -random.between(0, StrictMath.log(spread));
    }
    Arrays.sort(logarithms);
    return Arrays.stream(logarithms).map(l -> StrictMath.max(1, StrictMath.exp(-l))).toArray();
  }

  /** The circles placed so far. Each is listed in all cells that it meets. */
  private static final class Room {
    private final double side;
    private final double[] radii;
    private final double[] x;
    private final double[] y;
    private final int columns;
    private final int[][] cells;

    Room(double side, double[] radii) {
      this.side = side;
      this.radii = radii;
      x = new double[radii.length];
      y = new double[radii.length];
      columns = Math.max(1, (int) Math.sqrt(4.0 * radii.length));
      cells = new int[columns * columns][0];
    }

    private int column(double at) {
      return Math.max(0, Math.min((int) (at / side * columns), columns - 1));
    }

    void place(SplitMix random, int i) throws CannotPlaceException {
      double r = radii[i];
      for (int tries = 0; tries < TRIES && 2 * r <= side; tries++) {
        x[i] = random.between(r, side - r);
        y[i] = random.between(r, side - r);
        if (isFree(i)) {
          list(i);
          return;
        }
      }
      throw new CannotPlaceException(
          ("no room for circle %d of %d: its radius is %s, the side of the bounds %s;"
                  + " ask for less packing")
              .formatted(i + 1, radii.length, r, side));
    }

    private boolean isFree(int i) {
      double r = radii[i];
      for (int row = column(y[i] - r); row <= column(y[i] + r); row++) {
        for (int column = column(x[i] - r); column <= column(x[i] + r); column++) {
          for (int j : cells[row * columns + column]) {
            double apart = r + radii[j];
            double dx = x[i] - x[j];
            double dy = y[i] - y[j];
            if (dx * dx + dy * dy <= apart * apart) {
              return false;
            }
          }
        }
      }
      return true;
    }

    private void list(int i) {
      double r = radii[i];
      for (int row = column(y[i] - r); row <= column(y[i] + r); row++) {
        for (int column = column(x[i] - r); column <= column(x[i] + r); column++) {
          int cell = row * columns + column;
          cells[cell] = Arrays.copyOf(cells[cell], cells[cell].length + 1);
          cells[cell][cells[cell].length - 1] = i;
        }
      }
    }
  }
}
