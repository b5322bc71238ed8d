// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.measures;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.Vec2;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.reference.References;
import dev.carom.bench.reference.Truth;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;

/** The scenes of the comparison. */
final class Subjects {

  /** The published length of a run. */
  static final int FRAMES = 600;

  /** The first canonical scene with circles small enough to reach the sides of the crosses. */
  static final String SMALL = "base-1-r5";

  /** Circles that collide, and nothing else but walls. */
  static final String GAS = "gas";

  /** Circles that fall on each other, and come to rest. */
  static final String HEAP = "heap";

  private static final double GAS_RADIUS = 10;
  private static final double GAS_SPEED = 4.3;

  private static final String FOLDER = "/dev/carom/bench/scenes/";
  private static final double SMALL_RADIUS = 5;

  /** References are kept, for many parts ask for the same one. */
  private static final Map<String, Subject> LOADED = new ConcurrentHashMap<>();

  private Subjects() {}

  static Subject load(String name) {
    return LOADED.computeIfAbsent(name, Subjects::read);
  }

  private static Subject read(String name) {
    Scene scene = scene(name);
    return new Subject(name, scene, FRAMES, Optional.of(reference(name, scene)));
  }

  static Scene scene(String name) {
    return switch (name) {
      case SMALL -> crosses(SMALL_RADIUS, 1, 10, 1);
      case GAS -> gas(1);
      case HEAP -> heap(1);
      default -> stored(name);
    };
  }

  /**
   * A fifth of the area is covered. Circles are as large and as fast as in the other scenes, for
   * engines have tolerances that are lengths.
   */
  private static Scene gas(long seed) {
    try {
      Scene small = new Gas(100, 0.2, 1, false, seed).scene();
      Bounds b = small.bounds().orElseThrow();
      SceneBuilder builder =
          Scene.builder()
              .bounds(
                  GAS_RADIUS * b.xmin(),
                  GAS_RADIUS * b.ymin(),
                  GAS_RADIUS * b.xmax(),
                  GAS_RADIUS * b.ymax());
      for (int i = 0; i < small.count(Kind.CIRCLE); i++) {
        Circle c = (Circle) small.shape(Kind.CIRCLE, i);
        Vec2 v = small.velocity(Kind.CIRCLE, i);
        builder.circle(
            GAS_RADIUS * c.x(),
            GAS_RADIUS * c.y(),
            GAS_RADIUS * c.radius(),
            GAS_SPEED * v.x(),
            GAS_SPEED * v.y());
      }
      return builder.build();
    } catch (CannotPlaceException e) {
      throw new IllegalStateException("so thin a gas has room for all its circles", e);
    }
  }

  /** Ten rows of ten; a bounce keeps half of the speed. */
  private static Scene heap(long seed) {
    SceneBuilder builder = Scene.builder().bounds(0, 0, 247, 400).gravity(0, -0.125);
    Random random = new Random(seed);
    for (int i = 0; i < 100; i++) {
      double x = 12 + 24 * (i % 10) + 3 * random.nextDouble();
      builder.circle(x, 20 + 30 * (i / 10), 10, 0, 0).restitution(0.5);
    }
    return builder.build();
  }

  /** Scenes of the same kind to play in between, so that none is learnt by heart. */
  static List<Scene> others(String name) {
    return switch (name) {
      case SMALL -> List.of(crosses(SMALL_RADIUS, 1, 10, 2), crosses(SMALL_RADIUS, 1, 10, 3));
      case GAS -> List.of(gas(2), gas(3));
      case HEAP -> List.of(heap(2), heap(3));
      case "fast-1" -> List.of(crosses(10, 20, 100, 2), crosses(10, 20, 100, 3));
      default -> List.of(crosses(10, 1, 10, 4), crosses(10, 1, 10, 5));
    };
  }

  static Scene crosses(double radius, double minSpeed, double maxSpeed, long seed) {
    try {
      return new Crosses(100, 50, radius, minSpeed, maxSpeed, seed).scene();
    } catch (CannotPlaceException e) {
      throw new IllegalStateException("a canonical scene has room for all that is in it", e);
    }
  }

  private static Scene stored(String name) {
    String path = FOLDER + name + ".csv";
    try (InputStream in = Subjects.class.getResourceAsStream(path)) {
      if (in == null) {
        throw new IllegalArgumentException(path + " is not in the jar");
      }
      Reader text = new InputStreamReader(in, StandardCharsets.UTF_8);
      return Scene.read(text, name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Stored, or computed: that takes seconds. */
  private static Reference reference(String name, Scene scene) {
    if (!References.SCENES.contains(name)) {
      return Truth.of(scene, FRAMES, () -> {});
    }
    try {
      return References.load(name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
