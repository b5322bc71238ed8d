// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.Timeline;
import dev.carom.Vec2;
import dev.carom.World;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/**
 * The courses of circles over a run: for each the keys between which it flies freely, straight on
 * or along a parabola.
 */
public final class Courses {

  /** The place of a circle at the end of a frame, 0 for the start. */
  @FunctionalInterface
  public interface Place {

    /** A coordinate; a circle at no number stays where it was. */
    double at(int frame, int circle);
  }

  /**
   * One coordinate of a circle at a time, and its velocity and acceleration from then on.
   *
   * @param a NaN as long as it is not known
   */
  record Key(double t, double p, double v, double a) {

    double at(double time, double a) {
      double dt = time - t;
      return p + v * dt + a * dt * dt / 2;
    }

    Key with(double acceleration) {
      return new Key(t, p, v, acceleration);
    }
  }

  /** What is off by less, as a part of the greatest distance in the scene, cannot be seen. */
  private static final double VISIBLE = 1e-4;

  private final double visible;
  private final double duration;
  private final double gx;
  private final double gy;
  private final List<List<Key>> xs = new ArrayList<>();
  private final List<List<Key>> ys = new ArrayList<>();
  private final List<OptionalInt> lost = new ArrayList<>();

  private Courses(Scene scene, double duration, double gx, double gy) {
    visible =
        VISIBLE * Math.max(SceneExtent.of(scene).getWidth(), SceneExtent.of(scene).getHeight());
    this.duration = duration;
    this.gx = gx;
    this.gy = gy;
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      xs.add(new ArrayList<>());
      ys.add(new ArrayList<>());
      lost.add(OptionalInt.empty());
    }
  }

  /**
   * Plays a scene by this library: the flights are those of its world.
   *
   * @param frames how many, at least 0
   * @param dt the time of each, greater than 0
   */
  public static Courses of(Scene scene, int frames, double dt) {
    World world = new World(scene);
    Timeline past = world.record(dt);
    Courses courses = new Courses(scene, frames * dt, scene.gravity().x(), scene.gravity().y());
    courses.addAll(past, 0);
    for (int frame = 0; frame < frames; frame++) {
      world.step(dt);
      ImpactLog impacts = world.impacts();
      for (int row = 0; row < impacts.size(); row++) {
        courses.add(impacts.circle(row), past, impacts.time(row));
        if (impacts.kind(row) == Kind.CIRCLE) {
          courses.add(impacts.id(row), past, impacts.time(row));
        }
      }
      courses.addAll(past, world.now());
    }
    return courses;
  }

  /**
   * What another method makes of a scene: straight lines between the ends of its frames.
   *
   * @param frames how many of length 1, at least 0
   */
  public static Courses of(Scene scene, int frames, Place x, Place y) {
    Courses courses = new Courses(scene, frames, 0, 0);
    for (int i = 0; i < courses.circles(); i++) {
      for (int frame = 0; frame <= frames; frame++) {
        int next = Math.min(frame + 1, frames);
        courses.add(courses.xs.get(i), frame, x.at(frame, i), x.at(next, i) - x.at(frame, i), 0);
        courses.add(courses.ys.get(i), frame, y.at(frame, i), y.at(next, i) - y.at(frame, i), 0);
      }
    }
    return courses;
  }

  private void addAll(Timeline past, double t) {
    for (int i = 0; i < circles(); i++) {
      add(i, past, t);
    }
  }

  private void add(int circle, Timeline past, double at) {
    double t = Math.max(past.start(), at);
    add(xs.get(circle), t, past.x(circle, t), past.vx(circle, t), gx);
    add(ys.get(circle), t, past.y(circle, t), past.vy(circle, t), gy);
  }

  /** Adds a key unless the last flight goes on: falling freely, or held by contact. */
  private void add(List<Key> keys, double t, double p, double v, double g) {
    if (!Double.isFinite(p) || !Double.isFinite(v)) {
      return;
    }
    if (!keys.isEmpty()) {
      int i = keys.size() - 1;
      Key last = keys.get(i);
      if (t == last.t) {
        keys.set(i, new Key(t, p, v, Double.NaN)); // what comes last of one moment lasts
        return;
      }
      double[] known = {last.a};
      double found = 0;
      for (double a : Double.isNaN(last.a) ? new double[] {0, g} : known) {
        if (Math.abs(last.at(t, a) - p) < visible) {
          found = a;
          if (Math.abs(last.v + a * (t - last.t) - v) < visible) {
            keys.set(i, last.with(a));
            return;
          }
        }
      }
      keys.set(i, last.with(Double.isNaN(last.a) ? found : last.a));
    }
    keys.add(new Key(t, p, v, Double.NaN));
  }

  /** Marks a circle that is lost from a frame on. */
  public Courses lost(int circle, int frame) {
    lost.set(circle, OptionalInt.of(frame));
    return this;
  }

  int circles() {
    return xs.size();
  }

  double duration() {
    return duration;
  }

  OptionalInt lost(int circle) {
    return lost.get(circle);
  }

  /** Where a circle is at a time. */
  Vec2 at(int circle, double time) {
    return new Vec2(at(xs.get(circle), time), at(ys.get(circle), time));
  }

  private static double at(List<Key> keys, double time) {
    Key last = keys.get(0);
    for (Key key : keys) {
      last = key.t <= time ? key : last;
    }
    return last.at(time, Double.isNaN(last.a) ? 0 : last.a);
  }

  /** How many are lost at the end of a frame. */
  int lostUntil(int frame) {
    return (int) lost.stream().filter(at -> at.isPresent() && at.getAsInt() <= frame).count();
  }

  List<Key> x(int circle) {
    return ended(xs.get(circle));
  }

  List<Key> y(int circle) {
    return ended(ys.get(circle));
  }

  /** With a key at each turn of a parabola, and one at the end. */
  private List<Key> ended(List<Key> keys) {
    List<Key> all = new ArrayList<>();
    for (int i = 0; i < keys.size(); i++) {
      Key key = keys.get(i).with(Double.isNaN(keys.get(i).a) ? 0 : keys.get(i).a);
      double end = i + 1 < keys.size() ? keys.get(i + 1).t : duration;
      all.add(key);
      double turn = key.a == 0 ? end : key.t - key.v / key.a;
      if (turn > key.t && turn < end) {
        all.add(new Key(turn, key.at(turn, key.a), 0, key.a));
      }
    }
    if (!all.isEmpty()) {
      Key last = all.get(all.size() - 1);
      if (last.t < duration) {
        all.add(new Key(duration, last.at(duration, last.a), 0, 0));
      }
    }
    return all;
  }
}
