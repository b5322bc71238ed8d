// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Random;

/**
 * Balls of radius 10 that fall into a box, a funnel or the like, as in a first program. Gravity is
 * 0.05 a frame and frame: 180 pixels in a second and second.
 *
 * <pre>{@code
 * Scene scene = EverydayScenes.of(Shape.FUNNEL_2, 30).restitution(0.5).seed(7).scene();
 * }</pre>
 */
public final class EverydayScenes {

  /** The radius of each ball. */
  public static final double RADIUS = 10;

  /** The size of gravity, in pixels a frame and frame. */
  public static final double GRAVITY = 0.05;

  /** Stands for the restitutions 0, 0.3, 0.5 and 0.9, which the balls get at random. */
  public static final double MIXED = -1;

  private static final double[] RESTITUTIONS = {0, 0.3, 0.5, 0.9};

  /** Where the balls fall. */
  public enum Shape {
    BOX,
    V,
    BOWL,
    /** Its opening is two diameters wide. */
    FUNNEL_2,
    /** Its opening is four diameters wide. */
    FUNNEL_4,
    STAIRS,
    /** It is one diameter wide. */
    SHAFT,
    BINS,
    PEGS,
    RAMP
  }

  /** How coordinates are chosen. */
  public enum Places {
    /** All are whole numbers, and the balls fall from rest. */
    INTEGER,
    /** The balls are shifted by up to 0.9, and have a velocity of up to 0.5 along each axis. */
    JITTERED,
    /** As jittered, and all lengths and gravity are multiplied by 0.3. */
    SCALED
  }

  /**
   * How a scene is looked at: the signs of x and y, and factors of lengths, times and masses. With
   * powers of two nothing is rounded.
   */
  public record View(double x, double y, double length, double time, double mass) {

    /** Nothing is changed. */
    public static final View PLAIN = new View(1, 1, 1, 1, 1);
  }

  private final Shape shape;
  private final int balls;
  private double e = 0.5;
  private Places places = Places.JITTERED;
  private long seed = 3;
  private View view = View.PLAIN;
  private SceneBuilder builder;

  private EverydayScenes(Shape shape, int balls) {
    this.shape = shape;
    this.balls = balls;
  }

  /** Describes a scene: jittered, with restitution 0.5, unless told otherwise. */
  public static EverydayScenes of(Shape shape, int balls) {
    return new EverydayScenes(shape, balls);
  }

  /** Sets the restitution of each pair, or {@link #MIXED}. */
  public EverydayScenes restitution(double e) {
    this.e = e;
    return this;
  }

  /** Sets how coordinates are chosen. */
  public EverydayScenes places(Places places) {
    this.places = places;
    return this;
  }

  /** Sets the seed of all that is chosen at random. */
  public EverydayScenes seed(long seed) {
    this.seed = seed;
    return this;
  }

  /** Sets how the scene is looked at. */
  public EverydayScenes view(View view) {
    this.view = view;
    return this;
  }

  @Override
  public String toString() {
    return shape + " of " + balls + ", e " + e + ", " + places + ", seed " + seed;
  }

  /** Builds the scene. */
  public Scene scene() {
    double g = GRAVITY * length() / (view.time * view.time);
    builder = Scene.builder().gravity(0, -view.y * g);
    double narrow = balls <= 10 ? 107 : balls <= 30 ? 167 : balls <= 100 ? 267 : 387;
    double high = 200 + 30 * balls / ((narrow - 22) / 22);
    switch (shape) {
      case BOX -> box(narrow, high);
      case V -> v(1.5 * narrow, high);
      case BOWL -> bowl(0.8 * narrow, high);
      case FUNNEL_2 -> funnel(1.5 * narrow, high, 40);
      case FUNNEL_4 -> funnel(1.5 * narrow, high, 80);
      case STAIRS -> stairs(2 * narrow, high);
      case SHAFT -> shaft();
      case BINS -> bins(2 * narrow, high);
      case PEGS -> pegs(1.5 * narrow, high);
      case RAMP -> ramp(2 * narrow, high);
    }
    return builder.build();
  }

  private void box(double w, double h) {
    bounds(0, w, h);
    pile(0, w, 60);
  }

  private void v(double w, double h) {
    double slope = w / 3;
    line(0, h + slope, 0, slope);
    line(0, slope, w / 2, 0);
    line(w / 2, 0, w, slope);
    line(w, slope, w, h + slope);
    pile(0, w, slope + 40);
  }

