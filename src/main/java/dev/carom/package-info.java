// SPDX-License-Identifier: Apache-2.0

/**
 * Carom moves circles that bounce: off lines and their endpoints, off pegs and walls, and off each
 * other. It finds every impact exactly, and resolves it at its own moment, whatever the speed.
 *
 * <p>A first program, after {@code import dev.carom.*;}: a circle of radius 5 flies to the right at
 * speed 20, hits a line at time 0.5, and is back where it began at time 1:
 *
 * <pre>{@code
 * World world =
 *     new World(Scene.builder().line(0, 0, 0, 10).circle(-15, 4, 5, 20, 0).build());
 * world.step(1);
 * System.out.println(world.impacts().time(0) + ", " + world.x(0)); // 0.5, -15.0
 * }</pre>
 *
 * <p>Take it where nothing but circles bounces, and where wrong, missed or trembling bounces
 * matter: billiards, pinball, breakout, gases, particles, replays, netcode. Take an engine of rigid
 * bodies for rotation, friction, joints, stacks of boxes, or bodies that are no circles.
 *
 * <p>Guides: <a href="doc-files/recipes.html">Recipes</a> for common tasks, <a
 * href="doc-files/sweeps.html">Sweeps</a> over many scenes on many cores or machines, and <a
 * href="doc-files/rules.html">Rules and limits</a> for what can go wrong.
 *
 * <h2 id="layers">Four layers</h2>
 *
 * Each layer uses only those before it, and is useful without those after it.
 *
 * <ol>
 *   <li>Geometry: the records {@link dev.carom.Vec2}, {@link dev.carom.Circle}, {@link
 *       dev.carom.Line} with its endpoints, and {@link dev.carom.Bounds}. Each but {@code Vec2} is
 *       an {@link dev.carom.Obstacle}. They are checked when they are made, so no other method
 *       meets a NaN in one.
 *   <li>Detector: {@link dev.carom.SweptCircle} tells when a moving circle hits an obstacle or
 *       another circle. One form of each question takes and returns doubles, {@code +infinity} for
 *       never. The other takes a record and returns an {@link dev.carom.Impact}, with the {@link
 *       dev.carom.Kind} and the {@link dev.carom.Feature} that was hit. {@link
 *       dev.carom.SweptSphere} answers for two spheres in space.
 *   <li>Resolver: {@link dev.carom.Resolver} follows one circle through given obstacles for a given
 *       time, all bounces included, and returns its {@link dev.carom.Trajectory}. It also computes
 *       the velocities of one circle, or of two, after an impact.
 *   <li>World: a {@link dev.carom.Scene} describes what exists at time 0, and with which {@link
 *       dev.carom.Response}. It is built by a {@link dev.carom.SceneBuilder} or read from a file. A
 *       {@link dev.carom.World} sets it in motion, and its {@link dev.carom.ImpactLog} lists the
 *       impacts. A {@link dev.carom.Snapshot} saves the state of a world, to go on from it later. A
 *       {@link dev.carom.Timeline} records where its circles were. An {@link dev.carom.Uncertainty}
 *       tells how far their places can be trusted.
 * </ol>
 *
 * The program above asks the world. The same question to each of the other layers, after {@code
 * import java.util.List;} too:
 *
 * <pre>{@code
 * Line line = new Line(0, 0, 0, 10);
 * System.out.println(line.closestPoint(new Vec2(-15, 4))); // Vec2[x=0.0, y=4.0]
 *
 * Circle circle = new Circle(-15, 4, 5);
 * Vec2 velocity = new Vec2(20, 0);
 * System.out.println(new SweptCircle(circle, velocity).cast(line, 1).get().time()); // 0.5
 *
 * Trajectory path = Resolver.of(List.of(line)).trace(new SweptCircle(circle, velocity), 1, 1, 9);
 * System.out.println(path.end()); // Vec2[x=-15.0, y=4.0]
 * }</pre>
 *
 * <h2 id="guarantees">Guarantees</h2>
 *
 * <ul>
 *   <li>Exact per query: each decision, hit or miss, side or end, is that of arithmetic without
 *       rounding on the given doubles. The time of impact is the double nearest to the true one.
 *   <li>Rounded from state to state: after each impact the new position and velocity are rounded to
 *       doubles. See <a href="doc-files/rules.html#accuracy">Accuracy</a>.
 *   <li>A step resolves all impacts in it, each at its own moment, any number of them. However a
 *       run to the same time is cut into steps, it gives the same bits.
 *   <li>There is no cap on speed, and positions are never corrected. Without gravity there is no
 *       threshold below which a bounce is dropped, and circles in contact do not jitter.
 *   <li>A step costs what happens in it: among obstacles at rest, a circle that hits nothing costs
 *       one comparison. Circles that collide also pay for the cells of a grid that they enter. A
 *       step allocates memory only while a timeline is recorded, when its log or another list
 *       grows, when exact arithmetic has to decide, when a circle jams, after edits, and under
 *       gravity when circles settle, slide or lie on each other.
 *   <li>A step always ends. If its budget is spent, it throws {@link
 *       dev.carom.UnfinishedException}, and the next call goes on. A circle that would bounce at
 *       one place without end stops bouncing there, and the log says so.
 * </ul>
 *
 * <h2 id="conventions">Conventions</h2>
 *
 * <ul>
 *   <li>Units are the caller's: any unit of length, any unit of time, and speeds in lengths per
 *       time. No rule has a fixed length, time or speed in it, so any ordinary unit will do.
 *   <li>The x axis points right. Whether y points up or down changes names only. The bottom wall is
 *       the one at the smaller y. The left side of a line from a to b is where {@code cross(b - a,
 *       p - a) > 0}; on a screen with y down it looks like the right side.
 *   <li>A normal points from the obstacle to the circle; of two circles, from the second to the
 *       first.
 *   <li>Lines are solid from both sides. The direction of a line matters for three things: which
 *       end is the {@linkplain dev.carom.Feature#START start}, {@linkplain
 *       dev.carom.SceneBuilder#oneWay one-way lines}, and the {@linkplain
 *       dev.carom.Circle#separation separation} of a centre exactly on the line.
 *   <li>The restitution of an impact is the product of those of the two parties.
 *   <li>An impact is the first moment at which a circle touches or overlaps a thing and approaches
 *       it. To touch is to have the centre as far from a line or a wall as the radius, and from a
 *       peg or another circle as both radii together. A circle that touches something and leaves it
 *       or slides along it makes no impact. A circle that overlaps something and approaches it
 *       makes one at once.
 * </ul>
 *
 * <p><img src="doc-files/line.svg" alt="A circle that touches the side of a line, and one that
 * touches its end: the normal points from the line to the centre" style="max-width:100%">
 *
 * <h2 id="errors">Errors</h2>
 *
 * <ul>
 *   <li>A number out of its range throws an {@link java.lang.IllegalArgumentException}.
 *   <li>The id of a thing that does not exist, and the number of a row that the log does not have,
 *       throw an {@link java.lang.IndexOutOfBoundsException}. A timeline instead throws an {@link
 *       java.lang.IllegalArgumentException} for circles and times that it does not know.
 *   <li>A builder's call out of order throws an {@link java.lang.IllegalStateException}. So does
 *       adding a thing when all ids of its kind were given.
 *   <li>A null argument, or a null in a list, throws a {@link java.lang.NullPointerException}. The
 *       methods do not repeat this.
 *   <li>A scene file with a mistake throws a {@link dev.carom.SceneFormatException}.
 * </ul>
 *
 * The messages name the thing, the value and what was expected. A refused argument changes nothing.
 *
 * <h2 id="determinism">Determinism</h2>
 *
 * The same scene and the same calls give the same impacts, bit for bit, on every Java 17 or newer
 * virtual machine. Trajectories are computed with correctly rounded operations and {@link
 * java.lang.StrictMath} alone, in a fixed order. The bits do not depend on how the time is cut into
 * steps, as long as it ends at the same moment and nothing is edited between. {@link
 * dev.carom.World#advanceTo(double) World.advanceTo} names that moment exactly.
 *
 * <p>Without fused multiply-add in hardware, or with {@code -XX:-UseFMA}, the bits are the same,
 * but each such operation takes big numbers: a frame of 100 circles among 100 lines then took 1.8
 * ms instead of 1.1 us.
 *
 * <h2 id="threads">Threads</h2>
 *
 * Any number of threads may use records, scenes, resolvers, trajectories, snapshots and all static
 * methods at once. A {@link dev.carom.World}, with its log and its timeline, belongs to one thread
 * at a time, and so does a {@link dev.carom.SceneBuilder}. Different worlds share nothing that
 * changes, even if they are made of the same scene.
 *
 * <h2 id="limits">Limits</h2>
 *
 * <ul>
 *   <li>Between impacts circles move straight on, or under one constant {@linkplain
 *       dev.carom.SceneBuilder#gravity gravity} on parabolas. There is no rotation, friction or
 *       polygon. Heaps come to rest. Steering is a velocity that the caller sets between steps.
 *   <li>Lines and pegs rest, or move with a {@linkplain dev.carom.World#setVelocity(Kind, int,
 *       double, double) constant velocity} and push circles. They do not turn, and nothing deflects
 *       them.
 *   <li>Without gravity, nothing comes to rest by a threshold. With it, bounces end by <a
 *       href="doc-files/rules.html#gravity">relative lengths</a>. A circle in a narrow place makes
 *       all of its bounces, up to about 1,000 elastic ones at one place. Then the world <a
 *       href="doc-files/rules.html#stuck">stops them</a> and reports it.
 *   <li>Every bounce off a curved obstacle magnifies the rounding errors before it.
 *   <li>A scene refuses circles so small, beside its coordinates, that rounding could carry one
 *       through a line. A circle of radius 0, a point particle, is for scenes without lines; casts
 *       may have radius 0 anywhere: rays.
 * </ul>
 *
 * <h2 id="glossary">Glossary</h2>
 *
 * <dl>
 *   <dt>budget
 *   <dd>The work that one step may do. If it is spent, the call throws, unfinished: see <a
 *       href="doc-files/rules.html#unfinished">unfinished steps</a>.
 *   <dt>filter
 *   <dd>The category and the mask of a thing, which say what it can meet: see {@link
 *       dev.carom.Filter}.
 *   <dt>flight
 *   <dd>The motion of one circle between two impacts: a straight line, with gravity an arc of a
 *       parabola. An edit of the circle begins a new one.
 *   <dt>id
 *   <dd>The number that names a line, a peg or a circle of a world. The ids of each kind begin at
 *       0, and an id is not used again.
 *   <dt>impact
 *   <dd>The moment at which a circle reaches an obstacle or another circle that it approaches; also
 *       the {@linkplain dev.carom.Impact record} of it.
 *   <dt>jam
 *   <dd>A circle is jammed when it is stuck or squeezed, and no longer bounces there. It and what
 *       it touches ignore each other as long as they approach no faster than rounding error. See <a
 *       href="doc-files/rules.html#stuck">stuck circles</a>.
 *   <dt>normal
 *   <dd>The unit vector at a contact, from the obstacle to the circle.
 *   <dt>obstacle
 *   <dd>A line, a peg or a wall. The type {@link dev.carom.Obstacle} is the shape of all that a
 *       circle can hit, other circles too.
 *   <dt>one-way
 *   <dd>A line that is solid for circles that come from its left, and does not exist for others.
 *   <dt>peg
 *   <dd>A round obstacle. Its radius may be 0: a point.
 *   <dt>restitution
 *   <dd>The factor by which an impact scales the speed along the normal: 1 is elastic, 0 keeps no
 *       motion along it, above 1 is a bumper.
 *   <dt>sensor
 *   <dd>A line, peg or circle that reports contacts and lets circles pass: {@link
 *       dev.carom.Response#SENSOR}.
 *   <dt>stuck
 *   <dd>A circle is stuck when it made too many impacts at one place: see <a
 *       href="doc-files/rules.html#stuck">stuck circles</a>.
 *   <dt>ulp
 *   <dd>The distance from a double to the next one, some 2^-52 of it.
 *   <dt>unfinished
 *   <dd>A call that spent its budget, and threw: the world stands at an earlier time than was
 *       requested, or at the requested one with impacts still to come.
 * </dl>
 */
package dev.carom;
