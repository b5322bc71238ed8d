// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.EverydayScenes.Shape;
import dev.carom.EverydayScenes.View;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Contacts under gravity follow events of the scene, and a clock of their own: neither frames, nor
 * snapshots, nor how the scene is looked at changes a bit.
 */
class ContactBitsTest {

  private static final double END = 400;

  private static final EverydayScenes[] SCENES = {
    EverydayScenes.of(Shape.BOX, 30).restitution(0.5),
    EverydayScenes.of(Shape.V, 30).restitution(0),
    EverydayScenes.of(Shape.FUNNEL_2, 30).restitution(0.3),
    EverydayScenes.of(Shape.BOWL, 10).restitution(EverydayScenes.MIXED),
    EverydayScenes.of(Shape.STAIRS, 30).restitution(0.9),
    EverydayScenes.of(Shape.SHAFT, 10).restitution(0.5),
    EverydayScenes.of(Shape.PEGS, 30).restitution(EverydayScenes.MIXED),
    EverydayScenes.of(Shape.RAMP, 30).restitution(0)
  };

  private static World play(Scene scene, double end, double frame) {
    World world = new World(scene);
    for (int k = 1; world.now() < end; k++) {
      world.advanceTo(Math.min(end, k * frame));
    }
    return world;
  }

  /** A frame may be a part of a tick, or many: the snapshots are the same. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7})
  void framesDoNotMatter(int number) {
    Scene scene = SCENES[number].scene();
    Snapshot right = play(scene, END, 1).snapshot();
    for (double frame : new double[] {0.37, 17.3, END}) {
      Snapshot snapshot = play(scene, END, frame).snapshot();
      assertThat(snapshot).as("%s in frames of %s", SCENES[number], frame).isEqualTo(right);
    }
  }

  /** Saved in the middle of a tick and read in a fresh world, it goes on the same. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7})
  void savedWorldsGoOnTheSame(int number) {
    Scene scene = SCENES[number].scene();
    Snapshot right = play(scene, END, 1).snapshot();
    Random random = new Random(number);
    World world = new World(scene);
    while (world.now() < END) {
      World restored = new World(scene);
      restored.restore(SnapshotBytes.copy(world.snapshot()));
      world = restored;
      double next = world.now() + 40 * random.nextDouble();
      world.advanceTo(Math.min(END, next));
    }
    assertThat(world.snapshot()).as("%s", SCENES[number]).isEqualTo(right);
  }

  /**
   * Factors of lengths, times and masses, and signs of x and y: places, velocities and who rests
   * are the same at all times, but for the factors.
   */
  @ParameterizedTest
  @CsvSource({
    "1, 1, 4, 1, 1",
    "1, 1, 0.125, 0.5, 1",
    "1, 1, 1, 4, 1",
    "1, 1, 1, 1, 0.0009765625",
    "-1, 1, 1, 1, 1",
    "1, -1, 1, 1, 1",
    "-1, -1, 2, 2, 2"
  })
  void theViewDoesNotMatter(double x, double y, double length, double time, double mass) {
    View view = new View(x, y, length, time, mass);
    for (EverydayScenes scenes : SCENES) {
      World plain = new World(scenes.view(View.PLAIN).scene());
      World other = new World(scenes.view(view).scene());
      scenes.view(View.PLAIN);
      for (int t = 40; t <= END; t += 40) {
        plain.advanceTo(t);
        other.advanceTo(t * time);
        for (int i = 0; i < plain.count(Kind.CIRCLE); i++) {
          String name = scenes + ", circle " + i + " at " + t;
          assertThat(other.x(i) / (x * length)).as(name).isEqualTo(plain.x(i));
          assertThat(other.y(i) / (y * length)).as(name).isEqualTo(plain.y(i));
          assertThat(other.vx(i) * time / (x * length) + 0.0).isEqualTo(plain.vx(i) + 0.0);
          assertThat(other.vy(i) * time / (y * length) + 0.0).isEqualTo(plain.vy(i) + 0.0);
          assertThat(other.isResting(i)).as(name).isEqualTo(plain.isResting(i));
        }
      }
    }
  }