  private void bowl(double r, double h) {
    int sides = 16;
    for (int i = 0; i < sides; i++) {
      double a = Math.PI * i / sides;
      double b = Math.PI * (i + 1) / sides;
      line(-r * Math.cos(a), -r * Math.sin(a), -r * Math.cos(b), -r * Math.sin(b));
    }
    line(-r, h, -r, 0);
    line(r, 0, r, h);
    pile(-r, r, 30);
  }

  private void funnel(double w, double h, double opening) {
    bounds(0, w, h + 500);
    line(0, 550, (w - opening) / 2, 350);
    line(w, 550, (w + opening) / 2, 350);
    pile(0, w, 600);
  }

  private void stairs(double w, double h) {
    int steps = 8;
    line(0, h + 160, 0, 140);
    for (int i = 0; i < steps; i++) {
      double y = 20 * (steps - 1 - i);
      line(w / steps * i, y, w / steps * (i + 1), y);
      if (i + 1 < steps) {
        line(w / steps * (i + 1), y, w / steps * (i + 1), y - 20);
      }
    }
    line(w, 0, w, h + 160);
    pile(0, w, 220);
  }

  private void shaft() {
    bounds(0, 2 * RADIUS, 60 + 30.0 * balls);
    for (int i = 0; i < balls; i++) {
      ball(RADIUS, 30 + 23 * i, 0, 0, new Random(seed + i));
    }
  }

  private void bins(double w, double h) {
    bounds(0, w, h);
    for (double x = 50; x < w - 20; x += 50) {
      line(x, 0, x, 80);
    }
    pile(0, w, 120);
  }

  private void pegs(double w, double h) {
    bounds(0, w, h + 200);
    for (int row = 0; row < 4; row++) {
      for (double x = 40 + row % 2 * 30; x < w - 30; x += 60) {
        peg(x, 300 - 50 * row, 4);
      }
    }
    pile(0, w, 360);
  }

  private void ramp(double w, double h) {
    line(0, h, 0, 100);
    line(0, 100, 0.7 * w, 0);
    line(0.7 * w, 0, w, 0);
    line(w, 0, w, h);
    pile(0, w, 160);
  }

  /** Rows from the bottom up, as wide as the place. Whole numbers: each row lies a bit aside. */
  private void pile(double left, double right, double bottom) {
    Random random = new Random(seed);
    int across = (int) ((right - left - 2 * RADIUS - 2) / 22);
    double first = (left + right - (across - 1) * 22) / 2;
    for (int i = 0; i < balls; i++) {
      int row = i / across;
      double x = first + i % across * 22;
      double y = bottom + row * 23;
      if (places == Places.INTEGER) {
        ball(x + (seed + row) % 3 - 1, y, 0, 0, random);
      } else {
        double dx = 1.8 * random.nextDouble() - 0.9;
        double dy = 1.8 * random.nextDouble() - 0.9;
        ball(x + dx, y + dy, random.nextDouble() - 0.5, random.nextDouble() - 0.5, random);
      }
    }
  }

  private void ball(double x, double y, double vx, double vy, Random random) {
    double own = e == MIXED ? RESTITUTIONS[random.nextInt(RESTITUTIONS.length)] : e;
    double speed = length() / view.time;
    builder.circle(x(x), y(y), RADIUS * length(), view.x * speed * vx, view.y * speed * vy);
    builder.mass(view.mass).restitution(Math.sqrt(own));
  }

  private void line(double ax, double ay, double bx, double by) {
    builder.line(x(ax), y(ay), x(bx), y(by)).restitution(ofObstacles());
  }

  private void peg(double x, double y, double r) {
    builder.peg(x(x), y(y), r * length()).restitution(ofObstacles());
  }

  private void bounds(double left, double right, double top) {
    double x = Math.min(x(left), x(right));
    double y = Math.min(y(0), y(top));
    builder.bounds(x, y, Math.max(x(left), x(right)), Math.max(y(0), y(top)));
    builder.restitution(ofObstacles());
  }

  private double ofObstacles() {
    return e > 0 ? Math.sqrt(e) : 1;
  }

  private double length() {
    return places == Places.SCALED ? 0.3 * view.length : view.length;
  }

  private double x(double x) {
    return view.x * length() * place(x);
  }

  private double y(double y) {
    return view.y * length() * place(y);
  }

  private double place(double x) {
    return places == Places.INTEGER ? Math.rint(x) : x;
  }
}
