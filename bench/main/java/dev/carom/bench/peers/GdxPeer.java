// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.peers;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.EdgeShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.MassData;
import com.badlogic.gdx.physics.box2d.Shape;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.utils.GdxNativesLoader;
import com.badlogic.gdx.utils.GdxRuntimeException;
import dev.carom.Line;
import dev.carom.Scene;

/**
 * Box2D as libGDX carries it: C++ behind JNI, without its window. At its best no bounce is too slow
 * to keep its speed, lines have no skin, circles are bullets, and nothing falls asleep.
 *
 * <p>It is set up as {@link Jbox2dPeer} is, by calls of the same names on classes that have nothing
 * in common.
 */
final class GdxPeer extends Peer {

  private static final int VELOCITY_ITERATIONS = 8;
  private static final int POSITION_ITERATIONS = 3;
  private static final short CIRCLES = 1;
  private static final short LINES = 2;
  private static final short ALL = 3;

  /** In m/s; Box2D's own. */
  private static final float USUAL_THRESHOLD = 1;

  private final World world;
  private final Body[] circles;

  GdxPeer(Scene scene, boolean best) {
    super(scene, best, best ? metreFor(scene, 10, 1.6) : USUAL_METRE, SECONDS_PER_FRAME);
    loadNatives();
    world = new World(new Vector2((float) gravity.x(), (float) gravity.y()), !best);
    edges(scene).forEach(this::addLine);
    circles = balls(scene).stream().map(this::addCircle).toArray(Body[]::new);
  }

  private static void loadNatives() {
    try {
      GdxNativesLoader.load();
      Box2D.init();
    } catch (GdxRuntimeException | LinkageError e) {
      throw new UnsupportedOperationException(
          "the natives of libGDX do not load on %s %s: %s"
              .formatted(System.getProperty("os.name"), System.getProperty("os.arch"), e),
          e);
    }
  }

  private void addLine(Edge edge) {
    Line line = edge.line();
    EdgeShape shape = new EdgeShape();
    shape.set((float) line.ax(), (float) line.ay(), (float) line.bx(), (float) line.by());
    if (best) {
      shape.setRadius(0);
    }
    addFixture(world.createBody(new BodyDef()), shape, LINES, CIRCLES, edge.restitution());
  }

  private Body addCircle(Ball ball) {
    BodyDef definition = new BodyDef();
    definition.type = BodyDef.BodyType.DynamicBody;
    definition.bullet = best;
    definition.position.set((float) ball.x(), (float) ball.y());
    definition.linearVelocity.set((float) ball.vx(), (float) ball.vy());
    definition.gravityScale = ball.falls() ? 1 : 0;
    CircleShape shape = new CircleShape();
    shape.setRadius((float) ball.radius());
    Body body = world.createBody(definition);
    boolean collides = !Double.isNaN(ball.mass());
    addFixture(body, shape, CIRCLES, collides ? ALL : LINES, ball.restitution());
    if (collides) {
      setMass(body, ball.mass());
    }
    return body;
  }

  /** Inertia is scaled along; nothing here makes a circle turn. */
  private static void setMass(Body body, double mass) {
    MassData data = body.getMassData();
    float finite = finiteMass(mass);
    data.I *= finite / data.mass;
    data.mass = finite;
    body.setMassData(data);
  }

  private static void addFixture(
      Body body, Shape shape, short category, short mask, double restitution) {
    FixtureDef fixture = new FixtureDef();
    fixture.shape = shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.restitution = (float) restitution;
    fixture.filter.categoryBits = category;
    fixture.filter.maskBits = mask;
    body.createFixture(fixture);
    shape.dispose();
  }

  /** The threshold belongs to the process, so it is set before each step. */
  @Override
  public void frame() {
    World.setVelocityThreshold(best ? 0 : USUAL_THRESHOLD);
    world.step((float) SECONDS_PER_FRAME, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
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

  @Override
  public void close() {
    world.dispose();
  }
}
