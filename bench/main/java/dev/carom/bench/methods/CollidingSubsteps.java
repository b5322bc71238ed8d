// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.methods;

import dev.carom.Kind;
import dev.carom.Scene;

/**
 * {@link Substeps} for circles that collide: after each part of a frame, two that overlap and come
 * nearer exchange the impulse of their impact, and every overlap is undone by moving both out along
 * the line of their centres, the lighter one further.
 */
final class CollidingSubsteps extends Substeps {

  /** 1 / mass, 0 if that is infinite. */
  private final double[] inverseMass;

  CollidingSubsteps(Scene scene, int k) {
    super(scene, k);
    inverseMass = new double[circles];
    for (int i = 0; i < circles; i++) {
      inverseMass[i] = 1 / scene.traits(Kind.CIRCLE, i).mass();
    }
  }

  @Override
  public void frame() {
    impacts = 0;
    wallImpacts = 0;
    squareRoots = 0;
    for (int step = 0; step < k; step++) {
      for (int i = 0; i < circles; i++) {
        move(i, 1.0 / k);
      }
      for (int i = 0; i < circles; i++) {
        for (int j = i + 1; j < circles; j++) {
          part(i, j);
        }
      }
    }
  }

  private void part(int i, int j) {
    double dx = x[j] - x[i];
    double dy = y[j] - y[i];
    double dd = dx * dx + dy * dy;
    double reach = radius[i] + radius[j];
    double weight = inverseMass[i] + inverseMass[j];
    if (dd >= reach * reach || dd == 0 || weight == 0) {
      return;
    }
    double approach = (vx[j] - vx[i]) * dx + (vy[j] - vy[i]) * dy;
    if (approach < 0) {
      // J = (1+e) (u.d) / ((w1+w2) (d.d))
      double impulse = (1 + restitution[i] * restitution[j]) * approach / (weight * dd);
      vx[i] += inverseMass[i] * impulse * dx;
      vy[i] += inverseMass[i] * impulse * dy;
      vx[j] -= inverseMass[j] * impulse * dx;
      vy[j] -= inverseMass[j] * impulse * dy;
      impacts++;
    }
    double push = (reach / Math.sqrt(dd) - 1) / weight;
    squareRoots++;
    x[i] -= inverseMass[i] * push * dx;
    y[i] -= inverseMass[i] * push * dy;
    x[j] += inverseMass[j] * push * dx;
    y[j] += inverseMass[j] * push * dy;
  }

  @Override
  public long pairTests() {
    return super.pairTests() + (long) k * circles * (circles - 1) / 2;
  }
}
