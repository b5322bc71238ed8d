// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.response;

import dev.carom.internal.exact.ExactBudget;
import java.util.Arrays;

/**
 * The velocities of circles after all their contacts act at once, without bounce. Among the
 * velocities with which no contact approaches, they are the nearest to those before, weighted by
 * mass: the inelastic shock of J. J. Moreau (Unilateral contact and dry friction in finite freedom
 * dynamics, 1988).
 *
 * <p>With the separations u.n of all contacts as the gradient, the impulses j are the minimum of a
 * quadratic function under j >= 0. It is found by conjugate gradients on the contacts that push,
 * with projections where that set changes: MPRGP of Z. Dostal (Optimal Quadratic Programming
 * Algorithms, 2009, section 5.8). Impulses are scaled by the root of 1/m1 + 1/m2, so that the
 * matrix has ones on its diagonal, whatever the masses are.
 */
public final class InelasticShock {

  /** Stands for an obstacle in place of the second circle of a contact. */
  static final int OBSTACLE = -1;

  /** The largest approach in a result: 8 ulps of the largest speed, which is scaled to 1..2. */
  private static final double TOLERANCE = 0x1p-49;

  /** An approach so small that the relaxation ends at once. */
  private static final double LEAST = 0x1p-60;

  /** A curvature that is mere rounding. */
  private static final double FLAT = 0x1p-70;

  /** An impulse that changes the approach by less than this counts as none. */
  private static final double NOTHING = 0x1p-48;

  /** The relaxation gives up after so many steps, and so many more for each contact. */
  private static final int STEPS = 100;

  private static final int STEPS_EACH = 10;

  /** Velocities, in units of 2^exponent. */
  private final double[] vx;

  private final double[] vy;

  /** 1 / mass of each circle; 0 for an infinite mass. */
  private final double[] inverseMass;

  private int exponent;

  private int contacts;
  private final int[] first;
  private final int[] second;
  private final double[] nx;
  private final double[] ny;

  /** The root of 1/m1 + 1/m2 for each contact, and the impulse times this root. */
  private final double[] scale;

  private final double[] impulse;

  /** Separations divided by the scale. */
  private final double[] gradient;

  /** The direction of the next step, and the change of the separations along it. */
  private final double[] direction;

  private final double[] response;

  /** Whether impulses could grow without end and would not end the approach. */
  private boolean unbounded;

  /** Velocities along the direction. */
  private final double[] ux;

  private final double[] uy;

  InelasticShock(int circles, int mostContacts) {
    vx = new double[circles];
    vy = new double[circles];
    inverseMass = new double[circles];
    first = new int[mostContacts];
    second = new int[mostContacts];
    nx = new double[mostContacts];
    ny = new double[mostContacts];
    impulse = new double[mostContacts];
    scale = new double[mostContacts];
    gradient = new double[mostContacts];
    direction = new double[mostContacts];
    response = new double[mostContacts];
    ux = new double[circles];
    uy = new double[circles];
  }

  /** Sets the velocity and the mass of circle i; the mass may be infinite. */
  void setCircle(int i, double vx, double vy, double mass) {
    this.vx[i] = vx;
    this.vy[i] = vy;
    inverseMass[i] = 1 / mass;
  }

  /**
   * Adds a contact of circle a with circle b or an {@link #OBSTACLE}.
   *
   * @param nx the x component of the unit normal, which points to a
   * @param ny the y component of the unit normal
   */
  void addContact(int a, int b, double nx, double ny) {
    first[contacts] = a;
    second[contacts] = b;
    this.nx[contacts] = nx;
    this.ny[contacts] = ny;
    contacts++;
  }

  /**
   * Finds the velocities. All circles and contacts must have been set.
   *
   * @return false if some contact still approaches after the allowed steps
   */
  boolean resolve() {
    scale();
    double shortStep = 1 / bound();
    boolean resolved = false;
    int steps = STEPS + STEPS_EACH * contacts;
    double residual = differentiate();
    follow();
    for (int step = 0; step < steps && residual > LEAST && !unbounded; step++) {
      if (residual <= TOLERANCE && !resolved) {
        resolved = true;
        steps = step + step / 4 + 4; // what comes to rest, does so to the last place
      }
      residual = relax(shortStep);
    }
    dropNoise();
    return resolved || residual <= TOLERANCE;
  }

