// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Scene;
import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.experiment.Crosses;
import dev.carom.bench.experiment.Gas;
import dev.carom.bench.fuzz.EndScene;
import dev.carom.bench.fuzz.FindingException;
import dev.carom.bench.fuzz.Soak;
import dev.carom.bench.fuzz.SoakResult;
import dev.carom.bench.fuzz.SoakTimes;
import java.io.PrintWriter;
import java.util.Arrays;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** Lets a world run for very many impacts. */
@Command(
    name = "soak",
    description = {
      "Runs a world for very many impacts and tells whether anything leaks or drifts.",
      "Reports escapes, crossings, energy, heap in use, and time per impact at the"
          + " start and at the end.",
      "Every flight from impact to impact is checked against every line. Fails if a"
          + " circle escapes or crosses, or the energy changes by more than 1e-11 of"
          + " itself.",
      "With --scene it runs a random scene of a kind in which impacts would not end"
          + " without a rule, and checks each step as fuzz does."
    },
    footer = {"", "Example: carom-bench soak --gas --impacts 1000000"},
    mixinStandardHelpOptions = true,
    sortOptions = false)
final class SoakCommand implements Callable<Integer> {

  private static final double PACKING = 0.2;

  @Spec private CommandSpec spec;

  @Option(
      names = "--impacts",
      paramLabel = "N",
      defaultValue = "10000000",
      description = "How many impacts, at least 100,000 (default: ${DEFAULT-VALUE}).")
  private long impacts;

  @Option(
      names = "--gas",
      description = "A gas of circles that collide, instead of the canonical scene.")
  private boolean gas;

  @Option(
      names = "--scene",
      paramLabel = "KIND",
      converter = Kinds.class,
      description = {
        "A scene on which the end rule works, instead of the canonical one: trapped circles,"
            + " pockets of some ulps, infinite masses, doors that crush balls, a heap that each"
            + " step pushes downwards, or bumpers; or balls under gravity: a fall among slopes and"
            + " pegs, a pile, or plinko (${COMPLETION-CANDIDATES})."
      })
  private EndScene.Kind kind;

  @Option(
      names = "--circles",
      paramLabel = "N",
      description = "How many circles (default: 100; of the gas 1,000).")
  private Integer circles;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Which of the random scenes (default: ${DEFAULT-VALUE}).")
  private long seed;

  @Override
  public Integer call() throws CannotPlaceException {
    Bounded.atLeast(100_000, "--impacts", impacts, spec);
    if (kind != null && (gas || circles != null)) {
      String other = gas ? "--gas" : "--circles";
      throw new ParameterException(
          spec.commandLine(), "--scene and " + other + " exclude each other");
    }
    if (kind != null) {
      runKind();
      return 0;
    }
    Scene scene = scene();
    PrintWriter out = spec.commandLine().getOut();
    out.printf(
        "soak       %s--circles %d --seed %d%n", gas ? "--gas " : "", scene.circleCount(), seed);
    out.flush();
    SoakResult result = run(scene);
    out.print(result.render());
    out.flush();
    if (!result.holds()) {
      throw new IllegalStateException("the run does not hold what it must: see above");
    }
    return 0;
  }

  private void runKind() {
    PrintWriter out = spec.commandLine().getOut();
    out.printf("soak       --scene %s --seed %d%n", kind, seed);
    out.flush();
    try (Progress progress = Progress.start("soak", Soak.ROUNDS)) {
      RoundsLeft left = new RoundsLeft(progress, spec.commandLine().getErr());
      SoakTimes times = Soak.run(kind, seed, impacts, round -> left.tell(round, Soak.ROUNDS));
      out.print(times.render(""));
      out.flush();
    } catch (FindingException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private SoakResult run(Scene scene) {
    try (Progress progress = Progress.start("soak", Soak.ROUNDS)) {
      RoundsLeft left = new RoundsLeft(progress, spec.commandLine().getErr());
      return Soak.run(scene, impacts, round -> left.tell(round, Soak.ROUNDS));
    }
  }

  private Scene scene() throws CannotPlaceException {
    try {
      return gas
          ? new Gas(circles == null ? 1_000 : circles, PACKING, 1, false, seed).scene()
          : new Crosses(circles == null ? 100 : circles, 50, 10, 1, 10, seed).scene();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }

  /** Finds a kind of scene by its name. */
  static final class Kinds implements ITypeConverter<EndScene.Kind> {
    @Override
    public EndScene.Kind convert(String word) {
      return Arrays.stream(EndScene.Kind.values())
          .filter(each -> each.toString().equals(word))
          .findFirst()
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'%s' is none of %s"
                          .formatted(word, Arrays.toString(EndScene.Kind.values()))));
    }
  }
}
