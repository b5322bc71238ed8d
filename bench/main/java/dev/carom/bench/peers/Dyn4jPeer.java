// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.Vec2;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/**
 * dyn4j, with one body a line: many lines of one body are not told apart by its continuous
 * detection. At its best no bounce is too slow to keep its speed, nothing falls asleep, circles are
 * bullets, and the cap on the motion of a step is out of reach.
 */
final class Dyn4jPeer extends Peer {

  private static final CategoryFilter CIRCLES = new CategoryFilter(1, 2);
  private static final CategoryFilter COLLIDING = new CategoryFilter(1, 3);
  private static final CategoryFilter LINES = new CategoryFilter(2, 1);
  private static final double NO_CAP = 1e6;

  private final boolean best;
  private final World<Body> world = new World<>();
  private final Body[] circles;

  Dyn4jPeer(Scene scene, boolean best) {
    super(scene, best ? metreFor(scene, 10, 1.6) : USUAL_METRE, SECONDS_PER_FRAME);
    this.best = best;
    Vec2 g = scene.gravity();
    world.setGravity(metresPerSecondSquared(g.x()), metresPerSecondSquared(g.y()));
    if (best) {
      Settings settings = world.getSettings();
      settings.setAtRestDetectionEnabled(false);
      settings.setMaximumTranslation(NO_CAP);
    }
    edges(scene).forEach(this::addLine);
    circles = new Body[scene.count(Kind.CIRCLE)];
    for (int i = 0; i < circles.length; i++) {
      circles[i] = addCircle(scene, i);
    }
  }

  private void addLine(Edge edge) {
    Line line = edge.line();
    Vector2 a = new Vector2(metres(line.ax()), metres(line.ay()));
    Vector2 b = new Vector2(metres(line.bx()), metres(line.by()));
    Body body = body(Geometry.createSegment(a, b), LINES, edge.restitution());
    body.setMass(MassType.INFINITE);
    world.addBody(body);
  }

  private Body addCircle(Scene scene, int i) {
    CategoryFilter filter = scene.collide() ? COLLIDING : CIRCLES;
    Convex disk = Geometry.createCircle(metres(((Circle) scene.shape(Kind.CIRCLE, i)).radius()));
    Body body = body(disk, filter, circleRestitution(scene));
    body.setMass(MassType.NORMAL);
    if (scene.collide()) {
      setMass(body, scene.traits(Kind.CIRCLE, i).mass());
    }
    body.setBullet(best);
    body.translate(
        metres(((Circle) scene.shape(Kind.CIRCLE, i)).x()),
        metres(((Circle) scene.shape(Kind.CIRCLE, i)).y()));
    Vec2 v = scene.velocity(Kind.CIRCLE, i);
    body.setLinearVelocity(metresPerSecond(v.x()), metresPerSecond(v.y()));
    body.setGravityScale(falls(scene, i) ? 1 : 0);
    world.addBody(body);
    return body;
  }

  /** Inertia is scaled along; nothing here makes a circle turn. */
  private static void setMass(Body body, double mass) {
    Mass own = body.getMass();
    double scale = mass / own.getMass();
    body.setMass(new Mass(own.getCenter(), mass, scale * own.getInertia()));
  }

  private Body body(Convex shape, CategoryFilter filter, double restitution) {
    Body body = new Body();
    BodyFixture fixture = body.addFixture(shape);
    fixture.setFriction(0);
    fixture.setRestitution(restitution);
    fixture.setFilter(filter);
    if (best) {
      fixture.setRestitutionVelocity(0);
    }
    return body;
  }

  @Override
  public void frame() {
    world.step(1);
  }

  @Override
  public double x(int circle) {
    return px(circles[circle].getWorldCenter().x);
  }

  @Override
  public double y(int circle) {
    return px(circles[circle].getWorldCenter().y);
  }

  @Override
  public double vx(int circle) {
    return pxPerFrame(circles[circle].getLinearVelocity().x);
  }

  @Override
  public double vy(int circle) {
    return pxPerFrame(circles[circle].getLinearVelocity().y);
  }
}