  /** One step of the relaxation; returns the largest violation. */
  private double relax(double shortStep) {
    ExactBudget.addRelaxations(2 * contacts);
    if (isProportional(shortStep)) {
      descend(shortStep);
    } else {
      release();
    }
    return differentiate();
  }

  /** A bound of the largest eigenvalue of the scaled matrix: the most contacts of two partners. */
  private double bound() {
    int[] touches = new int[vx.length];
    for (int k = 0; k < contacts; k++) {
      scale[k] = Math.sqrt(weight(k));
      touches[first[k]]++;
      if (second[k] != OBSTACLE) {
        touches[second[k]]++;
      }
    }
    int most = 1;
    for (int k = 0; k < contacts; k++) {
      most = Math.max(most, touches[first[k]] + (second[k] == OBSTACLE ? 0 : touches[second[k]]));
    }
    return most;
  }

  /** Computes the gradient, and returns the largest violation among the contacts. */
  private double differentiate() {
    double residual = 0;
    for (int k = 0; k < contacts; k++) {
      double separation = separation(k);
      gradient[k] = scale[k] == 0 ? 0 : separation / scale[k];
      boolean acts = impulse[k] > 0 || separation < 0;
      residual = Math.max(residual, acts ? Math.abs(separation) : 0);
    }
    return residual;
  }

  /** Whether the pushing contacts are further from their minimum than the others from pushing. */
  private boolean isProportional(double shortStep) {
    double free = 0;
    double chopped = 0;
    for (int k = 0; k < contacts; k++) {
      if (impulse[k] > 0) {
        free += gradient[k] * Math.min(impulse[k] / shortStep, gradient[k]);
      } else if (gradient[k] < 0) {
        chopped += gradient[k] * gradient[k];
      }
    }
    return chopped <= free;
  }

  /** Sets the direction to the gradient of the pushing contacts. */
  private void follow() {
    for (int k = 0; k < contacts; k++) {
      direction[k] = impulse[k] > 0 ? gradient[k] : 0;
    }
  }

  /**
   * A step of conjugate gradients. If it would make an impulse negative, it ends there, and a short
   * step along the gradient follows.
   */
  private void descend(double shortStep) {
    double curvature = respond();
    double slope = dot(gradient, direction);
    double feasible = Double.POSITIVE_INFINITY;
    for (int k = 0; k < contacts; k++) {
      if (direction[k] > 0) {
        feasible = Math.min(feasible, impulse[k] / direction[k]);
      }
    }
    unbounded = feasible == Double.POSITIVE_INFINITY && isFlat(curvature);
    if (unbounded) {
      return;
    }
    if (slope <= feasible * curvature) {
      move(slope / curvature);
      differentiate();
      double share = 0;
      for (int k = 0; k < contacts; k++) {
        share += impulse[k] > 0 ? gradient[k] * response[k] : 0;
      }
      double part = share / curvature;
      for (int k = 0; k < contacts; k++) {
        direction[k] = (impulse[k] > 0 ? gradient[k] : 0) - part * direction[k];
      }
    } else {
      move(feasible);
      differentiate();
      follow();
      move(shortStep);
      differentiate();
      follow();
    }
  }

  /** A step of the contacts that approach and do not push yet. */
  private void release() {
    for (int k = 0; k < contacts; k++) {
      direction[k] = impulse[k] > 0 ? 0 : Math.min(0, gradient[k]);
    }
    double curvature = respond();
    unbounded = isFlat(curvature);
    if (!unbounded) {
      move(dot(gradient, direction) / curvature);
    }
    differentiate();
    follow();
  }

  /** Whether impulses along the direction cancel each other and change no velocity. */
  private boolean isFlat(double curvature) {
    return curvature <= FLAT * dot(direction, direction);
  }

