// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.io.RowException;
import dev.carom.internal.io.SceneFile;
import dev.carom.internal.query.Warnings;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.util.Check;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * A {@code Scene} describes what exists at time 0: at most one bounds, any number of lines, pegs
 * and moving circles, and the gravity. A {@link World} sets it in motion.
 *
 * <p>A scene is immutable, checked as a whole when it is built, and safe to share between threads.
 * Things of one kind are numbered from 0 in the order in which they were added.
 *
 * <pre>{@code
 * Scene scene = Scene.builder()
 *     .bounds(0, 0, 800, 600)
 *     .line(300, 200, 500, 400).restitution(0.9)
 *     .circle(100, 100, 10, 4, 3)
 *     .build();
 * }</pre>
 *
 * <h2>Files</h2>
 *
 * Scenes are kept as text, in UTF-8: one thing a row, its fields separated by commas.
 *
 * <pre>
 * # xmin, ymin, xmax, ymax
 * wall,0,0,800,600
 * # ax, ay, bx, by
 * line,300,200,500,400,restitution=0.9
 * # x, y of each point; a solid polygon
 * outline,350,500,450,500,400,560,solid=1
 * # x, y, radius
 * peg,600,300,25
 * # x, y, radius, vx, vy and optionally the mass
 * circle,100,100,10,4,3
 * </pre>
 *
 * <ul>
 *   <li>Things of one kind are numbered from 0 in the order of their rows. The kinds may be mixed.
 *   <li>A number is decimal or a hex float ({@code 0x1.8p-3}), read to the nearest double. NaN,
 *       infinities and numbers beyond the range of a double are refused.
 *   <li>{@code wall} is the {@linkplain Bounds bounds}. There is at most one such row. {@code -inf}
 *       and {@code inf} leave a side open.
 *   <li>The mass of a circle is 1 if it is left out. {@code inf} or {@code Infinity} is an infinite
 *       mass. See {@link SceneBuilder#mass}.
 *   <li>With {@code collide,0} circles ignore each other. With {@code collide,1}, or without such a
 *       row, they collide. There is at most one such row.
 *   <li>{@code gravity,gx,gy} is the {@linkplain SceneBuilder#gravity gravity}. There is at most
 *       one such row. Without it, circles fly straight.
 *   <li>The row of a wall, line, outline, peg or circle may end in {@code restitution=NUMBER}.
 *       Without it, it is 1.
 *   <li>{@code outline} is an {@link Outline}, of the kind of lines and numbered among them: a
 *       polyline, or with {@code solid=1} a polygon. Its row may end in all that the row of a line
 *       may end in.
 *   <li>Such a row may end in {@code response=bounce}, {@code response=halt} or {@code
 *       response=sensor}, see {@link Response}. The bounds cannot be a sensor.
 *   <li>Such a row may end in {@code category=INTEGER} and {@code mask=INTEGER}, see {@link
 *       Filter}. Without them, they are 1 and -1.
 *   <li>The row of a line may end in {@code oneway=1}, see {@link SceneBuilder#oneWay()}.
 *   <li>The row of a line or a peg may end in {@code vx=NUMBER} and {@code vy=NUMBER}, see {@link
 *       SceneBuilder#velocity}. Without them, they are 0: the obstacle rests.
 *   <li>The reader skips blank lines, spaces and tabs around fields, {@code #} comments on lines of
 *       their own or after a row, and a byte order mark. It takes either kind of line end.
 * </ul>
 *
 * <p>Everything else is a {@link SceneFormatException}, and nothing is loaded. Its message names
 * file, line, column, the text found there and what was expected, as in {@code scene.csv:12:31:
 * radius is "abc": expected a finite number}. A scene that is written reads back as an equal scene,
 * to the bit.
 */
public final class Scene {

  final SceneData data;

  Scene(SceneData data) {
    this.data = data;
  }

  /**
   * Starts an empty scene.
   *
   * @return a new builder
   */
  public static SceneBuilder builder() {
    return new SceneBuilder(new SceneDataBuilder());
  }

  /**
   * Starts a scene with all that is in this one, which stays as it is.
   *
   * <pre>{@code
   * Scene scene = Scene.builder().peg(60, 30, 5).build();
   * Scene more = scene.toBuilder().circle(20, 20, 5, 1, 0).build();
   * System.out.println(more.count(Kind.PEG) + more.count(Kind.CIRCLE)); // 2
   * }</pre>
   *
   * @return a new builder, whose next thing of each kind gets the number {@link #count}
   */
  public SceneBuilder toBuilder() {
    return new SceneBuilder(new SceneDataBuilder(data));
  }

  /**
   * Reads a scene from a file.
   *
   * @param path the file
   * @return the scene
   * @throws SceneFormatException if the file does not follow the format, or holds what {@link
   *     SceneBuilder} refuses; it gives the line and the column
   * @throws IOException if the file cannot be read
   */
  public static Scene read(Path path) throws IOException {
    Check.notNull("path", path);
    try {
      return new Scene(SceneFile.read(path));
    } catch (RowException e) {
      throw new SceneFormatException(path.toString(), e);
    }
  }

  /**
   * Reads a scene from a reader, to its end.
   *
   * @param in where to read; it is not closed
   * @param name the name to use in messages
   * @return the scene
   * @throws SceneFormatException if the text does not follow the format, or holds what {@link
   *     SceneBuilder} refuses; it gives the line and the column
   * @throws IOException if reading fails
   */
  public static Scene read(Reader in, String name) throws IOException {
    Check.notNull("in", in);
    Check.notNull("name", name);
    try {
      return new Scene(SceneFile.read(in));
    } catch (RowException e) {
      throw new SceneFormatException(name, e);
    }
  }

  /**
   * Writes this scene to a file. An existing file is replaced at the end and as a whole.
   *
   * <p>So a failure leaves the old file as it was, and no other file beside it. Symbolic links
   * stay, and so do the permissions of the file.
   *
   * @param path the file
   * @throws IOException if the file cannot be written; the message names the file and the reason
   */
  public void write(Path path) throws IOException {
    SceneFile.write(data, Check.notNull("path", path));
  }

  /**
   * Writes this scene: whether circles collide, gravity, wall, lines, pegs, circles, each kind in
   * the order of its numbers.
   *
   * @param out where to write; it is neither flushed nor closed
   * @throws IOException if writing fails
   */
  public void write(Appendable out) throws IOException {
    SceneFile.write(data, Check.notNull("out", out));
  }

  /**
   * Returns the number of things of a kind.
   *
   * @param kind their kind
   * @return at least 0
   */
  public int count(Kind kind) {
    int number = Check.notNull("kind", kind).ordinal();
    return kind == Kind.CIRCLE ? data.circleCount() : data.obstacles.count(number);
  }

  /**
   * Returns a circle or an obstacle as it stands at time 0.
   *
   * <pre>{@code
   * Scene scene = Scene.builder().peg(20, 30, 5).build();
   * for (int i = 0; i < scene.count(Kind.PEG); i++) {
   *   Circle peg = (Circle) scene.shape(Kind.PEG, i);
   *   System.out.println(peg.x()); // 20.0
   * }
   * }</pre>
   *
   * @param kind its kind
   * @param i its number: of a wall 0..3, else from 0 to {@link #count} - 1
   * @return a {@link Line} for a line, an {@link Outline} for an outline of more than one side, a
   *     {@link Circle} for a peg or a circle, the {@link Bounds} for a wall
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Obstacle shape(Kind kind, int i) {
    int code = code(kind, i);
    return kind == Kind.CIRCLE
        ? new Circle(data.x(i), data.y(i), data.radius(i))
        : PublicRecords.of(data.obstacles, code, 0);
  }

  /**
   * Returns the velocity of a circle or an obstacle at time 0.
   *
   * @param kind its kind
   * @param i its number: of a wall 0..3, else from 0 to the number of such things less 1
   * @return the velocity; (0, 0) for a wall, and for a line or a peg that does not move
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Vec2 velocity(Kind kind, int i) {
    int code = code(kind, i);
    return kind == Kind.CIRCLE
        ? new Vec2(data.vx(i), data.vy(i))
        : new Vec2(data.obstacles.ux(code), data.obstacles.uy(code));
  }

  /**
   * Returns the traits of a circle or an obstacle: its restitution, mass, response and filter, and
   * whether it is a one-way line.
   *
   * @param kind its kind; the four walls share their traits
   * @param i its number: of a wall 0..3, else from 0 to the number of such things less 1
   * @return the traits; {@link Traits#DEFAULT} unless others were set
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Traits traits(Kind kind, int i) {
    int code = code(kind, i);
    return kind == Kind.CIRCLE
        ? Traits.of(data.registry, i, data.restitution(i))
        : Traits.of(data.obstacles, code);
  }

  /**
   * Returns the bounds of this scene.
   *
   * @return the rectangle that keeps circles inside; empty if the scene is open
   */
  public Optional<Bounds> bounds() {
    return Optional.ofNullable(PublicRecords.bounds(data.obstacles.walls));
  }

  /**
   * Tells whether circles collide with each other.
   *
   * @return false if they ignore each other
   */
  public boolean collide() {
    return data.collide;
  }

  /**
   * Returns the gravity: the acceleration of all circles of finite mass. See {@link
   * SceneBuilder#gravity}.
   *
   * @return the acceleration, in lengths per time squared; (0, 0) if there is none
   */
  public Vec2 gravity() {
    return new Vec2(data.gx, data.gy);
  }

  /**
   * Makes a resolver among the lines, pegs and bounds of this scene, with their restitutions and
   * responses.
   *
   * <p>It meets one-way lines from their left only, and does not know the circles of the scene.
   * Give the circle that is asked about the {@linkplain SceneBuilder#gravity gravity} of the scene
   * as its {@linkplain SweptCircle#withAcceleration acceleration} if it shall fall.
   *
   * <p>Lines and pegs with a velocity are where the scene has them at the start of each cast and of
   * each path, and move from then on. {@link Resolver#nearest nearest} and {@link
   * Resolver#overlapping(Kind, Circle) overlapping} take them where the scene has them.
   *
   * @return a new resolver
   */
  public Resolver resolver() {
    return new Questions(ObstacleTable.of(data));
  }

  /**
   * Lists what is legal but likely a mistake: circles that overlap something at time 0.
   *
   * <p>These are a circle that is not wholly within the bounds, a circle that overlaps a line or a
   * peg, and, where circles collide, two circles that overlap. The decision is exact; to touch is
   * not to overlap.
   *
   * <p>Things that the circle passes through are left out: sensors; a one-way line, unless the
   * centre is strictly left of it; two circles, both of infinite mass; and all that the {@linkplain
   * Filter filters} keep apart.
   *
   * <p>The warnings follow the order of the circles. Those of one circle name walls first (left,
   * right, bottom, top), then lines, pegs, and circles with larger numbers. At most 10,000 are
   * listed. Each call computes them anew; 100,000 circles among 100,000 lines take some seconds.
   *
   * @return the warnings, whose {@code toString} is a sentence for people; unmodifiable, empty if
   *     there are none
   */
  public List<Warning> warnings() {
    return Warnings.of(data).stream().map(this::warning).toList();
  }

  Warning warning(Warnings.Overlap overlap) {
    int code = overlap.code();
    Kind kind = Kind.of(Codes.kind(code));
    int id = Codes.isCircle(code) ? Codes.slot(code) : data.obstacles.id(code);
    return new Warning(overlap.circle(), kind, id, overlap.distance(), overlap.least());
  }

  /**
   * Tells whether another scene holds the same things in the same order, to the bit.
   *
   * @param other any object
   * @return whether it is an equal scene
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof Scene that && data.equals(that.data);
  }

  @Override
  public int hashCode() {
    return data.hashCode();
  }

  @Override
  public String toString() {
    return "Scene[circles=%s, lines=%s, pegs=%s, bounds=%s%s]"
        .formatted(
            count(Kind.CIRCLE),
            count(Kind.LINE),
            count(Kind.PEG),
            PublicRecords.describe(data.obstacles.walls),
            data.hasGravity() ? ", gravity=" + gravity() : "");
  }

  /** Returns the code of a thing that exists; any other one is refused. */
  private int code(Kind kind, int i) {
    int count = count(kind);
    boolean isThere =
        kind == Kind.WALL
            ? data.obstacles.codes(0).anyMatch(wall -> wall == i)
            : i >= 0 && i < count;
    if (!isThere) {
      String others = count == 0 ? "none of them" : count + " of them, from 0";
      throw new IndexOutOfBoundsException(
          kind.nameOf(i) + " does not exist: the scene has " + others);
    }
    return kind == Kind.CIRCLE ? Codes.circle(i) : data.obstacles.code(kind.ordinal(), i);
  }
}
