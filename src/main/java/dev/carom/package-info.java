// SPDX-License-Identifier: Apache-2.0

/**
 * Circles that move and bounce: against lines and their endpoints, against pegs and walls, and
 * against each other. Every impact inside a step is found and resolved at its own moment, whatever
 * the speed.
 *
 * <h2>Four layers</h2>
 *
 * Each uses only those before it, and is of use without those after it.
 *
 * <ol>
 *   <li>Geometry: the records {@link dev.carom.Vec2}, and as {@link dev.carom.Obstacle}s {@link
 *       dev.carom.Circle}, {@link dev.carom.Line}, {@link dev.carom.Endpoint} and {@link
 *       dev.carom.Bounds}. They are checked when they are made, so no other method meets a NaN in
 *       one.
 *   <li>Detector: {@link dev.carom.SweptCircle} answers when a moving circle meets an obstacle or
 *       another circle. Its hot form takes and returns doubles, {@code +infinity} for never; its
 *       friendly form returns an {@link dev.carom.Impact}, which tells the {@link
 *       dev.carom.ObstacleKind} and the {@link dev.carom.Feature} that was hit. {@link
 *       dev.carom.SweptSphere} answers for two spheres in space.
 *   <li>Resolver: {@link dev.carom.Resolver} follows one circle through given obstacles for a given
 *       time, all bounces included: its way is a {@link dev.carom.Trajectory}. It also tells what
 *       an impact does to the velocities of one circle, or of two.
 *   <li>World: a {@link dev.carom.Scene}, made by a {@link dev.carom.SceneBuilder} or read from a
 *       file, says what is there at time 0, and with which {@link dev.carom.Response}; a {@link
 *       dev.carom.World} sets it in motion, and its {@link dev.carom.ImpactLog} tells what hit
 *       what; a {@link dev.carom.Snapshot} holds all that determines its future, a {@link
 *       dev.carom.Timeline} its past.
 * </ol>
 *
 * One question to each, in turn:
 *
 * <pre>{@code
 * Line line = new Line(0, 0, 0, 10);
 * System.out.println(line.closestPoint(new Vec2(-15, 4))); // Vec2[x=0.0, y=4.0]
 *
 * Circle circle = new Circle(-15, 4, 5);
 * Vec2 velocity = new Vec2(20, 0);
 * System.out.println(SweptCircle.cast(circle, velocity, line, 1).get().time()); // 0.5
 *
 * Trajectory way = Resolver.of(List.of(line)).trace(circle, velocity, 1);
 * System.out.println(way.end()); // Vec2[x=-15.0, y=4.0]
 *
 * World world =
 *     new World(Scene.builder().line(0, 0, 0, 10).circle(-15, 4, 5, 20, 0).build());
 * world.step(1);
 * System.out.println(world.x(0) + ", " + world.impacts().size()); // -15.0, 1
 * }</pre>
 *
 * <h2>What is promised</h2>
 *
 * <ul>
 *   <li>Every decision, hit or miss, side or end, is that of real arithmetic on the given doubles;
 *       the time of impact is the correctly rounded one.
 *   <li>All impacts inside a step are resolved, each at its own moment, any number of them; how a
 *       run is cut into steps changes no bit of it.
 *   <li>There is no threshold below which a bounce is dropped, no cap on speed, no slop; positions
 *       are never nudged, and what touches does not jitter.
 *   <li>A step costs what happens in it. It allocates nothing, unless it records, its log or
 *       another list grows, exact arithmetic has to decide, a circle jams, or edits made grids or
 *       arrays stale.
 *   <li>It always ends: where impacts at one place would go on for ever, the circle is stuck, its
 *       contacts act at once without bounce, and the log says so; a step that runs out of its
 *       budget says that it is unfinished.
 * </ul>
 *
 * <p><img src="doc-files/line.svg" alt="A circle that touches the side of a line, and one that
 * touches its end: the normal points from the line to the centre" style="max-width:100%">
 *
 * <h2>Conventions</h2>
 *
 * <ul>
 *   <li>Units are the caller's: any unit of length, any unit of time, speeds in the one per the
 *       other. There are no tuned constants that a unit could be too large or too small for.
 *   <li>The x axis points right. Whether y points up or down changes nothing but the names of two
 *       walls: the bottom one is that at the smaller y.
 *   <li>A normal is a unit vector from the obstacle to the circle; of two circles, from the second
 *       to the first. Lines are solid from both sides; their direction matters for which end is
 *       called {@linkplain dev.carom.Feature#START start}, for {@linkplain
 *       dev.carom.SceneBuilder#oneWay one-way lines}, and for the {@linkplain
 *       dev.carom.SweptCircle#separation(Circle, Line) separation} of a centre exactly on the line.
 *   <li>Restitution acts along the normal: 1 is elastic, 0 keeps no motion along it, above 1 is a
 *       bumper. That of an impact is the product of the two parties'.
 *   <li>An impact is the first moment at which the distance is at most the radius and falling. To
 *       touch and leave, or to slide along, is none; to overlap and come nearer is one, at once.
 *       Positions are never corrected.
 *   <li>Numbers out of their range throw {@link java.lang.IllegalArgumentException}, numbers of
 *       things that do not exist {@link java.lang.IndexOutOfBoundsException}; a timeline refuses
 *       ids and times alike by {@link java.lang.IllegalArgumentException}. A builder's call out of
 *       order is an {@link java.lang.IllegalStateException}, and so is a thing to be added when all
 *       ids of its kind were given. The messages name the thing, the value and what was expected. A
 *       null is a {@link java.lang.NullPointerException}.
 * </ul>
 *
 * <h2>Determinism</h2>
 *
 * Trajectories are computed with {@code + - * /}, square root and fused multiply-add alone, in a
 * fixed order: the same scene gives the same impacts, bit for bit, on every Java 17 or newer
 * virtual machine. Without fused multiply-add in hardware, or with {@code -XX:-UseFMA}, the bits
 * are the same, but each one is computed by big numbers: a frame of the experiment ({@code
 * base-1.csv}) then took 1.8 ms instead of 1.1 us. Nor does it matter how the time is cut into
 * steps, as long as it ends at the same moment and nothing is edited between.
 *
 * <h2>Threads</h2>
 *
 * Records, scenes, resolvers, trajectories, snapshots and all static methods may be used by any
 * number of threads at once. A {@link dev.carom.World}, with its log and its timeline, and a {@link
 * dev.carom.SceneBuilder} belong to one thread at a time; different worlds share nothing that
 * changes, even if they are made of the same scene.
 *
 * <h2>What the method gives up</h2>
 *
 * <ul>
 *   <li>Only circles move, and straight on between impacts: no rotation, friction, stacking,
 *       polygons or forces. Gravity and steering are velocities that the caller sets between steps.
 *   <li>Nothing comes to rest by a threshold. A circle caught in a narrow place costs every one of
 *       its bounces; where they would never end, the world stops them by a rule and reports it.
 *   <li>Each question is answered for the doubles that it is asked with, but a trajectory is a
 *       chain of rounded states, and every bounce off a curved obstacle magnifies what went before.
 *   <li>A scene refuses circles so small, beside its coordinates, that rounding could carry one
 *       through a line.
 * </ul>
 */
package dev.carom;
