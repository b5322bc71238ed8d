// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.oracle.Contact;
import dev.carom.oracle.Oracle;
import dev.carom.oracle.PairQuery;
import dev.carom.oracle.SegmentQuery;
import dev.carom.oracle.WallQuery;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * A cast in which nearly all obstacles, and moving circles, are met at nearly the same time: a
 * rational one, so that the numbers of the obstacles round. The times of many of them round to the
 * same double, and differ exactly; where the numbers do not round, they tie exactly.
 */
final class NearlyAtOnce {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private static final int[][] TRIPLES = {{1, 0, 1}, {3, 4, 5}, {5, 12, 13}, {15, 8, 17}};

  /** An impact, as the oracle tells. */
  record Truth(Kind kind, int id, Contact contact) {

    int compareTime(Truth other) {
      return contact.moment().compareTo(other.contact.moment());
    }
  }

  /** A unit vector a / h, b / h. */
  private record Direction(int a, int b, int h) {}

  private final Random random;
  private final double time;

  /** The centre at that time, rounded. */
  private final double qx;

  private final double qy;

  final Circle circle;
  final Vec2 v;
  final Bounds bounds;
  final List<Line> lines = new ArrayList<>();
  final List<Circle> pegs = new ArrayList<>();
  final List<Circle> circles = new ArrayList<>();
  final List<Vec2> velocities = new ArrayList<>();

  private List<Truth> all;

  NearlyAtOnce(Random random) {
    this.random = random;
    double[] radii = {0, 0, 1, 2.5, 4, 5};
    circle = new Circle(whole(-9, 9), whole(-9, 9), radii[random.nextInt(radii.length)]);
    v = velocity();
    int n = whole(1, 12);
    int k = whole(1, 3 * n);
    time = k / (double) n;
    qx = (circle.x() * n + v.x() * k) / n;
    qy = (circle.y() * n + v.y() * k) / n;
    bounds = random.nextInt(3) == 0 ? corner() : null;
    int size = whole(1, 12);
    for (int i = 0; i < size; i++) {
      switch (random.nextInt(4)) {
        case 0 -> lines.add(side());
        case 1 -> lines.add(end());
        case 2 -> pegs.add(peg());
        default -> addCircle();
      }
    }
  }

  private int whole(int low, int high) {
    return low + random.nextInt(high - low + 1);
  }

  private Vec2 velocity() {
    Vec2 any = new Vec2(whole(-6, 6), whole(-6, 6));
    return any.equals(Vec2.ZERO) ? new Vec2(3, 1) : any;
  }

  /** A direction towards which a velocity leads. */
  private Direction ahead(double vx, double vy) {
    while (true) {
      int[] t = TRIPLES[random.nextInt(TRIPLES.length)];
      boolean exchanged = random.nextBoolean();
      int a = (exchanged ? t[1] : t[0]) * (random.nextBoolean() ? 1 : -1);
      int b = (exchanged ? t[0] : t[1]) * (random.nextBoolean() ? 1 : -1);
      if (a * vx + b * vy > 0) {
        return new Direction(a, b, t[2]);
      }
    }
  }

  private Vec2 at(double distance, Direction n) {
    return new Vec2(qx + distance * n.a / n.h, qy + distance * n.b / n.h);
  }

  private Bounds corner() {
    double r = circle.radius();
    return new Bounds(
        v.x() < 0 ? qx - r : -1000,
        v.y() < 0 ? qy - r : -1000,
        v.x() > 0 ? qx + r : 1000,
        v.y() > 0 ? qy + r : 1000);
  }

  private Line side() {
    Direction n = ahead(v.x(), v.y());
    Vec2 c = at(circle.radius(), n);
    int back = whole(1, 3);
    int forth = whole(1, 3);
    Line line =
        new Line(c.x() + back * n.b, c.y() - back * n.a, c.x() - forth * n.b, c.y() + forth * n.a);
    return random.nextBoolean() ? line : new Line(line.bx(), line.by(), line.ax(), line.ay());
  }

