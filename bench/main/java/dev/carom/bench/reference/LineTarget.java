// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Scene;
import java.util.ArrayList;
import java.util.List;

/** A line: its side between its ends, and the ends as points. */
final class LineTarget extends Target {

  private final Line line;
  private final Vec start;
  private final Vec end;
  private final Vec w;
  private final Ball squared;
  private final Ball length;

  LineTarget(Scene scene, int index, int bits) {
    super(scene, Kind.LINE, index, bits);
    line = (Line) scene.shape(Kind.LINE, index);
    start = Vec.of(line.ax(), line.ay(), bits);
    end = Vec.of(line.bx(), line.by(), bits);
    w = end.minus(start);
    squared = w.dot(w);
    length = squared.sqrt();
  }

  /**
   * With w = end - start and d = p - start: the centre is {@code c = w x d} (times 1 / |w|) beside
   * the line and {@code s = d.w} along it. It comes within r of the infinite line at {@code t =
   * (|c| - r |w|) / |w x v|}; where it is along the line then, or at the start if it is within r
   * already, tells which part it meets.
   */
  @Override
  Touch contact(Vec p, Vec v, Ball radius) {
    Vec d = p.minus(start);
    Ball c = w.cross(d);
    Ball rate = w.cross(v);
    Ball gap = c.abs().minus(radius.times(length));
    boolean nearing = c.sign() * rate.sign() < 0;
    boolean within = gap.sign() <= 0;
    if (!within && !nearing) {
      return null;
    }
    Ball after = within ? Ball.of(0, bits) : gap.over(rate.abs());
    Ball s = d.dot(w).plus(v.dot(w).times(after));
    if (s.sign() <= 0) {
      return Disks.contact(d, v, radius, Feature.START, bits);
    }
    if (s.compareTo(squared) >= 0) {
      return Disks.contact(p.minus(end), v, radius, Feature.END, bits);
    }
    return nearing ? new Touch(after, Feature.SIDE, within) : null;
  }

  /**
   * The first time at which the height above one of the two sides, or the distance from one of the
   * ends, falls to the radius while the centre is beside or beyond that part.
   */
  @Override
  Touch contact(Fall path, Ball radius, Ball end, Feature touched) {
    boolean left = w.cross(path.p().minus(start)).sign() > 0;
    List<Touch> contacts = new ArrayList<>();
    for (boolean isLeft : new boolean[] {true, false}) {
      Vec n = isLeft ? w.left() : w.left().negate();
      Ball[] gap = path.height(n, start, radius.times(length));
      boolean touches = touched == Feature.SIDE && left == isLeft;
      add(path, path.contacts(gap, end, touches), Feature.SIDE, contacts);
    }
    for (Feature feature : new Feature[] {Feature.START, Feature.END}) {
      Ball[] gap = path.distance(feature == Feature.START ? start : this.end, radius);
      add(path, path.contacts(gap, end, touched == feature), feature, contacts);
    }
    return contacts.stream().min((a, b) -> a.after().compareTo(b.after())).orElse(null);
  }

  /** Adds the first of some times at which the centre is where that part is next. */
  private void add(Fall path, List<Ball> times, Feature feature, List<Touch> contacts) {
    for (Ball time : times) {
      if (part(path.at(time)) == feature) {
        contacts.add(new Touch(time, feature, false));
        return;
      }
    }
  }

  /** The part of the line that is next to a place. */
  private Feature part(Vec place) {
    Ball along = place.minus(start).dot(w);
    if (along.sign() <= 0) {
      return Feature.START;
    }
    return along.compareTo(squared) >= 0 ? Feature.END : Feature.SIDE;
  }

  @Override
  double[] box() {
    return new double[] {
      Math.min(line.ax(), line.bx()),
      Math.min(line.ay(), line.by()),
      Math.max(line.ax(), line.bx()),
      Math.max(line.ay(), line.by())
    };
  }

  @Override
  Vec normal(Vec p, Feature feature) {
    return switch (feature) {
      case START -> p.minus(start);
      case END -> p.minus(end);
      default -> w.cross(p.minus(start)).sign() > 0 ? w.left() : w.left().negate();
    };
  }

  @Override
  boolean isRound(Feature feature) {
    return feature != Feature.SIDE;
  }

  /**
   * The time for the disk around the middle that holds the line: no later than that of the line.
   */
  @Override
  double earliest(double x, double y, double vx, double vy, double radius) {
    double mx = (line.ax() + line.bx()) / 2;
    double my = (line.ay() + line.by()) / 2;
    double extent = Math.abs(x) + Math.abs(y) + Math.abs(line.ax()) + Math.abs(line.ay());
    return Disks.earliest(x - mx, y - my, vx, vy, line.length() / 2 + radius, extent);
  }
}
