// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Plays a world under gravity in frames, and compares all that it does with the limits of the law
 * of contact: no call is unfinished, nothing overlaps, and energy does not grow. It stops at the
 * first unfinished call. No circle may be removed while it plays.
 */
public final class ContactRun {

  /** So many radii may a circle be inside another thing, and so many ulps of a coordinate. */
  private static final double OVERLAP = 1e-9;

  private static final int ULPS = 16;

  /** So many m g R a circle may the energy rise above its least so far. */
  public static final double RISE = 0.02;

  private static final double FRAME = 0.73;

  /** So many seeds get the tests that are long; 0 means a sample of one. */
  static final int SEEDS = Integer.getInteger("carom.contacts", 0);

  /** The world that is played. */
  public final World world;

  private final Bounds bounds;
  private final double gravity;

  /** Of the energy, for all circles together. */
  private final double allowedRise;

  /** Impacts above this speed are fast: four times what gravity adds in a tick of the contacts. */
  private final double fast;

  private boolean energyCounts = true;
  private boolean fromAbove;

  /** The worst overlap, as a multiple of what is allowed. */
  public double overlap;

  /** The worst overlap, in radii. */
  public double deepest;

  /** The worst rise of the energy, as a multiple of what is allowed. */
  public double rise;

  /** When the last fast impact was. */
  public double lastFast;

  /** The number of rows of the log. */
  public long rows;

  /** The circles of which the log said that they were jammed. */
  public final Set<Integer> jammed = new TreeSet<>();

  /** The lines that moved. */
  private final Set<Integer> movers = new TreeSet<>();

  private final Map<Integer, Line> lines = new TreeMap<>();
  private final Map<Integer, Circle> pegs = new TreeMap<>();

  /** The places and radii of the circles, read once a frame. */
  private final double[] xs;

  private final double[] ys;
  private final double[] radii;
  private double least = Double.POSITIVE_INFINITY;
  private String overlapText = "";
  private String riseText = "";
  private String unfinishedText = "";

