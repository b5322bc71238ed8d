// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Response;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import java.util.Locale;

/** A long run whose hash is stored, and must come out everywhere. */
public enum GoldenRun {
  /** The experiment with circles of radius 5, which hit sides and ends of its lines and walls. */
  LINES(10_000) {
    @Override
    Scene scene() throws CannotPlaceException {
      return crosses().scene();
    }
  },
  /** A gas of circles of different sizes and masses. */
  PAIRS(250) {
    @Override
    Scene scene() throws CannotPlaceException {
      return new Gas(500, 0.3, 2, true, 1).scene();
    }
  },
  /** All at once: pairs, lines, pegs and walls, masses, restitutions and responses. */
  MIXED(3_000) {
    @Override
    Scene scene() throws CannotPlaceException {
      return mix(crosses().scene()).build();
    }
  },
  /** The same under gravity: circles fly parabolas, slide, and come to rest. */
  FALLS(1_000) {
    @Override
    Scene scene() throws CannotPlaceException {
      return mix(crosses().scene()).gravity(0.01, -0.05).build();
    }
  };

  /** A long one has so many times the frames; too many for an interpreter. */
  private static final int LONG = 20;

  private final int frames;

  GoldenRun(int frames) {
    this.frames = frames;
  }

  /** Its scene, the same on every machine. */
  abstract Scene scene() throws CannotPlaceException;

  /** How many frames, each one unit of time. */
  public int frames(boolean longer) {
    return longer ? frames * LONG : frames;
  }

  /** Plays it. */
  public RunHash play(boolean longer) throws CannotPlaceException {
    return RunHash.of(scene(), frames(longer));
  }

  /** Its name, as in the file of stored hashes. */
  public String label(boolean longer) {
    return name().toLowerCase(Locale.ROOT) + (longer ? "-long" : "");
  }

  private static Crosses crosses() {
    return new Crosses(100, 50, 5, 1, 10, 1);
  }

  /** A scene in which some things take energy away, and some give it back. */
  private static SceneBuilder mix(Scene from) {
    SceneBuilder builder = Scene.builder();
    Bounds b = from.bounds().orElseThrow();
    builder.bounds(b.xmin(), b.ymin(), b.xmax(), b.ymax());
    for (int i = 0; i < from.count(Kind.LINE); i++) {
      builder.line(
          ((Line) from.shape(Kind.LINE, i)).ax(),
          ((Line) from.shape(Kind.LINE, i)).ay(),
          ((Line) from.shape(Kind.LINE, i)).bx(),
          ((Line) from.shape(Kind.LINE, i)).by());
      builder.restitution(i % 4 == 0 ? 0.95 : i % 4 == 2 ? 1.05 : 1);
      if (i % 10 == 1) {
        builder.oneWay();
      }
    }
    for (int i = 0; i < 5; i++) {
      builder.peg(20 + 190 * i, 15, 2 * i).restitution(1.05);
      builder.peg(40 + 180 * i, 585, 8).response(i == 2 ? Response.SENSOR : Response.BOUNCE);
    }
    for (int i = 0; i < from.count(Kind.CIRCLE); i++) {
      Circle c = (Circle) from.shape(Kind.CIRCLE, i);
      Vec2 v = from.velocity(Kind.CIRCLE, i);
      builder.circle(c.x(), c.y(), i % 3 == 0 ? 2 : c.radius(), v.x(), v.y());
      builder.mass(i % 50 == 7 ? 1_000 : 1 + i % 5);
      builder.restitution(i % 6 == 0 ? 0.99 : 1);
    }
    return builder;
  }
}
