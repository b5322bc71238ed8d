// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import dev.carom.Line;
import dev.carom.Scene;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.EdgeShape;
import org.jbox2d.collision.shapes.MassData;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;

/**
 * JBox2D. At its best lines have no skin, circles are bullets, nothing falls asleep, and a frame is
 * a microsecond: the speed of 1 m/s below which a bounce is lost cannot be set, but in so fast a
 * world it is next to nothing. Circles sink in the deeper, and some get through, the further they
 * move in a step; of the scales tried, 0.3 m a frame served best.
 */
final class Jbox2dPeer extends Peer {

  private static final double SECONDS_PER_FRAME_AT_BEST = 1e-6;
  private static final int VELOCITY_ITERATIONS = 8;
  private static final int POSITION_ITERATIONS = 3;
  private static final int CIRCLES = 1;
  private static final int LINES = 2;

  private final float step;
  private final World world;
  private final Body[] circles;

  Jbox2dPeer(Scene scene, boolean best) {
    super(
        scene,
        best,
        best ? metreFor(scene, USUAL_METRE, 0.3) : USUAL_METRE,
        best ? SECONDS_PER_FRAME_AT_BEST : SECONDS_PER_FRAME);
    step = (float) (best ? SECONDS_PER_FRAME_AT_BEST : SECONDS_PER_FRAME);
    world = new World(point(gravity.x(), gravity.y()));
    world.setAllowSleep(!best);
    edges(scene).forEach(this::addLine);
    circles = balls(scene).stream().map(this::addCircle).toArray(Body[]::new);
  }

  private static org.jbox2d.common.Vec2 point(double x, double y) {
    return new org.jbox2d.common.Vec2((float) x, (float) y);
  }

  private void addLine(Edge edge) {
    Line line = edge.line();
    EdgeShape shape = new EdgeShape();
    shape.set(point(line.ax(), line.ay()), point(line.bx(), line.by()));
    if (best) {
      shape.setRadius(0);
    }
    world
        .createBody(new BodyDef())
        .createFixture(fixture(shape, LINES, CIRCLES, edge.restitution()));
  }

  private Body addCircle(Ball ball) {
    BodyDef definition = new BodyDef();
    definition.type = BodyType.DYNAMIC;
    definition.bullet = best;
    definition.position = point(ball.x(), ball.y());
    definition.linearVelocity = point(ball.vx(), ball.vy());
    definition.gravityScale = ball.falls() ? 1 : 0;
    CircleShape shape = new CircleShape();
    shape.setRadius((float) ball.radius());
    Body body = world.createBody(definition);
    boolean collides = !Double.isNaN(ball.mass());
    int others = collides ? LINES | CIRCLES : LINES;
    body.createFixture(fixture(shape, CIRCLES, others, ball.restitution()));
    if (collides) {
      setMass(body, ball.mass());
    }
    return body;
  }

  /** Inertia is scaled along; nothing here makes a circle turn. */
  private static void setMass(Body body, double mass) {
    MassData data = new MassData();
    body.getMassData(data);
    float finite = finiteMass(mass);
    data.I *= finite / data.mass;
    data.mass = finite;
    body.setMassData(data);
  }

  private static FixtureDef fixture(Shape shape, int category, int mask, double restitution) {
    FixtureDef fixture = new FixtureDef();
    fixture.shape = shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.restitution = (float) restitution;
    fixture.filter.categoryBits = category;
    fixture.filter.maskBits = mask;
    return fixture;
  }

  @Override
  public void frame() {
    world.step(step, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
  }

  @Override
  public double x(int circle) {
    return px(circles[circle].getPosition().x);
  }

  @Override
  public double y(int circle) {
    return px(circles[circle].getPosition().y);
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
