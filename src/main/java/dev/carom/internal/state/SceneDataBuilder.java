// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.Check;
import dev.carom.internal.util.DoubleList;
import dev.carom.internal.util.Kind;
import dev.carom.internal.util.Refusal;
import java.util.Arrays;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Builds a {@link SceneData}. A bad value is refused at once, with a message that names the thing,
 * and leaves the builder as it was. Only a radius that is too small beside the coordinates of the
 * scene is refused by {@link #build}, when all coordinates are known.
 */
public final class SceneDataBuilder {

  // The places in the row of the bounds.
  private static final int XMIN = 0;
  private static final int YMIN = 1;
  private static final int XMAX = 2;
  private static final int YMAX = 3;
  private static final int BOUNDS_RESTITUTION = 4;
  private static final int BOUNDS_ROW = 5;

  final SceneRows circles = new SceneRows("circle", SceneData.CIRCLE_ROW, 2);

  /** The obstacles by their {@link Kind}, but for the bounds. */
  private final SceneRows[] obstacles = new SceneRows[Kind.CIRCLE];

  public final SceneRows bounds = new SceneRows("bounds", BOUNDS_ROW, 4);
  final DoubleList masses = new DoubleList();
  public boolean collide;
  double gx;
  double gy;

  /** The rows whose last one was added last; null before the first. */
  private SceneRows last;

  /** The velocities of the obstacles that move, by their codes. */
  private final SortedMap<Integer, double[]> velocities = new TreeMap<>();

  public SceneDataBuilder() {
    ObstacleTable.kindsOfRows()
        .forEach(kind -> obstacles[kind] = new SceneRows(ObstacleTable.shape(kind)));
  }

  public void bounds(double xmin, double ymin, double xmax, double ymax) {
    if (bounds.count() > 0) {
      throw new IllegalStateException("the scene has bounds already: expected one only");
    }
    add(bounds, () -> Check.bounds(xmin, ymin, xmax, ymax), xmin, ymin, xmax, ymax, 1);
  }

  /** Adds an obstacle of a {@link Kind}, by the numbers of its shape. */
  public void obstacle(int kind, double... numbers) {
    double[] row = Arrays.copyOf(numbers, numbers.length + 1);
    row[numbers.length] = 1;
    add(obstacles[kind], () -> ObstacleTable.shape(kind).check(numbers), row);
  }

  /** Adds a moving circle of mass 1. */
  public void circle(double x, double y, double radius, double vx, double vy) {
    double r = radius + 0.0; // 0 for -0
    add(circles, () -> checkCircle(x, y, r, vx, vy), x, y, r, vx, vy, 1);
    masses.add(1);
  }

  private static void checkCircle(double x, double y, double radius, double vx, double vy) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  // Properties of the thing added last.

  public void restitution(double e) {
    expectThing("restitution");
    check(last, last.count() - 1, () -> Check.notNegative("restitution", e));
    last.setLastRestitution(e);
  }

  /** Sets a response, by its number in {@link ContactFlags}. */
  public void response(int response) {
    expectThing("response");
    if (last == bounds && response == ContactFlags.SENSOR) {
      throw Refusal.of(
          "bounds",
          Check.refused("response", "sensor", "bounce or halt: bounds keep circles inside"));
    }
    last.setLastTraits(ContactFlags.with(last.lastTraits(), response));
  }

  public void filter(int category, int mask) {
    expectThing("filter");
    last.setLastFilter(Filter.of(category, mask));
  }

  /** Sets the category of the thing added last; its mask stays. */
  public void category(int category) {
    filter(category, Filter.mask(last.lastFilter()));
  }

  /** Sets the mask of the thing added last; its category stays. */
  public void mask(int mask) {
    filter(Filter.category(last.lastFilter()), mask);
  }

  private void expectThing(String property) {
    if (last == null) {
      throw new IllegalStateException(property + " belongs to the thing added last: add one first");
    }
  }

  public void oneWay() {
    if (last != obstacles[Kind.LINE]) {
      throw new IllegalStateException("one-way belongs to the line just added: add one first");
    }
    last.setLastTraits(ContactFlags.withOneWay(last.lastTraits(), true));
  }

  /** Lets the line or the peg just added move with a velocity. */
  public void velocity(double vx, double vy) {
    int kind = Arrays.asList(obstacles).indexOf(last);
    if (last == null || kind < 0) {
      throw new IllegalStateException(
          "velocity belongs to the line or peg just added: add one first; that of a circle stands in"
              + " circle(x, y, radius, vx, vy)");
    }
    int i = last.count() - 1;
    check(
        last,
        i,
        () -> {
          Check.finite("vx", vx);
          Check.finite("vy", vy);
        });
    if (vx == 0 && vy == 0) {
      velocities.remove(Codes.of(kind, i));
    } else {
      velocities.put(Codes.of(kind, i), new double[] {vx, vy});
    }
  }

  public void mass(double m) {
    if (last != circles) {
      throw new IllegalStateException("mass belongs to the circle just added: add one first");
    }
    check(circles, circles.count() - 1, () -> Check.mass("mass", m));
    masses.setLast(m);
  }

  // The whole.

  /** Sets the acceleration of all circles. A zero has the positive sign. */
  public void gravity(double x, double y) {
    try {
      Check.finite("gx", x);
      Check.finite("gy", y);
    } catch (IllegalArgumentException e) {
      throw Refusal.of("gravity", e);
    }
    gx = x + 0.0; // -0 + 0 is 0
    gy = y + 0.0;
  }

  public SceneData build() {
    int i = firstTooSmall();
    if (i >= 0) {
      String expected =
          radius(i) == 0
              ? SizeLimits.NO_POINT
              : "at least %s, 2^10 ulps of the largest coordinate, %s"
                  .formatted(leastRadius(), largestCoordinate());
      throw Refusal.of(circles.name(i), Check.refused("radius", radius(i), expected));
    }
    return new SceneData(this);
  }

  /** The number of the first circle whose radius keeps the scene from being built, or -1. */
  public int firstTooSmall() {
    double least = leastRadius();
    boolean points = obstacles[Kind.LINE].count() == 0;
    for (int i = 0; i < circles.count(); i++) {
      if (!(radius(i) >= least || (points && radius(i) == 0))) {
        return i;
      }
    }
    return -1;
  }

  private double radius(int i) {
    return circles.get(i, SceneData.RADIUS);
  }

  private double leastRadius() {
    return SizeLimits.leastRadius(largestCoordinate());
  }

  private double largestCoordinate() {
    double largest = Math.max(circles.largestCoordinate(), bounds.largestCoordinate());
    for (int kind : ObstacleTable.kindsOfRows().toArray()) {
      largest = Math.max(largest, obstacles[kind].largestCoordinate());
    }
    return largest;
  }

  /** All obstacles so far. */
  ObstacleTable obstacles() {
    ObstacleRows[] rows =
        ObstacleTable.kindsOfRows()
            .mapToObj(
                kind ->
                    ObstacleTable.rows(
                        kind,
                        obstacles[kind].toArray(),
                        obstacles[kind].traits(),
                        obstacles[kind].filters()))
            .toArray(ObstacleRows[]::new);
    double[] b = bounds.toArray();
    ObstacleTable all =
        b.length == 0
            ? ObstacleTable.of(null, 1, 0, Filter.DEFAULT, rows)
            : ObstacleTable.of(
                ObstacleTable.walls(b[XMIN], b[YMIN], b[XMAX], b[YMAX]),
                b[BOUNDS_RESTITUTION],
                bounds.lastTraits(),
                bounds.lastFilter(),
                rows);
    all.setMotions(ObstacleMotions.of(velocities));
    return all;
  }

  private void add(SceneRows things, Runnable checks, double... row) {
    check(things, things.count(), checks);
    things.add(row);
    last = things;
  }

  /** Lets a refusal begin with the name of number i. */
  private static void check(SceneRows things, int i, Runnable checks) {
    try {
      checks.run();
    } catch (IllegalArgumentException e) {
      throw Refusal.of(things.name(i), e);
    }
  }
}
