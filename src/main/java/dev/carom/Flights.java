// SPDX-License-Identifier: Apache-2.0
package dev.carom;

/**
 * The flights of circles that ignore each other. Each circle is alone, so each is advanced to the
 * end of a step at once, without a queue; one comparison tells that nothing happens to it in a
 * step.
 */
final class Flights {

  // Doubles of one circle in state, the hot ones together.
  private static final int X = 0;
  private static final int Y = 1;
  private static final int VX = 2;
  private static final int VY = 3;
  private static final int T = 4;
  private static final int TL = 5;
  private static final int CLEARED = 6;
  private static final int RADIUS = 7;
  private static final int RESTITUTION = 8;
  private static final int ANCHOR_X = 9;
  private static final int ANCHOR_Y = 10;
  private static final int STATE = 11;

  // Ints of one circle in codes.
  private static final int LAST = 0;
  private static final int NEXT = 1;
  private static final int CONTACT = 2;
  private static final int REACH = 3;
  private static final int STUCK = 4;
  private static final int CODES = 5;

  /** Circles that a step may advance before the journal grows. */
  private static final int JOURNAL = 1024;

  private final int count;
  private final double[] state;
  private final int[] codes;

  /** When a circle needs attention: its next impact, or the end of what is known ahead of it. */
  private final double[] due;

  /** The grid of each circle's class of radius, null where none is used. */
  private final Grid[] grid;

  private final Model model;
  private final BroadSearch search;
  private final Response response;
  private final ImpactLog log;
  private final Mover mover = new Mover();

  /** Of stuck circles; null until there is one. */
  private Jam[] jams;

  private final Journal journal;
  private boolean unfinished;

  Flights(Scene scene, Machinery machinery, ImpactLog log) {
    this.log = log;
    Obstacles obstacles = Obstacles.of(scene);
    Grids grids = new Grids(scene, obstacles, machinery);
    model = grids.model();
    count = scene.circleCount();
    state = new double[count * STATE];
    codes = new int[count * CODES];
    due = new double[count];
    grid = new Grid[count];
    journal = new Journal(Math.min(count, JOURNAL), STATE, CODES);
    search = new BroadSearch(obstacles);
    response = new Response(obstacles, 1_000 + 10 * count);
    for (int i = 0; i < count; i++) {
      Circle circle = scene.circle(i);
      Vec2 v = scene.velocity(i);
      grid[i] = grids.of(circle.radius());
      mover.start(
          i, circle.x(), circle.y(), circle.radius(), v.x(), v.y(), scene.circleRestitution(i));
      search.extend(mover, grid[i], 0);
      store(i);
    }
  }

  int count() {
    return count;
  }

  Model model() {
    return model;
  }

  /**
   * Advances all circles to the given time, or, if one of them makes as many impacts as allowed
   * before, to the time of the last of these.
   *
   * @return the time reached
   */
  double advance(double end, int allowance) {
    journal.clear();
    unfinished = false;
    double reached = end;
    double goal;
    do {
      goal = reached;
      reached = pass(goal, allowance);
      if (reached < goal) {
        journal.restore(due, jams, state, codes);
        log.clear();
      }
    } while (reached < goal);
    return reached;
  }

  /** Whether a circle's allowance was spent in the last {@link #advance}. */
  boolean unfinished() {
    return unfinished;
  }

  private double pass(double end, int allowance) {
    for (int i = 0; i < count; i++) {
      if (due[i] <= end) {
        journal.save(i, due[i], jams == null ? null : jams[i], state, codes);
        load(i);
        boolean spent = fly(grid[i], end, allowance);
        store(i);
        if (spent) {
          unfinished = true;
          if (mover.t < end) {
            return mover.t;
          }
        }
      }
    }
    return end;
  }

  /** Resolves the mover's impacts until the given time; tells whether the allowance was spent. */
  private boolean fly(Grid grid, double end, int allowance) {
    Mover m = mover;
    int impacts = 0;
    do {
      if (m.next == Mover.NOTHING) {
        search.extend(m, grid, end - m.t);
      } else {
        if (impacts == allowance) {
          return true;
        }
        response.resolve(m, log);
        impacts++;
      }
    } while (m.due() <= end);
    return false;
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

  private void load(int i) {
    Mover m = mover;
    int k = i * STATE;
    m.id = i;
    m.x = state[k + X];
    m.y = state[k + Y];
    m.vx = state[k + VX];
    m.vy = state[k + VY];
    m.t = state[k + T];
    m.tl = state[k + TL];
    m.cleared = state[k + CLEARED];
    m.radius = state[k + RADIUS];
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

  private void store(int i) {
    Mover m = mover;
    int k = i * STATE;
    state[k + X] = m.x;
    state[k + Y] = m.y;
    state[k + VX] = m.vx;
    state[k + VY] = m.vy;
    state[k + T] = m.t;
    state[k + TL] = m.tl;
    state[k + CLEARED] = m.cleared;
    state[k + RADIUS] = m.radius;
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
    if (m.jam != null && jams == null) {
      jams = new Jam[count];
    }
    if (jams != null) {
      jams[i] = m.jam;
    }
  }
}
