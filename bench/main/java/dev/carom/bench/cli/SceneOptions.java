// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The scene that is to be played: one from a file, or one of crosses from a seed. */
final class SceneOptions {

  private static final List<String> GENERATOR =
      List.of("--circles", "--crosses", "--radius", "--speed", "--seed");
  private static final int OTHERS = 4;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--scene",
      paramLabel = "FILE",
      description = "Read the scene from a file, instead of generating one.")
  private Path file;

  @Option(
      names = "--circles",
      paramLabel = "N",
      defaultValue = "100",
      description = "Circles of the generated scene (default: ${DEFAULT-VALUE}).")
  private int circles;

  @Option(
      names = "--crosses",
      paramLabel = "N",
      defaultValue = "50",
      description = "Crosses, two lines each (default: ${DEFAULT-VALUE}).")
  private int crosses;

  @Option(
      names = "--radius",
      paramLabel = "PX",
      defaultValue = "10",
      description = "Radius of every circle (default: ${DEFAULT-VALUE}).")
  private double radius;

  @Option(
      names = "--speed",
      paramLabel = "MIN..MAX",
      defaultValue = "1..10",
      converter = Speeds.Converter.class,
      description =
          "Speeds in px per frame, uniform in a range; one number is the speed of every circle"
              + " (default: ${DEFAULT-VALUE}).")
  private Speeds speeds;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Which of the random scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  /** The scene's file, null for one that is generated. */
  Path file() {
    return file;
  }

  /** The name of the scene: its file, or the options that generate it again. */
  String name() {
    if (file != null) {
      return file.toString();
    }
    return "crosses: --seed %d --circles %d --crosses %d --radius %s --speed %s"
        .formatted(seed, circles, crosses, Decimals.plain(radius), speeds);
  }

  /** A short name for the scene: its file without the folder, or what was generated. */
  String title() {
    return file == null || file.getFileName() == null
        ? "%d circles among %d crosses".formatted(circles, crosses)
        : file.getFileName().toString();
  }

  Scene scene() throws IOException, CannotPlaceException {
    if (file == null) {
      return generator().scene();
    }
    for (String option : GENERATOR) {
      if (isGiven(option)) {
        throw usage("--scene and " + option + " exclude each other");
      }
    }
    return Scene.read(file);
  }

  /** Whether some option names a scene; without one it is the canonical scene. */
  boolean isGiven() {
    return file != null || GENERATOR.stream().anyMatch(this::isGiven);
  }

  private boolean isGiven(String option) {
    return spec.commandLine().getParseResult().hasMatchedOption(option);
  }

  /** Scenes of the same kind with other seeds; beside a file, canonical ones. */
  List<Scene> others() throws CannotPlaceException {
    Crosses crossesOfOthers = file == null ? generator() : Crosses.canonical(0);
    List<Scene> scenes = new ArrayList<>();
    for (int i = 1; i <= OTHERS; i++) {
      scenes.add(crossesOfOthers.withSeed(crossesOfOthers.seed() + i).scene());
    }
    return scenes;
  }

  private Crosses generator() {
    try {
      return new Crosses(circles, crosses, radius, speeds.least(), speeds.most(), seed);
    } catch (IllegalArgumentException e) {
      throw Bounded.refused(e, spec);
    }
  }

  private ParameterException usage(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
