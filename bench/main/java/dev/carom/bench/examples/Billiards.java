// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.Kind;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.SceneDrawing;
import dev.carom.bench.charts.Still;
import dev.carom.bench.charts.Style;
import dev.carom.bench.charts.WorldScene;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;

/**
 * Billiards, in metres and seconds. Friction is a velocity that is set between frames, a pocket a
 * sensor; the aiming line asks the world what the cue ball would hit first, balls included.
 */
public final class Billiards implements Example {

  private static final double WIDTH = 1.27;
  private static final double LENGTH = 2 * WIDTH;
  private static final double RADIUS = 0.028575;
  private static final int CUE = 0;
  private static final double POCKET = 0.045; // a ball is in when its rim comes to this disk
  private static final double SLOWING = 0.4; // off the speed, in metres a second each second
  private static final double HARDEST = 8; // metres a second, for a drag of a metre
  private static final Color[] COLORS = {Style.ORANGE, Style.BLUE, Style.VERMILION, Style.YELLOW};

  final World world;
  private final SceneDrawing drawing;
  private Rectangle2D shown = new Rectangle2D.Double(0, 0, 840, 640);
  private Vec2 from;
  private Vec2 mouse = new Vec2(LENGTH, WIDTH / 2);

  /** Sets up the table: fifteen balls lie as close as they can. */
  public Billiards() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, LENGTH, WIDTH).restitution(0.8);
    for (int i = 0; i < 6; i++) {
      scene.peg(i % 3 * LENGTH / 2, i < 3 ? 0 : WIDTH, POCKET).response(Response.SENSOR);
    }
    double each = StrictMath.sqrt(0.95); // the product of the two is the restitution of a pair
    scene.circle(LENGTH / 4, WIDTH / 2, RADIUS, 0, 0).restitution(each);
    for (int row = 0; row < 5; row++) {
      for (int i = 0; i <= row; i++) {
        double x = 0.75 * LENGTH + row * StrictMath.sqrt(3) * RADIUS * 1.0001;
        double y = WIDTH / 2 + (2 * i - row) * RADIUS * 1.0001;
        scene.circle(x, y, RADIUS, 0, 0).restitution(each);
      }
    }
    world = new World(scene.build());
    Style.Scheme cloth = Style.Scheme.LIGHT.withFloor(Style.mix(Style.GREEN, Color.WHITE, 0.5));
    drawing = SceneDrawing.of(world.scene()).withScheme(cloth).withMargin(24).withArrowTime(0);
  }

  @Override
  public void frame() {
    for (int id : world.ids(Kind.CIRCLE)) { // the cloth; what is slower stops
      double speed = Math.sqrt(world.vx(id) * world.vx(id) + world.vy(id) * world.vy(id));
      double left = speed > 0 ? Math.max(0, 1 - SLOWING / FRAMES / speed) : 0;
      world.setVelocity(id, left * world.vx(id), left * world.vy(id));
    }
    world.step(1.0 / FRAMES);
    pocket();
  }

  /** Takes the balls that met a pocket off the table. */
  private void pocket() {
    for (Impact hit : world.impacts()) {
      boolean met = hit.kind() == Kind.PEG;
      if (met && hit.circle() == CUE) { // back to the table
        world.setPosition(CUE, LENGTH / 4, WIDTH / 2);
        world.setVelocity(CUE, 0, 0);
      } else if (met && world.contains(Kind.CIRCLE, hit.circle())) {
        world.remove(Kind.CIRCLE, hit.circle());
      }
    }
  }

  /** The first impact of a shot; none while the cue ball rolls. */
  Optional<Impact> target() {
    Circle cue = new Circle(world.x(CUE), world.y(CUE), RADIUS);
    SweptCircle way = new SweptCircle(cue, shot());
    boolean rests = world.vx(CUE) == 0 && world.vy(CUE) == 0;
    return rests ? world.cast(way, Double.POSITIVE_INFINITY) : Optional.empty();
  }

  private Vec2 shot() {
    Vec2 to = from == null ? mouse : from;
    Vec2 at = from == null ? new Vec2(world.x(CUE), world.y(CUE)) : mouse;
    return new Vec2(HARDEST * (to.x() - at.x()), HARDEST * (to.y() - at.y()));
  }

  @Override
  public void point(Vec2 at) {
    mouse = drawing.place(shown, at);
  }

  @Override
  public void press() {
    from = mouse;
  }

  @Override
  public void release() {
    world.setVelocity(CUE, shot().x(), shot().y());
    from = null;
  }

  @Override
  public String hint() {
    return "Press anywhere, drag back as with a cue, and let go: the longer, the harder.";
  }

  @Override
  public void draw(Graphics2D g, Rectangle2D area) {
    shown = area;
    Scene now = WorldScene.of(world);
    int[] ids = world.ids(Kind.CIRCLE);
    Still balls = Still.of(now).colored(i -> ids[i] == CUE ? Color.WHITE : COLORS[ids[i] % 4]);
    drawing.withScene(now).draw(g, area, balls);
    target().ifPresent(impact -> aim(g, area, impact));
  }

  private void aim(Graphics2D g, Rectangle2D area, Impact impact) {
    double x = world.x(CUE) + shot().x() * impact.time();
    double y = world.y(CUE) + shot().y() * impact.time();
    g.transform(drawing.transform(area));
    g.setColor(Style.INK);
    g.setStroke(Style.dashes(0.005, 0.02, 0.015));
    g.draw(new Line2D.Double(world.x(CUE), world.y(CUE), x, y));
    g.setStroke(Style.line(0.005));
    g.draw(new Ellipse2D.Double(x - RADIUS, y - RADIUS, 2 * RADIUS, 2 * RADIUS));
    if (impact.kind() == Kind.CIRCLE) {
      double ax = impact.x() - RADIUS * impact.nx();
      double ay = impact.y() - RADIUS * impact.ny();
      g.draw(new Line2D.Double(ax, ay, ax - 0.25 * impact.nx(), ay - 0.25 * impact.ny()));
    }
  }
}
