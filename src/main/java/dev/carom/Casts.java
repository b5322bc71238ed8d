// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.state.Codes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.sweep.Hit;
import dev.carom.internal.util.Check;
import java.util.Arrays;

/**
 * {@code Casts} holds many casts and their answers: each is a circle, its velocity, and the first
 * thing that it hits. {@link Resolver#cast(Casts, double) Resolver.cast} answers all of them in one
 * call. A circle of radius 0 is a ray.
 *
 * <p>A program makes one such object and uses it again. A call then allocates a few small objects,
 * and nothing per cast. It allocates more when it makes an <a
 * href="doc-files/rules.html#questions">index</a>, and when exact arithmetic has to decide.
 *
 * <pre>{@code
 * Resolver room = Resolver.of(List.of(new Bounds(0, 0, 100, 60), new Circle(70, 30, 10)));
 * Casts rays = new Casts();
 * for (int i = 0; i < 4; i++) {
 *   double angle = i * Math.PI / 2;
 *   rays.add(20, 30, 0, Math.cos(angle), Math.sin(angle));
 * }
 * room.cast(rays, 1000);
 * System.out.println(rays.kind(0) + " at " + rays.time(0)); // PEG at 40.0
 * }</pre>
 *
 * <p>Until it is asked, and if it hits nothing, the answer of a cast is: time {@code +infinity}, id
 * -1, normal (0, 0). Its kind and its feature are refused then. It belongs to one thread at a time.
 */
public final class Casts {

  private static final int NONE = -1;

  // The columns of a cast in the questions, and of its answer in the normals.
  private static final int X = 0;
  private static final int Y = 1;
  private static final int RADIUS = 2;
  private static final int VX = 3;
  private static final int VY = 4;
  private static final int QUESTION = 5;

  private int size;
  private double[] questions = new double[0];
  private double[] times = new double[0];
  private double[] normals = new double[0];

  /** The ordinals of kinds and features, or NONE. */
  private byte[] kinds = new byte[0];

  private byte[] features = new byte[0];
  private int[] ids = new int[0];

  /** The sides of outlines. */
  private int[] parts = new int[0];

  /** Makes an empty list of casts. */
  public Casts() {}

  /**
   * Returns the number of casts.
   *
   * @return at least 0
   */
  public int size() {
    return size;
  }

  /** Removes all casts. Their room is kept. */
  public void clear() {
    size = 0;
  }

  /**
   * Adds a cast behind the others.
   *
   * @param x the x coordinate of the circle's centre at the start, finite
   * @param y the y coordinate of the centre, finite
   * @param radius the radius, finite and at least 0; 0 is a ray
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @return its number: the first one has 0
   * @throws IllegalArgumentException if a number is NaN or infinite, or the radius negative;
   *     nothing is added then
   */
  public int add(double x, double y, double radius, double vx, double vy) {
    check(x, y, radius, vx, vy);
    if (size == ids.length) {
      grow(2 * size + 16);
    }
    put(size, x, y, radius, vx, vy);
    return size++;
  }

  /**
   * Replaces a cast. Its answer is dropped.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @param x the x coordinate of the circle's centre at the start, finite
   * @param y the y coordinate of the centre, finite
   * @param radius the radius, finite and at least 0; 0 is a ray
   * @param vx the x component of the velocity, finite
   * @param vy the y component of the velocity, finite
   * @throws IndexOutOfBoundsException if there is no such cast
   * @throws IllegalArgumentException if a number is refused, as by {@link #add add}; nothing
   *     changes then
   */
  public void set(int i, double x, double y, double radius, double vx, double vy) {
    check(i);
    check(x, y, radius, vx, vy);
    put(i, x, y, radius, vx, vy);
  }

  /** Refuses a number of none of the casts; returns it otherwise. */
  private int check(int i) {
    if (i < 0 || i >= size) {
      String expected = size == 0 ? "none, there are no casts" : "0 to " + (size - 1);
      throw new IndexOutOfBoundsException("cast is " + i + ": expected " + expected);
    }
    return i;
  }

  /** Refuses the number of a cast that hits nothing, too. */
  private int checkHit(int i) {
    if (!hits(i)) {
      throw Check.refused("cast " + i, "a miss", "one that hits something");
    }
    return i;
  }

