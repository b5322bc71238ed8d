// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;
import dev.carom.Kind;
import dev.carom.Scene;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Foresees what a body hits first. Plain doubles pass over what is certainly later, or never. */
final class Lookout {

  /** Covers what plain doubles may have got wrong, many times over. */
  private static final double LATER = 1 + 1e-9;

  /** In the order of simultaneous impacts. */
  private final List<Target> targets = new ArrayList<>();

  Lookout(Scene scene, int bits) {
    for (int i = 0; i < 4 && scene.bounds().isPresent(); i++) {
      targets.add(new WallTarget(scene, i, bits));
    }
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      targets.add(new LineTarget(scene, i, bits));
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      targets.add(new PegTarget(scene, i, bits));
    }
  }

  private record Prospect(Target target, double earliest) {}

  /** The first impact with something that stands still, counted from the start of the flight. */
  Event ahead(Body body) {
    if (body.gravity != null) {
      return aheadOfFall(body);
    }
    if (body.isAtRest()) {
      return null;
    }
    body.checkTight();
    Event first = null;
    for (Prospect prospect : prospects(body)) {
      if (first != null && prospect.earliest > latest(first)) {
        break;
      }
      Target target = prospect.target;
      Touch contact = target.contact(body.p, body.v, body.radius);
      if (contact != null) {
        Event event = new Event(body.t.plus(contact.after()), contact, body, target, null);
        first = first == null || isBefore(event, first) ? event : first;
      }
    }
    return first;
  }

  /**
   * The same for a circle that falls. The walls are asked first: until it comes to one, few of the
   * other things are near its path.
   */
  private Event aheadOfFall(Body body) {
    body.checkTight();
    Fall path = body.fall();
    Ball end = Ball.of(body.course.frames() + 1.0, body.bits).minus(body.t);
    Event first = null;
    FallBoxes boxes = null;
    for (Target target : targets) {
      boolean wall = target.kind == Kind.WALL;
      if (!wall && boxes == null) {
        boxes = new FallBoxes(path, body.radius, first == null ? end.head() : latest(first));
      }
      if (wall || boxes.meet(target.box())) {
        Feature touched = target == body.last ? body.lastFeature : null;
        Touch contact = target.contact(path, body.radius, end, touched);
        if (contact != null) {
          Event event = new Event(body.t.plus(contact.after()), contact, body, target, null);
          first = first == null || isBefore(event, first) ? event : first;
        }
      }
    }
    return first;
  }

  /** An upper bound of the time of a predicted event, rounding errors included. */
  private static double latest(Event first) {
    Ball after = first.contact().after();
    return (after.head() + after.error()) * LATER;
  }

  /** By the times since the start of the flight, which have fewer roundings. */
  private static boolean isBefore(Event event, Event first) {
    int order = event.contact().after().compareTo(first.contact().after());
    return order == 0 ? event.isBefore(first) : order < 0;
  }

  private List<Prospect> prospects(Body body) {
    double x = body.p.x().head();
    double y = body.p.y().head();
    double vx = body.v.x().head();
    double vy = body.v.y().head();
    double radius = body.radius.head();
    List<Prospect> prospects = new ArrayList<>();
    for (Target target : targets) {
      double earliest =
          target == body.last ? Double.POSITIVE_INFINITY : target.earliest(x, y, vx, vy, radius);
      if (earliest < Double.POSITIVE_INFINITY) {
        prospects.add(new Prospect(target, earliest));
      }
    }
    prospects.sort(Comparator.comparingDouble(Prospect::earliest));
    return prospects;
  }

  /** When two bodies meet, searched from the start of the later of their flights. */
  static Event meeting(Body a, Body b) {
    if (a.last == b && b.last == a) {
      return null;
    }
    Ball later = b.t.minus(a.t);
    boolean second = later.head() > 0;
    Vec pa = second ? a.at(later) : a.p;
    Vec pb = second ? b.p : b.at(later.negate());
    Vec d = pa.minus(pb);
    Vec u = a.v.minus(b.v);
    Ball reach = a.radius.plus(b.radius);
    if (isApart(d, u, reach, pa.size() + pb.size())) {
      return null;
    }
    Touch contact = Disks.contact(d, u, reach, Feature.CIRCLE, a.bits);
    Ball start = second ? b.t : a.t;
    return contact == null ? null : new Event(start.plus(contact.after()), contact, a, null, b);
  }

  /** Whether plain doubles tell that an offset d that changes by u never gets so short. */
  private static boolean isApart(Vec d, Vec u, Ball reach, double extent) {
    if (!Body.isTight(d, extent) || !Body.isTight(u, u.size())) {
      return false;
    }
    double dx = d.x().head();
    double dy = d.y().head();
    double earliest = Disks.earliest(dx, dy, u.x().head(), u.y().head(), reach.head(), extent);
    return earliest == Double.POSITIVE_INFINITY;
  }
}