  /** Nothing is played yet. */
  public ContactRun(World world) {
    this.world = world;
    bounds = world.scene().bounds().orElse(null);
    Vec2 g = world.gravity();
    gravity = g.length();
    xs = new double[world.count(Kind.CIRCLE)];
    ys = new double[world.count(Kind.CIRCLE)];
    radii = new double[world.count(Kind.CIRCLE)];
    double sum = 0;
    double smallest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      if (world.traits(Kind.CIRCLE, i).mass() < Double.POSITIVE_INFINITY) {
        sum += world.traits(Kind.CIRCLE, i).mass() * gravity * world.radius(i);
        smallest = Math.min(smallest, world.radius(i));
      }
    }
    allowedRise = RISE * sum;
    fast = 4 * gravity * tick(smallest, gravity);
    check();
  }

  /** The power of two that is nearest to the time in which a ball falls from 2^-9 of its radius. */
  public static double tick(double radius, double gravity) {
    double exponent = Math.log(0x1p-8 * radius / gravity) / Math.log(2) / 2;
    return Math.scalb(1.0, (int) Math.rint(exponent));
  }

  /** Energy may rise: something moves that has no energy of its own. */
  public ContactRun withMovers() {
    return withEnergyApart();
  }

  /** A rise of the energy is no fault: {@link #rise} has another limit. */
  public ContactRun withEnergyApart() {
    energyCounts = false;
    return this;
  }

  /** No circle comes to a one-way line from its right: there none may be inside it. */
  public ContactRun fromAbove() {
    fromAbove = true;
    return this;
  }

  /** Plays frames until a time, of a length that is no part of a tick of the contacts. */
  public ContactRun play(double end) {
    return play(end, FRAME);
  }

  /** Plays frames of some length until a time. */
  public ContactRun play(double end, double frame) {
    double start = world.now();
    for (int k = 1; world.now() < end && isFinished(); k++) {
      advance(Math.min(end, start + k * frame));
    }
    return this;
  }

  /** Plays frames until nothing moves but what rolls, or until a time. */
  public ContactRun playUntilRest(double end) {
    while (world.now() < end && isFinished() && moving() > 0) {
      advance(world.now() + FRAME);
    }
    return this;
  }

  private void advance(double time) {
    try {
      world.advanceTo(time);
    } catch (UnfinishedException e) {
      unfinishedText = e.getMessage();
    }
    read(world.impacts());
    check();
  }

  /** Whether all calls were finished. */
  public boolean isFinished() {
    return unfinishedText.isEmpty();
  }

  private void read(ImpactLog log) {
    rows += log.size();
    for (int row = 0; row < log.size(); row++) {
      if (log.approachSpeed(row) > fast) {
        lastFast = log.time(row);
      }
      if (log.outcome(row) == Outcome.JAMMED) {
        jammed.add(log.circle(row));
      }
    }
  }

  /** How many circles neither rest nor roll alone on level ground. */
  public int moving() {
    int moving = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      boolean rolls = world.vy(i) == 0 && world.vx(i) != 0;
      moving += world.isResting(i) || rolls ? 0 : 1;
    }
    return moving;
  }

  /** How many circles rest. */
  public int resting() {
    int resting = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      resting += world.isResting(i) ? 1 : 0;
    }
    return resting;
  }

  /** What broke the law; empty if nothing did. */
  public String faults() {
    List<String> all = new ArrayList<>();
    if (!isFinished()) {
      all.add(unfinishedText);
    }
    if (overlap > 1) {
      all.add(overlapText);
    }
    if (rise > 1 && energyCounts) {
      all.add(riseText);
    }
    return String.join("; ", all);
  }

  /** Place and velocity of each circle. */
  public double[] state() {
    double[] state = new double[4 * world.count(Kind.CIRCLE)];
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      state[4 * i] = world.x(i);
      state[4 * i + 1] = world.y(i);
      state[4 * i + 2] = world.vx(i);
      state[4 * i + 3] = world.vy(i);
    }
    return state;
  }

  /** The kinetic and the potential energy of all circles of finite mass. */
  public double energy() {
    Vec2 g = world.gravity();
    double sum = 0;
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      double m = world.traits(Kind.CIRCLE, i).mass();
      if (m < Double.POSITIVE_INFINITY) {
        double vx = world.vx(i);
        double vy = world.vy(i);
        sum += m * ((vx * vx + vy * vy) / 2 - g.x() * world.x(i) - g.y() * world.y(i));
      }
    }
    return sum;
  }

  private void check() {
    double energy = energy();
    least = Math.min(least, energy);
    double rises = (energy - least) / allowedRise;
    if (rises > rise) {
      rise = rises;
      riseText = "energy rises by " + RISE * rises + " m g R a circle at " + world.now();
    }
    findObstacles();
    for (int i = 0; i < xs.length; i++) {
      xs[i] = world.x(i);
      ys[i] = world.y(i);
      radii[i] = world.radius(i);
    }
    boolean collide = world.scene().collide();
    for (int i = 0; i < xs.length; i++) {
      for (int j = 0; j < i && collide; j++) {
        checkPair(i, j);
      }
      checkObstacles(i, xs[i], ys[i], radii[i]);
    }
  }

  private void findObstacles() {
    lines.clear();
    pegs.clear();
    for (int id : world.ids(Kind.LINE)) {
      if (!world.traits(Kind.LINE, id).oneWay() || fromAbove) {
        lines.put(id, world.line(id));
      }
      if (!world.velocity(Kind.LINE, id).equals(Vec2.ZERO)) {
        movers.add(id);
      }
    }
    for (int id : world.ids(Kind.PEG)) {
      pegs.put(id, world.peg(id));
    }
  }

  private void checkPair(int i, int j) {
    double reach = radii[i] + radii[j];
    double dx = xs[j] - xs[i];
    double dy = ys[j] - ys[i];
    if (dx * dx + dy * dy < reach * reach) {
      double ulp = Math.ulp(Math.max(size(i), size(j)));
      overlaps(i, "circle ", j, reach - Math.hypot(dx, dy), Math.min(radii[i], radii[j]), ulp);
    }
  }

  private double size(int i) {
    return Math.max(Math.abs(xs[i]), Math.abs(ys[i])) + radii[i];
  }

  private void checkObstacles(int i, double x, double y, double r) {
    double size = size(i);
    for (int k : lines.keySet()) {
      if (!(movers.contains(k) && jammed.contains(i))) {
        Line line = lines.get(k);
        double ulp = Math.ulp(Math.max(size, size(line)));
        double depth = isSolid(k, line, x, y) ? r - distance(line, x, y) : 0;
        overlaps(i, "line ", k, depth, r, ulp);
      }
    }
    for (int k : pegs.keySet()) {
      Circle peg = pegs.get(k);
      double depth = r + peg.radius() - Math.hypot(peg.x() - x, peg.y() - y);
      double ulp = Math.ulp(Math.max(size, Math.abs(peg.x()) + Math.abs(peg.y())));
      overlaps(i, "peg ", k, depth, r, ulp);
    }
    if (bounds != null) {
      double dx = Math.max(bounds.xmin() + r - x, x + r - bounds.xmax());
      double dy = Math.max(bounds.ymin() + r - y, y + r - bounds.ymax());
      overlaps(i, "a wall of ", 4, Math.max(dx, dy), r, Math.ulp(size));
    }
  }

  private void overlaps(int i, String kind, int which, double depth, double radius, double ulp) {
    if (depth > 0) {
      deepest = Math.max(deepest, depth / radius);
      double excess = depth / (OVERLAP * radius + ULPS * ulp);
      if (excess > overlap) {
        overlap = excess;
        String where = " radii inside " + kind + which + " at " + world.now();
        overlapText = "circle " + i + " is " + depth / radius + where;
      }
    }
  }

  /** For a circle that came from the left of a one-way line: while it is there. */
  private boolean isSolid(int k, Line line, double x, double y) {
    double left =
        (line.bx() - line.ax()) * (y - line.ay()) - (line.by() - line.ay()) * (x - line.ax());
    return !world.traits(Kind.LINE, k).oneWay() || left > 0;
  }

  private static double size(Line line) {
    double a = Math.max(Math.abs(line.ax()), Math.abs(line.ay()));
    return Math.max(a, Math.max(Math.abs(line.bx()), Math.abs(line.by())));
  }

  /** How far a place is from a line. */
  static double distance(Line line, double x, double y) {
    double wx = line.bx() - line.ax();
    double wy = line.by() - line.ay();
    double s = ((x - line.ax()) * wx + (y - line.ay()) * wy) / (wx * wx + wy * wy);
    double t = s > 0 ? Math.min(1, s) : 0;
    return Math.hypot(x - line.ax() - t * wx, y - line.ay() - t * wy);
  }
}