  private static void check(double x, double y, double radius, double vx, double vy) {
    Check.finite("x", x);
    Check.finite("y", y);
    Check.notNegative("radius", radius);
    Check.finite("vx", vx);
    Check.finite("vy", vy);
  }

  private void grow(int room) {
    questions = Arrays.copyOf(questions, room * QUESTION);
    times = Arrays.copyOf(times, room);
    normals = Arrays.copyOf(normals, 2 * room);
    kinds = Arrays.copyOf(kinds, room);
    features = Arrays.copyOf(features, room);
    ids = Arrays.copyOf(ids, room);
    parts = Arrays.copyOf(parts, room);
  }

  private void put(int i, double x, double y, double radius, double vx, double vy) {
    int k = i * QUESTION;
    questions[k + X] = x;
    questions[k + Y] = y;
    questions[k + RADIUS] = radius;
    questions[k + VX] = vx;
    questions[k + VY] = vy;
    miss(i);
  }

  // How it is asked.

  /** Loads a cast as a circle at the start of its flight. */
  void load(int i, MovingCircle m) {
    int k = i * QUESTION;
    m.start(
        Impact.NO_ID,
        questions[k + X],
        questions[k + Y],
        questions[k + RADIUS],
        questions[k + VX],
        questions[k + VY],
        1);
  }

  /** Keeps that a cast hits nothing. */
  void miss(int i) {
    keep(i, Double.POSITIVE_INFINITY, NONE, NONE, NONE, 0, 0);
    parts[i] = 0;
  }

  /** Keeps the first impact of a cast. */
  void hit(int i, MovingCircle first, int id, ObstacleTable obstacles, Hit hit) {
    int code = first.next;
    int feature = ObstacleTable.part(code, first.contact);
    int named = obstacles.named(code, feature);
    int itsFeature = obstacles.featureNamed(code, feature);
    keep(i, first.cleared, Codes.kind(code), id, itsFeature, hit.nx(), hit.ny());
    parts[i] = Codes.isLine(named) ? obstacles.side(named) : 0;
  }

  private void keep(int i, double t, int kind, int id, int feature, double nx, double ny) {
    times[i] = t;
    kinds[i] = (byte) kind;
    ids[i] = id;
    features[i] = (byte) feature;
    normals[2 * i + X] = nx;
    normals[2 * i + Y] = ny;
  }

  // The answers.

  /**
   * Tells whether a cast hits something.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return true if the other methods describe an impact
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public boolean hits(int i) {
    return kinds[check(i)] != NONE;
  }

  /**
   * Returns the time of impact, see {@link Impact#time}.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the time; {@code +infinity} if the cast hits nothing
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public double time(int i) {
    return times[check(i)];
  }

  /**
   * Returns the kind of thing that is hit.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the kind
   * @throws IndexOutOfBoundsException if there is no such cast
   * @throws IllegalArgumentException if the cast {@linkplain #hits hits} nothing
   */
  public Kind kind(int i) {
    return Kind.of(kinds[checkHit(i)]);
  }

  /**
   * Returns the id of the thing that is hit, see {@link Impact#id}.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the id; -1 if the cast hits nothing
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public int id(int i) {
    return ids[check(i)];
  }

  /**
   * Returns the side of an {@link Outline} that is hit, see {@link Impact#part}.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the side, from 0 on; 0 of all else, and if the cast hits nothing
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public int part(int i) {
    return parts[check(i)];
  }

  /**
   * Returns the feature of the thing that is hit.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the feature
   * @throws IndexOutOfBoundsException if there is no such cast
   * @throws IllegalArgumentException if the cast {@linkplain #hits hits} nothing
   */
  public Feature feature(int i) {
    return Feature.of(features[checkHit(i)]);
  }

  /**
   * Returns the x component of the unit normal, see {@link Impact#normal}.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the component; 0 if the cast hits nothing
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public double nx(int i) {
    return normals[2 * check(i) + X];
  }

  /**
   * Returns the y component of the unit normal, see {@link Impact#normal}.
   *
   * @param i its number, 0..{@link #size()} - 1
   * @return the component; 0 if the cast hits nothing
   * @throws IndexOutOfBoundsException if there is no such cast
   */
  public double ny(int i) {
    return normals[2 * check(i) + Y];
  }
}
