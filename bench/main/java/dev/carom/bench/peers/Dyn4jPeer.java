// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Line;
import dev.carom.Scene;
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

  private final World<Body> world = new World<>();
  private final Body[] circles;

  Dyn4jPeer(Scene scene, boolean best) {
    super(scene, best, best ? metreFor(scene, 10, 1.6) : USUAL_METRE, SECONDS_PER_FRAME);
    world.setGravity(gravity.x(), gravity.y());
    if (best) {
      Settings settings = world.getSettings();
      settings.setAtRestDetectionEnabled(false);
      settings.setMaximumTranslation(NO_CAP);
    }
    edges(scene).forEach(this::addLine);
    circles = balls(scene).stream().map(this::addCircle).toArray(Body[]::new);
  }

  private void addLine(Edge edge) {
    Line line = edge.line();
    Vector2 a = new Vector2(line.ax(), line.ay());
    Body body =
        body(
            Geometry.createSegment(a, new Vector2(line.bx(), line.by())),
            LINES,
            edge.restitution());
    body.setMass(MassType.INFINITE);
    world.addBody(body);
  }

  private Body addCircle(Ball ball) {
    boolean collides = !Double.isNaN(ball.mass());
    Convex disk = Geometry.createCircle(ball.radius());
    Body body = body(disk, collides ? COLLIDING : CIRCLES, ball.restitution());
    body.setMass(MassType.NORMAL);
    if (collides) {
      setMass(body, ball.mass());
    }
    body.setBullet(best);
    body.translate(ball.x(), ball.y());
    body.setLinearVelocity(ball.vx(), ball.vy());
    body.setGravityScale(ball.falls() ? 1 : 0);
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