  private Line end() {
    Direction n = ahead(v.x(), v.y());
    Vec2 c = at(circle.radius(), n);
    int along = whole(-3, 3);
    double bx = c.x() + n.a - along * n.b;
    double by = c.y() + n.b + along * n.a;
    return random.nextBoolean() ? new Line(c.x(), c.y(), bx, by) : new Line(bx, by, c.x(), c.y());
  }

  private Circle peg() {
    double[] radii = {0, 0.5, 1, 3};
    double radius = radii[random.nextInt(radii.length)];
    Vec2 c = at(circle.radius() + radius, ahead(v.x(), v.y()));
    return new Circle(c.x(), c.y(), radius);
  }

  private void addCircle() {
    Vec2 its = velocity();
    if (its.equals(v)) {
      return;
    }
    double radius = whole(1, 4) / 2.0;
    Vec2 c = at(circle.radius() + radius, ahead(v.x() - its.x(), v.y() - its.y()));
    circles.add(new Circle(c.x() - its.x() * time, c.y() - its.y() * time, radius));
    velocities.add(its);
  }

  /** The first of them, of exactly simultaneous ones the first in order; null for none. */
  Truth first(boolean collide) {
    return all(collide).stream().min(Truth::compareTime).orElse(null);
  }

  /** How many others are met at the rounded time of the first one, but not at its exact time. */
  long rivals(boolean collide) {
    Truth first = first(collide);
    return all(collide).stream()
        .filter(each -> each.contact.time() == first.contact.time())
        .filter(each -> each.compareTime(first) != 0)
        .count();
  }

  private List<Truth> all(boolean collide) {
    if (all == null) {
      all = all();
    }
    return all.stream().filter(each -> collide || each.kind != Kind.CIRCLE).toList();
  }

  private List<Truth> all() {
    List<Truth> all = new ArrayList<>();
    if (bounds != null) {
      Contact wall = wall();
      add(all, Kind.WALL, wall.hit() ? wallOf(wall) : -1, wall);
    }
    for (int i = 0; i < lines.size(); i++) {
      add(all, Kind.LINE, i, line(lines.get(i)));
    }
    for (int i = 0; i < pegs.size(); i++) {
      add(all, Kind.PEG, i, pair(pegs.get(i), Vec2.ZERO));
    }
    for (int i = 0; i < circles.size(); i++) {
      add(all, Kind.CIRCLE, i, pair(circles.get(i), velocities.get(i)));
    }
    return all;
  }

  private static void add(List<Truth> all, Kind kind, int id, Contact contact) {
    if (contact.hit()) {
      all.add(new Truth(kind, id, contact));
    }
  }

  /** Left, right, bottom, top: by the normal, which points away from it. */
  private static int wallOf(Contact wall) {
    int x = wall.normal().x().signum();
    return x != 0 ? (1 - x) / 2 : 2 + (1 - wall.normal().y().signum()) / 2;
  }

  private Contact wall() {
    return Oracle.bounds(
        new WallQuery(
            circle.x(),
            circle.y(),
            circle.radius(),
            v.x(),
            v.y(),
            bounds.xmin(),
            bounds.ymin(),
            bounds.xmax(),
            bounds.ymax(),
            NEVER));
  }

  private Contact line(Line l) {
    return Oracle.line(
        new SegmentQuery(
            l.ax(),
            l.ay(),
            l.bx(),
            l.by(),
            circle.x(),
            circle.y(),
            circle.radius(),
            v.x(),
            v.y(),
            NEVER));
  }

  private Contact pair(Circle other, Vec2 its) {
    return Oracle.pair(
        new PairQuery(
            circle.x(),
            circle.y(),
            circle.radius(),
            v.x(),
            v.y(),
            other.x(),
            other.y(),
            other.radius(),
            its.x(),
            its.y(),
            NEVER));
  }
}