  /** Velocities are set at any moment: frames and snapshots do not matter, and nothing overlaps. */
  @ParameterizedTest
  @CsvSource({"BOX, 0", "BOX, 0.5", "V, 0.5", "PEGS, 0", "FUNNEL_4, 0.3", "BINS, 0.9"})
  void editsAtAnyMoment(Shape shape, double e) {
    Scene scene = EverydayScenes.of(shape, 30).restitution(e).scene();
    Snapshot right = edited(scene, 1, false);
    assertThat(edited(scene, 0.37, false)).isEqualTo(right);
    assertThat(edited(scene, 5.3, true)).isEqualTo(right);
  }

  private static Snapshot edited(Scene scene, double frame, boolean restores) {
    Random random = new Random(1);
    ContactRun run = new ContactRun(new World(scene)).withMovers();
    for (int k = 0; k < 40; k++) {
      run.play(run.world.now() + 15 * random.nextDouble(), frame);
      assertThat(run.faults()).isEmpty();
      int every = random.nextInt(3) == 0 ? 7 : 100;
      for (int i = random.nextInt(30); i < 30; i += every) {
        run.world.setVelocity(i, 2 * random.nextGaussian(), 2 * random.nextGaussian());
      }
      if (restores) {
        run.world.restore(SnapshotBytes.copy(run.world.snapshot()));
      }
    }
    return run.world.snapshot();
  }

  /** Lines that move squeeze balls now and then: a world restored at each frame does the same. */
  @ParameterizedTest
  @ValueSource(ints = {2, 14, 20, 31, 45})
  void whatWasSqueezedIsForgotten(int seed) {
    Random random = new Random(seed);
    SceneBuilder scene = Scene.builder().gravity(0, 0.05).bounds(0, 0, 120, 120).restitution(0.5);
    for (int k = 0; k < 3; k++) {
      double x = 20 + 80 * random.nextDouble();
      double y = 20 + 80 * random.nextDouble();
      double angle = 6.3 * random.nextDouble();
      scene.line(x, y, x + 40 * Math.cos(angle), y + 40 * Math.sin(angle)).restitution(0.5);
    }
    for (int i = 0; i < 5; i++) {
      double y = 15 + 5 * random.nextDouble();
      double radius = 6 + 4 * random.nextDouble();
      scene.circle(15 + 22 * i, y, radius, random.nextDouble() - 0.5, 0).restitution(0.5);
    }
    World world = new World(scene.build());
    World restored = new World(world.scene());
    for (int frame = 0; frame < 300; frame++) {
      for (int k = 0; k < 3 && frame % 25 == 0; k++) {
        double vx = 0.3 * (random.nextInt(5) - 2);
        world.setVelocity(Kind.LINE, k, vx, 0.3 * (random.nextInt(5) - 2));
      }
      restored.restore(world.snapshot());
      world.advanceTo(frame + 1);
      restored.advanceTo(frame + 1);
      assertThat(restored.snapshot()).as("after frame %s", frame).isEqualTo(world.snapshot());
    }
  }

  /** What contact knew of obstacles is forgotten where others are restored. */
  @CollidingOrNot
  void whatWasTouchedBeforeARestoreDoesNotMatter(boolean collide) {
    SceneBuilder scene = Scene.builder().collide(collide).gravity(0, -10).peg(0, 0, 1).peg(3, 0, 1);
    World used = new World(scene.circle(1.4, 8, 1, 0, 0).restitution(0.5).build());
    World moved = new World(used.scene());
    moved.setTraits(Kind.PEG, 0, moved.traits(Kind.PEG, 0).withRestitution(0.25));
    used.advanceTo(30);
    used.restore(moved.snapshot());
    used.advanceTo(30);
    moved.advanceTo(30);
    assertThat(used.snapshot()).isEqualTo(moved.snapshot());
  }
}
