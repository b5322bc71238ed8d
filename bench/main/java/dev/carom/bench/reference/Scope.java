// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Filter;
import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.Vec2;
import dev.carom.bench.methods.PlainScene;

/**
 * Which scenes have a reference: those in which obstacles rest, and everything bounces, from both
 * sides, whoever comes. With gravity, circles ignore each other, and none has infinite mass.
 */
final class Scope {

  private Scope() {}

  static void check(Scene scene, int frames) {
    if (frames < 1) {
      throw new IllegalArgumentException("frames is " + frames + ": expected at least 1");
    }
    if (!scene.gravity().equals(Vec2.ZERO)) {
      allFall(scene);
    }
    if (PlainScene.isOpen(scene)) {
      throw new IllegalArgumentException(
          "the bounds are open: a reference expects four walls or none");
    }
    if (scene.bounds().isPresent()) {
      bounces("bounds", scene, Kind.WALL, 0);
    }
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      if (scene.shape(Kind.LINE, i) instanceof Outline) {
        throw new IllegalArgumentException(
            "line " + i + " is an outline: a reference expects single lines");
      }
      bounces("line", scene, Kind.LINE, i);
      rests("line", i, scene.velocity(Kind.LINE, i));
      if (scene.traits(Kind.LINE, i).oneWay()) {
        throw new IllegalArgumentException(
            "line " + i + " is one-way: a reference expects lines that are there from both sides");
      }
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      bounces("peg", scene, Kind.PEG, i);
      rests("peg", i, scene.velocity(Kind.PEG, i));
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      bounces("circle", scene, Kind.CIRCLE, i);
    }
  }

  private static void allFall(Scene scene) {
    if (PlainScene.collides(scene)) {
      throw new IllegalArgumentException(
          "circles collide: with gravity, a reference expects ones that ignore each other");
    }
    for (int i = 0; i < scene.count(Kind.CIRCLE); i++) {
      if (scene.traits(Kind.CIRCLE, i).mass() == Double.POSITIVE_INFINITY) {
        throw new IllegalArgumentException(
            "circle %d has infinite mass: with gravity, a reference expects circles that fall"
                .formatted(i));
      }
    }
  }

  private static void bounces(String name, Scene scene, Kind kind, int i) {
    Response response = scene.traits(kind, i).response();
    if (response != Response.BOUNCE) {
      throw new IllegalArgumentException(
          "%s %d has the response %s: a reference expects BOUNCE".formatted(name, i, response));
    }
    if (!scene.traits(kind, i).filter().equals(Filter.DEFAULT)) {
      throw new IllegalArgumentException(
          "%s %d has a filter: a reference expects category 1 and mask -1".formatted(name, i));
    }
  }

  private static void rests(String kind, int i, Vec2 velocity) {
    if (!velocity.equals(Vec2.ZERO)) {
      throw new IllegalArgumentException(
          "%s %d has the velocity (%s, %s): a reference expects obstacles at rest"
              .formatted(kind, i, velocity.x(), velocity.y()));
    }
  }
}