  /** Computes the change of the separations along the direction; returns its curvature. */
  private double respond() {
    Arrays.fill(ux, 0);
    Arrays.fill(uy, 0);
    for (int k = 0; k < contacts; k++) {
      if (direction[k] != 0) {
        double push = direction[k] / scale[k];
        ux[first[k]] += push * inverseMass[first[k]] * nx[k];
        uy[first[k]] += push * inverseMass[first[k]] * ny[k];
        if (second[k] != OBSTACLE) {
          ux[second[k]] -= push * inverseMass[second[k]] * nx[k];
          uy[second[k]] -= push * inverseMass[second[k]] * ny[k];
        }
      }
    }
    for (int k = 0; k < contacts; k++) {
      int b = second[k];
      double x = ux[first[k]] - (b == OBSTACLE ? 0 : ux[b]);
      double y = uy[first[k]] - (b == OBSTACLE ? 0 : uy[b]);
      response[k] = scale[k] == 0 ? 0 : (x * nx[k] + y * ny[k]) / scale[k];
    }
    return dot(direction, response);
  }

  private double dot(double[] a, double[] b) {
    double sum = 0;
    for (int k = 0; k < contacts; k++) {
      sum += a[k] * b[k];
    }
    return sum;
  }

  /** Steps against the direction; impulses that would be negative become 0. */
  private void move(double length) {
    for (int k = 0; k < contacts; k++) {
      if (direction[k] != 0) {
        double added = Math.max(-impulse[k], -length * direction[k]);
        impulse[k] += added;
        push(k, added / scale[k]);
      }
    }
  }

  /** Scales the velocities so that the largest component is in 1..2: nothing can overflow. */
  private void scale() {
    double largest = 0;
    for (int i = 0; i < vx.length; i++) {
      largest = Math.max(largest, Math.max(Math.abs(vx[i]), Math.abs(vy[i])));
    }
    exponent = largest == 0 ? 0 : Math.getExponent(largest);
    for (int i = 0; i < vx.length; i++) {
      vx[i] = Math.scalb(vx[i], -exponent);
      vy[i] = Math.scalb(vy[i], -exponent);
    }
  }

  /** 1/m1 + 1/m2 of a contact. */
  private double weight(int k) {
    return inverseMass[first[k]] + (second[k] == OBSTACLE ? 0 : inverseMass[second[k]]);
  }

  private void push(int k, double impulse) {
    int a = first[k];
    vx[a] += impulse * inverseMass[a] * nx[k];
    vy[a] += impulse * inverseMass[a] * ny[k];
    int b = second[k];
    if (b != OBSTACLE) {
      vx[b] -= impulse * inverseMass[b] * nx[k];
      vy[b] -= impulse * inverseMass[b] * ny[k];
    }
  }

  /** The speed at which the two sides of a contact part, in units of 2^exponent. */
  private double separation(int k) {
    int a = first[k];
    int b = second[k];
    double ux = vx[a] - (b == OBSTACLE ? 0 : vx[b]);
    double uy = vy[a] - (b == OBSTACLE ? 0 : vy[b]);
    return ux * nx[k] + uy * ny[k];
  }

  /** Sets velocities to 0 that are mere rounding beside the largest one. */
  private void dropNoise() {
    for (int i = 0; i < vx.length; i++) {
      if (inverseMass[i] > 0 && Math.abs(vx[i]) + Math.abs(vy[i]) < NOTHING) {
        vx[i] = 0;
        vy[i] = 0;
      }
    }
  }

  /** The largest component of the velocities before the shock, to within a factor of 2. */
  double speed() {
    return Math.scalb(1.0, exponent);
  }

  double vx(int i) {
    return Math.scalb(vx[i], exponent);
  }

  double vy(int i) {
    return Math.scalb(vy[i], exponent);
  }

  /** Whether contact k gave an impulse that is more than rounding. */
  boolean acted(int k) {
    return impulse[k] * scale[k] > NOTHING;
  }

  /** Whether the two sides of contact k differ in velocity, but part by no more than rounding. */
  boolean isFaint(int k) {
    int a = first[k];
    int b = second[k];
    boolean moves = vx[a] != (b == OBSTACLE ? 0 : vx[b]) || vy[a] != (b == OBSTACLE ? 0 : vy[b]);
    return moves && Math.abs(separation(k)) <= NOTHING;
  }
}
