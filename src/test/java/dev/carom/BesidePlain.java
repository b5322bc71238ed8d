// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;

/** A world beside its plain model: both are told the same, and must do the same. */
public final class BesidePlain {

  private final World world;
  private final PlainWorld plain;

  BesidePlain(Scene scene) {
    world = new World(scene);
    plain = new PlainWorld(scene);
  }

  /** One whose circles, at rest so far, begin to move at a late time. */
  public static BesidePlain at(double start, Scene scene) {
    BesidePlain both = new BesidePlain(scene);
    both.advanceTo(start);
    return both;
  }

  public void setVelocity(int id, double vx, double vy) {
    world.setVelocity(id, vx, vy);
    plain.setVelocity(id, vx, vy);
  }

  /** Advances both, and returns the number of impacts, which are the same. */
  public int advanceTo(double end) {
    world.advanceTo(end);
    List<Impact> rows = Run.rows(world.impacts());
    assertThat(rows).isEqualTo(Run.rows(plain.advance(end, rows.size() + 1)));
    return rows.size();
  }
}
