// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Scene;
import dev.carom.bench.methods.PlainScene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Circles of a scene from impact to impact, each decision proved with the digits carried or refused
 * with {@link DoubtException}. What is ahead is searched among all things: slow, and plain.
 */
final class Run {

  /** A scene that makes more is taken for one whose impacts pile up. */
  private static final int MOST_IMPACTS = 1_000_000;

  private final Lookout lookout;
  private final int frames;
  private final int bits;
  private final Body[] bodies;
  private final boolean collide;
  private final Event[] ahead;

  /** The predicted event of two circles, by the lower number and then the higher one. */
  private final Event[][] meetings;

  private List<Hit> hits;

  /**
   * Begins a run of these circles. They ignore each other, or they are all circles of the scene.
   */
  Run(Scene scene, int[] circles, Lookout lookout, int frames, int bits) {
    this.lookout = lookout;
    this.frames = frames;
    this.bits = bits;
    collide = PlainScene.collides(scene);
    int count = circles.length;
    int values = count * Tangents.STATE;
    bodies = new Body[count];
    for (int i = 0; i < count; i++) {
      bodies[i] = new Body(scene, circles[i], bits, frames, values, i * Tangents.STATE);
    }
    ahead = new Event[count];
    meetings = new Event[count][count];
  }

  Body body(int i) {
    return bodies[i];
  }

  List<CircleFrames> courses() {
    return Arrays.stream(bodies).map(body -> body.course).toList();
  }

  /** Lets time run to the last frame, and returns the impacts in their order. */
  List<Hit> play() {
    hits = new ArrayList<>();
    for (int i = 0; i < bodies.length; i++) {
      foresee(i, i);
    }
    Ball end = Ball.of(frames, bits);
    for (Event next = first(); isUntil(next, end); next = first()) {
      happen(next);
    }
    for (Body body : bodies) {
      body.course.recordRest(body);
    }
    return hits;
  }

  /** Turns all velocities round at the last frame, for another play. */
  void turnBack() {
    for (Body body : bodies) {
      body.turnBack(frames, frames);
    }
  }

  private static boolean isUntil(Event event, Ball end) {
    return event != null && event.time().compareTo(end) <= 0;
  }

  /** Foresees what a body hits, of the other bodies those from 0 up to a number. */
  private void foresee(int i, int others) {
    ahead[i] = lookout.ahead(bodies[i]);
    for (int j = 0; collide && j < others; j++) {
      if (j != i) {
        int low = Math.min(i, j);
        int high = Math.max(i, j);
        meetings[low][high] = Lookout.meeting(bodies[low], bodies[high]);
      }
    }
  }

  private Event first() {
    Event first = null;
    for (int i = 0; i < bodies.length; i++) {
      first = earlier(first, ahead[i]);
      for (int j = i + 1; j < bodies.length; j++) {
        first = earlier(first, meetings[i][j]);
      }
    }
    return first;
  }

  private static Event earlier(Event first, Event event) {
    return first == null || (event != null && event.isBefore(first)) ? event : first;
  }

  private void happen(Event event) {
    hits.add(event.hit());
    if (hits.size() > MOST_IMPACTS) {
      throw new IllegalStateException(
          "more than %d impacts until time %s: expected a scene whose impacts do not pile up"
              .formatted(MOST_IMPACTS, event.time().head()));
    }
    Body a = event.a();
    if (event.target() != null) {
      a.course.recordFlight(a, event.time());
      Impacts.bounce(event);
      foresee(indexOf(a), bodies.length);
    } else {
      Body b = event.b();
      a.course.recordFlight(a, event.time());
      b.course.recordFlight(b, event.time());
      Impacts.collide(event);
      foresee(indexOf(a), bodies.length);
      foresee(indexOf(b), bodies.length);
    }
  }

  private int indexOf(Body body) {
    return bodies.length == 1 ? 0 : body.id;
  }
}
