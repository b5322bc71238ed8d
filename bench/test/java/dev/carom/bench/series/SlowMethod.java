// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.series;

import dev.carom.bench.methods.Method;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** A method that waits before each frame. */
record SlowMethod(Method method, int millis) implements Method {

  @Override
  public void frame() {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    while (System.nanoTime() < end) {
      LockSupport.parkNanos(end - System.nanoTime());
    }
    method.frame();
  }

  @Override
  public int impacts() {
    return method.impacts();
  }

  @Override
  public int wallImpacts() {
    return method.wallImpacts();
  }

  @Override
  public int squareRoots() {
    return method.squareRoots();
  }

  @Override
  public double x(int circle) {
    return method.x(circle);
  }

  @Override
  public double y(int circle) {
    return method.y(circle);
  }

  @Override
  public double vx(int circle) {
    return method.vx(circle);
  }

  @Override
  public double vy(int circle) {
    return method.vy(circle);
  }

  @Override
  public long pairTests() {
    return method.pairTests();
  }
}
