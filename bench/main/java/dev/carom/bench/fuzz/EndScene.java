// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.World;
import java.util.HashSet;
import java.util.Locale;
import java.util.Random;
import java.util.Set;

/**
 * A random scene in which impacts would not end without a rule: circles are trapped, pressed,
 * heaped or driven. With it comes how it is steered between steps, and what it promises.
 */
public final class EndScene {

  /** What leads to endless impacts. */
  public enum Layout {
    /** Disks that overlap several lines or pegs, among others that fly past. */
    TRAPPED,
    /** Disks in pockets with a clearance of some ulps, among others that fly past. */
    POCKETS,
    /** Infinite masses that overlap, meet, and turn as a flipper. */
    MASSES,
    /** Infinite masses that close on balls like doors, or press them against walls. */
    DOORS,
    /** Balls that each step makes a little faster downwards. */
    HEAP,
    /** Crowds in which impacts add energy. */
    BUMPERS,
    /** Balls under gravity that ignore each other, among slopes, pegs and one-way platforms. */
    FALL,
    /** Balls under gravity on each other, on a floor or in a valley. */
    PILE,
    /** Balls under gravity that fall through rows of pegs into bins. */
    PLINKO;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  private static final double WIDTH = Numbers.WIDTH;
  private static final double HEIGHT = Numbers.HEIGHT;
  private static final double INFINITE = Double.POSITIVE_INFINITY;
  private static final double GRAVITY = 0.05;
  private static final double FLIP = 0.1;

  /** Steps after which a scene that would come to rest, or to no end of speed, is stirred. */
  private static final int STIR = 100;

  private final Layout kind;
  private final Random random;
  private final double length;
  private final double speed;
  private final SceneBuilder builder = Scene.builder();
  private final Set<Integer> trapped = new HashSet<>();
  private final Scene scene;
  private int circles;
  private int steered;

  /**
   * Draws a scene.
   *
   * @param length the unit of length
   * @param speed the unit of speed
   */
  EndScene(Layout kind, Random random, double length, double speed) {
    this.kind = kind;
    this.random = random;
    this.length = length;
    this.speed = speed;
    build();
    scene = builder.build();
  }

  Scene scene() {
    return scene;
  }

  /** Circles that cannot leave their places, and ignore others. */
  Set<Integer> trapped() {
    return trapped;
  }

  /** Whether each step leads to its end. */
  boolean finishes() {
    return kind != Layout.BUMPERS;
  }

  /** The length of a step. */
  double duration() {
    double frames =
        switch (kind) {
          case HEAP -> 1;
          case PILE, PLINKO -> 4; // so that they come to rest in a session
          case BUMPERS -> 0.25;
          default -> 4 * random.nextDouble();
        };
    return frames * length / speed;
  }

  private void build() {
    switch (kind) {
      case TRAPPED, POCKETS -> buildTraps();
      case MASSES -> buildMasses();
      case DOORS -> buildDoors();
      case HEAP -> buildHeap();
      case BUMPERS -> buildBumpers();
      case FALL -> buildFall();
      case PILE -> buildPile();
      case PLINKO -> buildPlinko();
      default -> throw new AssertionError(kind);
    }
  }

  private double pick(double... some) {
    return some[random.nextInt(some.length)];
  }

