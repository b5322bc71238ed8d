// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.World;

/**
 * This library, used as a game would: one {@code step(1)} a frame. Its impacts are read from the
 * log of the last step. Its square roots, pair tests and fallbacks are those that the library
 * counts, if the process has it count ({@link RungCounts#enable}); where frames are timed it does
 * not.
 */
final class CaromMethod implements Method {

  private final World world;
  private RungCounts before = RungCounts.soFar();

  CaromMethod(Scene scene) {
    world = new World(scene);
  }

  @Override
  public void frame() {
    before = RungCounts.soFar();
    world.step(1);
  }

  @Override
  public int impacts() {
    return world.impacts().size() - wallImpacts();
  }

  @Override
  public int wallImpacts() {
    ImpactLog log = world.impacts();
    int walls = 0;
    for (int row = 0; row < log.size(); row++) {
      walls += log.kind(row) == Kind.WALL ? 1 : 0;
    }
    return walls;
  }

  @Override
  public int squareRoots() {
    return RungCounts.areEnabled() ? Math.toIntExact(lastFrame().roots()) : UNKNOWN;
  }

  @Override
  public double x(int circle) {
    return world.x(circle);
  }

  @Override
  public double y(int circle) {
    return world.y(circle);
  }

  @Override
  public double vx(int circle) {
    return world.vx(circle);
  }

  @Override
  public double vy(int circle) {
    return world.vy(circle);
  }

  @Override
  public long pairTests() {
    return RungCounts.areEnabled() ? lastFrame().pairTests() : UNKNOWN;
  }

  @Override
  public long fallbacks() {
    if (!RungCounts.areEnabled()) {
      return UNKNOWN;
    }
    RungCounts frame = lastFrame();
    return frame.doubtfulDecisions() + frame.exactTimes();
  }

  private RungCounts lastFrame() {
    return RungCounts.now().since(before);
  }
}
