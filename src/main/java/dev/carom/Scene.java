// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/**
 * What is there at time 0: at most one bounds, any number of lines, pegs and moving circles, each
 * with its restitution. Immutable, checked as a whole when it is built, safe to share between
 * threads; a {@link World} sets it in motion.
 *
 * <p>Things of one kind are numbered from 0 in the order in which they were added.
 *
 * <pre>{@code
 * Scene scene = Scene.builder()
 *     .bounds(0, 0, 800, 600)
 *     .line(300, 200, 500, 400).restitution(0.9)
 *     .circle(100, 100, 10, 4, 3)
 *     .build();
 * }</pre>
 */
public final class Scene {

  /** Doubles of one circle in {@link #circles}: x, y, radius, vx, vy, restitution. */
  static final int CIRCLE = 6;

  /** Doubles of one line in {@link #lines}: ax, ay, bx, by, restitution. */
  static final int LINE = 5;

  /** Doubles of one peg in {@link #pegs}: x, y, radius, restitution. */
  static final int PEG = 4;

  /** Doubles of the bounds while they are built: xmin, ymin, xmax, ymax, restitution. */
  static final int BOUNDS = 5;

  final double[] circles;
  final double[] lines;
  final double[] pegs;
  final double[] masses;

  /** See {@link Traits}. */
  final byte[] circleTraits;

  final byte[] lineTraits;
  final byte[] pegTraits;
  final int boundsTraits;

  final Bounds bounds;
  final boolean collide;
  final double boundsRestitution;

  Scene(SceneBuilder from) {
    circles = from.circles.toArray();
    lines = from.lines.toArray();
    pegs = from.pegs.toArray();
    masses = from.masses.toArray();
    circleTraits = from.circles.traits();
    lineTraits = from.lines.traits();
    pegTraits = from.pegs.traits();
    collide = from.collide;
    double[] b = from.bounds.toArray();
    boolean closed = b.length == BOUNDS;
    bounds = closed ? new Bounds(b[0], b[1], b[2], b[3]) : null;
    boundsRestitution = closed ? b[4] : 1;
    boundsTraits = closed ? from.bounds.lastTraits() : 0;
  }

  /**
   * Starts an empty scene.
   *
   * @return a new builder
   */
  public static SceneBuilder builder() {
    return new SceneBuilder();
  }

  /**
   * The number of moving circles.
   *
   * @return at least 0
   */
  public int circleCount() {
    return circles.length / CIRCLE;
  }

  /**
   * The number of lines.
   *
   * @return at least 0
   */
  public int lineCount() {
    return lines.length / LINE;
  }

  /**
   * The number of pegs.
   *
   * @return at least 0
   */
  public int pegCount() {
    return pegs.length / PEG;
  }