  private double between(double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  private void box(boolean collide, double restitution) {
    builder.collide(collide).bounds(0, 0, WIDTH * length, HEIGHT * length);
    builder.restitution(restitution);
  }

  /** Adds a circle, in units. */
  private int circle(double x, double y, double r, double vx, double vy, double e) {
    builder.circle(x * length, y * length, r * length, vx * speed, vy * speed).restitution(e);
    return circles++;
  }

  private int flying(double r, double e) {
    double x = between(r, WIDTH - r);
    double y = between(r, HEIGHT - r);
    return circle(x, y, r, 2 * random.nextGaussian(), 2 * random.nextGaussian(), e);
  }

  private void buildTraps() {
    box(false, pick(1, 1, 0.9));
    int traps = kind == Layout.POCKETS ? 1 : 1 + random.nextInt(3);
    for (int i = 0; i < traps; i++) {
      double x = 20 + 30 * i;
      double y = between(20, 60);
      double r = between(2, 5);
      double e = pick(0, 0.5, 0.9, 1, 1, 1, 1.1);
      surround(x, y, r);
      trapped.add(circle(x, y, r, random.nextGaussian(), random.nextGaussian(), e));
    }
    int others = random.nextInt(8);
    for (int i = 0; i < others; i++) {
      flying(between(0.5, 2), pick(1, 1, 0.9));
    }
  }

  /** Lines and pegs on all sides of a disk: their normals leave no direction free. */
  private void surround(double x, double y, double r) {
    int sides = 3 + random.nextInt(3);
    double turn = between(0, 2 * Math.PI);
    for (int k = 0; k < sides; k++) {
      double angle = turn + 2 * Math.PI * k / sides + between(-0.2, 0.2);
      double gap =
          kind == Layout.POCKETS ? r + random.nextInt(32) * Math.ulp(x) : r * pick(0.2, 0.7);
      double size = pick(0, 1, between(0.5, 3));
      double nx = Math.cos(angle);
      double ny = Math.sin(angle);
      if (random.nextBoolean()) {
        builder.peg(
            (x + (gap + size) * nx) * length, (y + (gap + size) * ny) * length, size * length);
      } else {
        double fx = x + gap * nx;
        double fy = y + gap * ny;
        double half = r * between(0.5, 1.5);
        builder.line(
            (fx - half * ny) * length,
            (fy + half * nx) * length,
            (fx + half * ny) * length,
            (fy - half * nx) * length);
      }
      builder.restitution(pick(1, 1, 0.9));
    }
  }

  private void buildMasses() {
    box(true, 1);
    int infinite = 2 + random.nextInt(6);
    double r = pick(1, 3, 5);
    for (int i = 0; i < infinite; i++) {
      double x = random.nextBoolean() ? between(10, 90) : 30 + i * r / 2;
      double y = random.nextBoolean() ? between(10, 70) : 40;
      circle(x, y, r, pick(-2, -1, 0, 1, 2), pick(-1, 0, 0, 1), pick(0, 0.5, 1, 1));
      builder.mass(INFINITE);
    }
    int finite = random.nextInt(5);
    for (int i = 0; i < finite; i++) {
      flying(between(0.5, 3), pick(0, 0.5, 0.9, 1));
      builder.mass(pick(1, 1, 3, 1e6));
    }
  }

  private void buildDoors() {
    box(true, pick(1, 1, 0.5));
    double r = pick(2, 5);
    double y = between(10, 70);
    circle(10, y, r, pick(1, 2), 0, 1);
    builder.mass(INFINITE);
    if (random.nextInt(3) > 0) {
      circle(90, y + pick(0, 0, 1, r), r, pick(-1, -1, -2), pick(0, 0, 0.25), 1);
      builder.mass(INFINITE);
    }
    if (random.nextInt(3) == 0) {
      circle(50, random.nextBoolean() ? r : HEIGHT - r, r, 0, pick(-1, 1), 1);
      builder.mass(INFINITE);
    }
    double e = pick(0, 0.3, 0.5, 0.9, 1);
    int balls = 1 + random.nextInt(6);
    for (int i = 0; i < balls; i++) {
      double off = random.nextBoolean() ? 0 : between(-1, 1);
      circle(25 + 8 * i, y + off, between(1, 3), pick(0, 0, 0.3, -0.5), pick(0, 0, 0.1), e);
      builder.mass(pick(1, 1, 1, 2, 1e-3));
    }
  }

  private void buildHeap() {
    double e = pick(0, 0.3, 0.5, 0.8, 0.9);
    box(true, e);
    int count = 3 + random.nextInt(18);
    double off = pick(0, 0.4);
    for (int i = 0; i < count; i++) {
      double x = 5 + 9 * (i % 6) + off * random.nextDouble();
      double y = 5 + 9 * (i / 6) + off * random.nextDouble();
      circle(x, y, random.nextBoolean() ? 3 : between(1, 4), 0, 0, e);
    }
    int pegs = random.nextInt(3);
    for (int i = 0; i < pegs; i++) {
      builder.peg(between(60, 90) * length, between(0, 20) * length, pick(0, 1, 3) * length);
    }
  }

  private void buildBumpers() {
    box(random.nextInt(3) > 0, pick(1, 1.1, 1.5));
    int count = 3 + random.nextInt(10);
    for (int i = 0; i < count; i++) {
      flying(between(2, 8), pick(1, 1.1, 1.5, 2));
    }
    int pegs = random.nextInt(4);
    for (int i = 0; i < pegs; i++) {
      builder.peg(between(0, WIDTH) * length, between(0, HEIGHT) * length, between(0, 5) * length);
      builder.restitution(pick(1, 1.1, 2));
    }
  }

  private void fallingBox(boolean collide, double e) {
    box(collide, e);
    builder.gravity(0, -GRAVITY * speed / length * speed);
  }

  private void line(double ax, double ay, double bx, double by, double e) {
    builder.line(ax * length, ay * length, bx * length, by * length).restitution(e);
  }

  private void peg(double x, double y, double r, double e) {
    builder.peg(x * length, y * length, r * length).restitution(e);
  }

  private void buildFall() {
    fallingBox(false, pick(0.5, 0.9, 1));
    int slopes = 2 + random.nextInt(6);
    for (int i = 0; i < slopes; i++) {
      double x = between(0, 80);
      double y = between(5, 60);
      line(x, y, x + between(5, 30), y + pick(0, 0, -10, between(-10, 10)), pick(0, 0.5, 1));
      if (random.nextInt(4) == 0) {
        builder.oneWay();
      }
      peg(between(0, WIDTH), between(0, 60), between(0, 4), pick(0.3, 1));
    }
    int balls = 3 + random.nextInt(10);
    for (int i = 0; i < balls; i++) {
      flying(between(0.5, 3), pick(0, 0.3, 0.8, 1));
    }
  }

  private void buildPile() {
    double e = pick(0, 0.3, 0.5, 0.8, 0.9);
    fallingBox(true, e);
    if (random.nextBoolean()) {
      double deep = between(0, 20);
      line(0, between(deep, 40), between(20, 80), deep, e);
      line(between(20, 80), deep, WIDTH, between(deep, 40), e);
    }
    int balls = 2 + random.nextInt(10);
    for (int i = 0; i < balls; i++) {
      circle(12 + 9 * (i % 8), 50 + 9 * (i / 8), between(1, 4), random.nextGaussian(), 0, e);
    }
  }

  private void buildPlinko() {
    double e = pick(0.3, 0.5, 0.8);
    fallingBox(random.nextBoolean(), e);
    for (int row = 0; row < 4; row++) {
      for (int i = 0; i < 8; i++) {
        peg(6 + 12 * i + 6 * (row % 2), 25 + 10 * row, 1, e);
      }
    }
    for (int i = 1; i < 8; i++) {
      line(12 * i, 0, 12 * i, 15, e);
    }
    int balls = 3 + random.nextInt(8);
    for (int i = 0; i < balls; i++) {
      circle(5 + 11 * (i % 9), between(66, 76), between(1, 2), random.nextGaussian(), 0, e);
    }
  }

  /**
   * Edits the world before a step, so that there is more to come, and returns whether it edited
   * anything.
   */
  boolean steer(World world) {
    steered++;
    return switch (kind) {
      case TRAPPED, POCKETS -> random.nextInt(6) == 0 && kick(world);
      case MASSES -> random.nextInt(4) == 0 && flip(world);
      case DOORS -> false;
      case HEAP -> steered % STIR == 0 ? stir(world) : fall(world);
      case BUMPERS -> steered % (STIR / 10) == 0 && stir(world);
      case FALL, PILE, PLINKO -> steered % STIR == 0 && stir(world);
    };
  }

  private boolean kick(World world) {
    for (int i : world.ids(Kind.CIRCLE)) {
      if (trapped.contains(i)) {
        world.setVelocity(i, speed * random.nextGaussian(), speed * random.nextGaussian());
      }
    }
    return true;
  }

  /** Turns infinite masses around the centre of the box, to and fro. */
  private boolean flip(World world) {
    double turn = random.nextBoolean() ? FLIP : -FLIP;
    for (int i : world.ids(Kind.CIRCLE)) {
      if (world.traits(Kind.CIRCLE, i).mass() == INFINITE) {
        double x = world.x(i) / length - WIDTH / 2;
        double y = world.y(i) / length - HEIGHT / 2;
        world.setVelocity(i, -turn * y * speed, turn * x * speed);
      }
    }
    return true;
  }

  private boolean fall(World world) {
    for (int i : world.ids(Kind.CIRCLE)) {
      world.setVelocity(i, world.vx(i), world.vy(i) - GRAVITY * speed);
    }
    return true;
  }

  private boolean stir(World world) {
    for (int i : world.ids(Kind.CIRCLE)) {
      world.setVelocity(i, 2 * speed * random.nextGaussian(), 2 * speed * random.nextGaussian());
    }
    return true;
  }
}
