// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The flights of all circles in flat arrays: each as its start, with what is known ahead of it
 * among the things that stand still. A circle is loaded into the one {@link Mover}, advanced, and
 * stored.
 */
final class Circles {

  // Doubles of one circle in state, the hot ones together.
  static final int X = 0;
  static final int Y = 1;
  static final int VX = 2;
  static final int VY = 3;
  static final int T = 4;
  static final int TL = 5;
  static final int RADIUS = 6;
  static final int CLEARED = 7;
  static final int RESTITUTION = 8;
  static final int ANCHOR_X = 9;
  static final int ANCHOR_Y = 10;
  static final int STATE = 11;

  // Ints of one circle in codes.
  static final int LAST = 0;
  static final int NEXT = 1;
  static final int CONTACT = 2;
  static final int REACH = 3;
  static final int STUCK = 4;
  static final int CODES = 5;

  final int count;
  final double[] state;
  final int[] codes;

  /** When a circle needs attention: its next impact, or the end of what is known ahead of it. */
  final double[] due;

  /** The tails of these times. */
  final double[] dueTails;

  /** Of stuck circles; null until there is one. */
  Jam[] jams;

  final Mover mover = new Mover();

  Circles(int count) {
    this.count = count;
    state = new double[count * STATE];
    codes = new int[count * CODES];
    due = new double[count];
    dueTails = new double[count];
  }

  /** Puts circle i of a scene at the start of its first flight, into the mover only. */
  void start(Scene scene, int i) {
    Circle circle = scene.circle(i);
    Vec2 v = scene.velocity(i);
    mover.start(
        i, circle.x(), circle.y(), circle.radius(), v.x(), v.y(), scene.circleRestitution(i));
  }

  double x(int i, double now) {
    int k = i * STATE;
    return Math.fma(state[k + VX], now - state[k + T] - state[k + TL], state[k + X]);
  }

  double y(int i, double now) {
    int k = i * STATE;
    return Math.fma(state[k + VY], now - state[k + T] - state[k + TL], state[k + Y]);
  }

  double vx(int i) {
    return state[i * STATE + VX];
  }

  double vy(int i) {
    return state[i * STATE + VY];
  }

  double radius(int i) {
    return state[i * STATE + RADIUS];
  }

  Jam jam(int i) {
    return jams == null ? null : jams[i];
  }

  void load(int i) {
    load(i, mover);
  }

  void load(int i, Mover m) {
    int k = i * STATE;
    m.id = i;
    m.flown = 0;
    m.x = state[k + X];
    m.y = state[k + Y];
    m.vx = state[k + VX];
    m.vy = state[k + VY];
    m.t = state[k + T];
    m.tl = state[k + TL];
    m.radius = state[k + RADIUS];
    m.cleared = state[k + CLEARED];
    m.restitution = state[k + RESTITUTION];
    m.anchorX = state[k + ANCHOR_X];
    m.anchorY = state[k + ANCHOR_Y];
    int c = i * CODES;
    m.last = codes[c + LAST];
    m.next = codes[c + NEXT];
    m.contact = codes[c + CONTACT];
    m.reach = codes[c + REACH];
    m.stuck = codes[c + STUCK];
    m.jam = jams == null ? null : jams[i];
  }

  void store(int i) {
    store(i, mover);
  }

  void store(int i, Mover m) {
    int k = i * STATE;
    state[k + X] = m.x;
    state[k + Y] = m.y;
    state[k + VX] = m.vx;
    state[k + VY] = m.vy;
    state[k + T] = m.t;
    state[k + TL] = m.tl;
    state[k + RADIUS] = m.radius;
    state[k + CLEARED] = m.cleared;
    state[k + RESTITUTION] = m.restitution;
    state[k + ANCHOR_X] = m.anchorX;
    state[k + ANCHOR_Y] = m.anchorY;
    int c = i * CODES;
    codes[c + LAST] = m.last;
    codes[c + NEXT] = m.next;
    codes[c + CONTACT] = m.contact;
    codes[c + REACH] = m.reach;
    codes[c + STUCK] = m.stuck;
    due[i] = m.due();
    dueTails[i] = due[i] == Double.POSITIVE_INFINITY ? 0 : m.afterTail(m.cleared, due[i]);
    if (m.jam != null && jams == null) {
      jams = new Jam[count];
    }
    if (jams != null) {
      jams[i] = m.jam;
    }
  }
}
