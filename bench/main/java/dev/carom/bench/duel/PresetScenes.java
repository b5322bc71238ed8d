// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import dev.carom.Scene;
import dev.carom.SceneBuilder;

/** The scenes of {@link Preset}: 400 by 300, with walls. */
final class PresetScenes {

  private static final double WIDTH = 400;
  private static final double HEIGHT = 300;
  private static final double RADIUS = 8;

  private PresetScenes() {}

  private static SceneBuilder box() {
    return Scene.builder().collide(false).bounds(0, 0, WIDTH, HEIGHT);
  }

  /** Six closed lanes of thin lines; from the lowest to the highest the speed doubles, to 320. */
  static Scene fast() {
    SceneBuilder scene = box();
    double speed = 10;
    for (int i = 0; i < 6; i++) {
      double y = 30 + 40 * i;
      scene.line(60, y, 340, y).line(60, y, 60, y + 40).line(340, y, 340, y + 40);
      scene.circle(120 + 30 * i, y + 17, RADIUS, speed, 0.02 * speed);
      speed *= 2;
    }
    return scene.line(60, 270, 340, 270).build();
  }

  /** Lanes with gates: 1 % narrower than the circle, and 1 % wider. */
  static Scene gap() {
    SceneBuilder scene = box();
    double[] widths = {0.99, 1.01, 1.003, 0.997, 1.02};
    for (int i = 0; i < widths.length; i++) {
      double y = 30 + 60 * i;
      double half = widths[i] * RADIUS;
      scene.line(180, y - 30, 180, y - half).line(180, y + half, 180, y + 30);
      scene.circle(40 + 7 * i, y, RADIUS, 4 + i, 0);
    }
    return scene.build();
  }

  /** Corners of 12 to 40 degrees, into which circles fly. */
  static Scene corner() {
    SceneBuilder scene = box();
    double[] degrees = {12, 20, 28, 40};
    for (int i = 0; i < degrees.length; i++) {
      double half = StrictMath.toRadians(degrees[i] / 2);
      double y = 40 + 74 * i;
      double length = 330;
      double dx = length * StrictMath.cos(half);
      double dy = Math.min(34, length * StrictMath.sin(half));
      double reach = dy / StrictMath.tan(half);
      scene.line(20, y, 20 + Math.min(dx, reach), y + dy);
      scene.line(20, y, 20 + Math.min(dx, reach), y - dy);
      scene.circle(340, y + 1.5, RADIUS, -12, 0.1);
    }
    return scene.build();
  }

  /** Circles that come down on a floor at 0.1 to 0.4 a frame, while they fly along it at 4. */
  static Scene shallow() {
    SceneBuilder scene = box();
    for (int i = 0; i < 5; i++) {
      double y = 40 + 52 * i;
      scene.line(20, y - 14, 380, y - 14);
      scene.circle(40 + 10 * i, y + 4, RADIUS, 4, -0.1 * (i + 1));
    }
    return scene.build();
  }

  /** Circles between two lines each, at 0.1 to 0.6 a frame. */
  static Scene slow() {
    SceneBuilder scene = box();
    for (int i = 0; i < 6; i++) {
      double x = 35 + 66 * i;
      scene.line(x - 28, 90, x + 28, 90).line(x - 28, 210, x + 28, 210);
      scene.circle(x, 130 + 4 * i, 2.5 * RADIUS, 0, -0.1 * (i + 1));
    }
    return scene.build();
  }

  /** Wedges of 30 to 90 degrees, with a restitution of a half. */
  static Scene wedge() {
    SceneBuilder scene = box();
    double[] degrees = {30, 50, 70, 90};
    for (int i = 0; i < degrees.length; i++) {
      double half = StrictMath.toRadians(degrees[i] / 2);
      double x = 52 + 98 * i;
      double dx = Math.min(46, 200 * StrictMath.sin(half));
      double dy = dx / StrictMath.tan(half);
      scene.line(x, 20, x - dx, 20 + dy).restitution(0.5);
      scene.line(x, 20, x + dx, 20 + dy).restitution(0.5);
      scene.circle(x + 3, 230, RADIUS, 0.2, -5);
    }
    return scene.build();
  }

  /** A row of five that touch, hit at one end; one lane for each of two masses. */
  static Scene row() {
    SceneBuilder scene = box().collide(true);
    double[] masses = {1, 5};
    for (int lane = 0; lane < masses.length; lane++) {
      double y = 90 + 120 * lane;
      scene.circle(40, y, 2 * RADIUS, 6, 0).mass(masses[lane]);
      for (int i = 0; i < 5; i++) {
        scene.circle(150 + 4 * RADIUS * i, y, 2 * RADIUS, 0, 0);
      }
    }
    return scene.build();
  }
}