  /**
   * A circle as it stands at time 0.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return the circle
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public Circle circle(int i) {
    int k = at("circle", i, circleCount()) * CIRCLE;
    return new Circle(circles[k], circles[k + 1], circles[k + 2]);
  }

  /**
   * The velocity of a circle at time 0.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return the velocity
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public Vec2 velocity(int i) {
    int k = at("circle", i, circleCount()) * CIRCLE;
    return new Vec2(circles[k + 3], circles[k + 4]);
  }

  /**
   * The restitution of a circle; that of an impact is the product of the two parties' restitutions.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return at least 0; 1 is elastic
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double circleRestitution(int i) {
    return circles[at("circle", i, circleCount()) * CIRCLE + 5];
  }

  /**
   * The response of a circle, to other circles.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return the response, {@link Response#BOUNCE} unless another was set
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public Response circleResponse(int i) {
    return Traits.response(Traits.of(circleTraits, at("circle", i, circleCount())));
  }

  /**
   * The mass of a circle; without effect as long as circles ignore each other.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return greater than 0, infinite for a circle that nothing deflects
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double mass(int i) {
    return masses[at("circle", i, circleCount())];
  }

  /**
   * A line.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return the line
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public Line line(int i) {
    int k = at("line", i, lineCount()) * LINE;
    return new Line(lines[k], lines[k + 1], lines[k + 2], lines[k + 3]);
  }

  /**
   * The restitution of a line.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return at least 0; 1 is elastic
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public double lineRestitution(int i) {
    return lines[at("line", i, lineCount()) * LINE + 4];
  }

  /**
   * The response of circles to a line.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return the response, {@link Response#BOUNCE} unless another was set
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public Response lineResponse(int i) {
    return Traits.response(Traits.of(lineTraits, at("line", i, lineCount())));
  }

  /**
   * Whether a line is there only for circles that come from its left; see {@link
   * SceneBuilder#oneWay()}.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return false unless it was set
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public boolean lineOneWay(int i) {
    return Traits.isOneWay(Traits.of(lineTraits, at("line", i, lineCount())));
  }

  /**
   * A peg.
   *
   * @param i its number, 0..{@link #pegCount()} - 1
   * @return the peg
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public Circle peg(int i) {
    int k = at("peg", i, pegCount()) * PEG;
    return new Circle(pegs[k], pegs[k + 1], pegs[k + 2]);
  }

  /**
   * The restitution of a peg.
   *
   * @param i its number, 0..{@link #pegCount()} - 1
   * @return at least 0; 1 is elastic
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public double pegRestitution(int i) {
    return pegs[at("peg", i, pegCount()) * PEG + 3];
  }

  /**
   * The response of circles to a peg.
   *
   * @param i its number, 0..{@link #pegCount()} - 1
   * @return the response, {@link Response#BOUNCE} unless another was set
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public Response pegResponse(int i) {
    return Traits.response(Traits.of(pegTraits, at("peg", i, pegCount())));
  }

  /**
   * The bounds.
   *
   * @return the rectangle that keeps circles inside, empty if the scene is open
   */
  public Optional<Bounds> bounds() {
    return Optional.ofNullable(bounds);
  }

  /**
   * Whether circles collide with each other.
   *
   * @return false if they ignore each other
   */
  public boolean collide() {
    return collide;
  }

  /**
   * The restitution of the four walls.
   *
   * @return at least 0; 1 is elastic, and 1 if the scene has no bounds
   */
  public double boundsRestitution() {
    return boundsRestitution;
  }

  /**
   * The response of circles to the four walls.
   *
   * @return {@link Response#BOUNCE} or {@link Response#HALT}
   */
  public Response boundsResponse() {
    return Traits.response(boundsTraits);
  }

  /**
   * Two scenes are equal if they hold the same things in the same order, to the bit.
   *
   * @param other any object
   * @return whether it is an equal scene
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof Scene that
        && Arrays.equals(circles, that.circles)
        && Arrays.equals(masses, that.masses)
        && collide == that.collide
        && Arrays.equals(lines, that.lines)
        && Arrays.equals(pegs, that.pegs)
        && Arrays.equals(circleTraits, that.circleTraits)
        && Arrays.equals(lineTraits, that.lineTraits)
        && Arrays.equals(pegTraits, that.pegTraits)
        && boundsTraits == that.boundsTraits
        && Objects.equals(bounds, that.bounds)
        && Double.compare(boundsRestitution, that.boundsRestitution) == 0;
  }

  @Override
  public int hashCode() {
    return Objects.hash(
        Arrays.hashCode(circles), Arrays.hashCode(lines), Arrays.hashCode(pegs), bounds);
  }

  @Override
  public String toString() {
    return "Scene[circles=%d, lines=%d, pegs=%d, bounds=%s]"
        .formatted(circleCount(), lineCount(), pegCount(), bounds == null ? "none" : bounds);
  }

  private static int at(String kind, int i, int count) {
    if (i < 0 || i >= count) {
      throw new IndexOutOfBoundsException(
          kind + " " + i + " does not exist: the scene has " + count + " of them, from 0");
    }
    return i;
  }
}
