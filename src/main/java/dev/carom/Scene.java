// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.io.RowException;
import dev.carom.internal.io.SceneFile;
import dev.carom.internal.query.Warnings;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.ContactFlags;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.util.Check;
import dev.carom.internal.util.Kind;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Path;
import java.util.List;
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
 * # x, y, radius
 * peg,600,300,25
 * # x, y, radius, vx, vy and, if need be, the mass
 * circle,100,100,10,4,3
 * </pre>
 *
 * <ul>
 *   <li>Things of one kind are numbered from 0 in the order of their rows; the kinds may be mixed.
 *   <li>A number is decimal or a hex float ({@code 0x1.8p-3}), read to the nearest double. NaN,
 *       infinities and numbers beyond the range of a double are refused.
 *   <li>{@code wall} is the {@linkplain Bounds bounds}; there is at most one such row.
 *   <li>The mass of a circle is 1 if not given; {@code inf} or {@code Infinity} stand for an
 *       infinite one. It has no effect as long as circles ignore each other.
 *   <li>{@code collide,1} says that circles collide with each other; with {@code collide,0}, or
 *       without such a row, they ignore each other.
 *   <li>Any row but {@code collide} may end in {@code restitution=NUMBER}; without it, it is 1.
 *   <li>Any row but {@code collide} may end in {@code response=bounce}, {@code halt} or {@code
 *       sensor}, of the bounds not the last of them, see {@link Response}; a line's row in {@code
 *       oneway=1}, see {@link SceneBuilder#oneWay()}.
 *   <li>Blank lines, spaces and tabs around fields, {@code #} comments on lines of their own or
 *       after a row, either kind of line end, and a byte order mark are passed over.
 * </ul>
 *
 * <p>Everything else is a {@link SceneFormatException} whose message names file, line, column, what
 * stands there and what was expected, as {@code scene.csv:12:31: radius is "abc": expected a finite
 * number}; nothing is loaded then. What is written reads back as an equal scene, to the bit.
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
    return new SceneBuilder();
  }

  /**
   * Reads a scene from a file.
   *
   * @param path the file
   * @return the scene
   * @throws SceneFormatException if the file does not follow the format, or holds what {@link
   *     SceneBuilder} refuses; it tells the line and the column
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
   * Reads a scene.
   *
   * @param in where to read, to its end; it is not closed
   * @param name what to call it in messages
   * @return the scene
   * @throws SceneFormatException if the text does not follow the format, or holds what {@link
   *     SceneBuilder} refuses; it tells the line and the column
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
   * Writes this scene to a file; one that stands there is replaced, at the end and as a whole, so
   * that a failure leaves it as it was, and nothing beside it. Symbolic links stay, and who may
   * read the file stays the same.
   *
   * @param path the file
   * @throws IOException if the file cannot be written; the message names it, and why
   */
  public void write(Path path) throws IOException {
    SceneFile.write(data, Check.notNull("path", path));
  }

  /**
   * Writes this scene: wall, lines, pegs, circles, each kind in the order of its numbers.
   *
   * @param out where to write; it is neither flushed nor closed
   * @throws IOException if writing fails
   */
  public void write(Appendable out) throws IOException {
    SceneFile.write(data, Check.notNull("out", out));
  }

  /**
   * The number of moving circles.
   *
   * @return at least 0
   */
  public int circleCount() {
    return data.circleCount();
  }

  /**
   * The number of lines.
   *
   * @return at least 0
   */
  public int lineCount() {
    return data.obstacles.ofKind(Kind.LINE).count();
  }

  /**
   * The number of pegs.
   *
   * @return at least 0
   */
  public int pegCount() {
    return data.obstacles.ofKind(Kind.PEG).count();
  }

  /**
   * A circle as it stands at time 0.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return the circle
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public Circle circle(int i) {
    at(ObstacleKind.CIRCLE, i);
    return new Circle(data.x(i), data.y(i), data.radius(i));
  }

  /**
   * The velocity of a circle at time 0.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return the velocity
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public Vec2 velocity(int i) {
    at(ObstacleKind.CIRCLE, i);
    return new Vec2(data.vx(i), data.vy(i));
  }

  /**
   * The mass of a circle; without effect as long as circles ignore each other.
   *
   * @param i its number, 0..{@link #circleCount()} - 1
   * @return greater than 0, infinite for a circle that nothing deflects
   * @throws IndexOutOfBoundsException if there is no such circle
   */
  public double mass(int i) {
    return data.masses[at(ObstacleKind.CIRCLE, i)];
  }

  /**
   * A line.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return the line
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public Line line(int i) {
    return PublicRecords.line(data.obstacles, Codes.line(at(ObstacleKind.LINE, i)));
  }

  /**
   * A peg.
   *
   * @param i its number, 0..{@link #pegCount()} - 1
   * @return the peg
   * @throws IndexOutOfBoundsException if there is no such peg
   */
  public Circle peg(int i) {
    return PublicRecords.peg(data.obstacles, Codes.peg(at(ObstacleKind.PEG, i)));
  }

  /**
   * The restitution of something; that of an impact is the product of the two parties'
   * restitutions.
   *
   * @param kind its kind; the four walls have the same one
   * @param i its number: of a wall 0..3, else from 0 to the number of such things less 1
   * @return at least 0; 1, elastic, unless another was set
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public double restitution(ObstacleKind kind, int i) {
    at(kind, i);
    return kind == ObstacleKind.CIRCLE
        ? data.restitution(i)
        : data.obstacles.givenRestitution(Codes.of(kind.ordinal(), i));
  }

  /**
   * What happens when a circle meets something.
   *
   * @param kind its kind; the four walls have the same response
   * @param i its number: of a wall 0..3, else from 0 to the number of such things less 1
   * @return the response, {@link Response#BOUNCE} unless another was set; of a circle, to other
   *     circles
   * @throws IndexOutOfBoundsException if there is no such thing
   */
  public Response response(ObstacleKind kind, int i) {
    return Response.of(ContactFlags.response(traits(kind, at(kind, i))));
  }

  /**
   * Whether a line is there only for circles that come from its left; see {@link
   * SceneBuilder#oneWay()}.
   *
   * @param i its number, 0..{@link #lineCount()} - 1
   * @return false unless it was set
   * @throws IndexOutOfBoundsException if there is no such line
   */
  public boolean oneWay(int i) {
    return ContactFlags.isOneWay(traits(ObstacleKind.LINE, at(ObstacleKind.LINE, i)));
  }

  /**
   * The bounds.
   *
   * @return the rectangle that keeps circles inside, empty if the scene is open
   */
  public Optional<Bounds> bounds() {
    return Optional.ofNullable(PublicRecords.bounds(data.obstacles.walls));
  }

  /**
   * Whether circles collide with each other.
   *
   * @return false if they ignore each other
   */
  public boolean collide() {
    return data.collide;
  }

  /**
   * A resolver among the lines, pegs and bounds of this scene, with their restitutions and
   * responses. It passes through sensors, and meets one-way lines from their left only. The circles
   * of the scene are not there.
   *
   * @return a new resolver
   */
  public Resolver resolver() {
    ObstacleTable obstacles = ObstacleTable.of(data);
    return new Resolver(obstacles, code -> PublicRecords.of(obstacles, code));
  }

  /**
   * What is likely a mistake, though it is legal: circles that begin where things overlap them.
   * These are a circle that is not wholly within the bounds; one that overlaps a line or a peg;
   * and, where circles collide, two that overlap. Decided exactly; to touch is not to overlap.
   *
   * <p>What a circle passes through is left out: sensors; a one-way line, unless the centre is
   * strictly left of it; and of two circles, both of infinite mass.
   *
   * <p>Each text names the circle, the other thing, the distance of the centre from it, rounded,
   * and the least distance that was expected. They stand in the order of the circles; of one
   * circle, first the walls (left, right, bottom, top), then lines, pegs, and circles with larger
   * numbers. At most 10,000 are listed. They are computed with each call; 100,000 circles among
   * 100,000 lines take some seconds.
   *
   * @return the warnings, to be read by people; unmodifiable, empty if there are none
   */
  public List<String> warnings() {
    return Warnings.of(data);
  }

  /**
   * Two scenes are equal if they hold the same things in the same order, to the bit.
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
    return "Scene[circles=%d, lines=%d, pegs=%d, bounds=%s]"
        .formatted(
            circleCount(), lineCount(), pegCount(), PublicRecords.describe(data.obstacles.walls));
  }

  /** The {@link ContactFlags} of a thing that is there. */
  private int traits(ObstacleKind kind, int i) {
    return kind == ObstacleKind.CIRCLE
        ? ContactFlags.of(data.circleTraits, i)
        : data.obstacles.traits(Codes.of(kind.ordinal(), i));
  }

  private int count(ObstacleKind kind) {
    return switch (kind) {
      case WALL -> data.obstacles.walls == null ? 0 : Codes.WALLS;
      case CIRCLE -> circleCount();
      default -> data.obstacles.ofKind(kind.ordinal()).count();
    };
  }

  /** A number of a thing that is there. */
  private int at(ObstacleKind kind, int i) {
    int count = count(Check.notNull("kind", kind));
    if (i < 0 || i >= count) {
      String others = count == 0 ? "none of them" : count + " of them, from 0";
      throw new IndexOutOfBoundsException(
          kind.nameOf(i) + " does not exist: the scene has " + others);
    }
    return i;
  }
}
