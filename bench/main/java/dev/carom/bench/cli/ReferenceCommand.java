// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Kind;
import dev.carom.Scene;
import dev.carom.bench.reference.LastPlace;
import dev.carom.bench.reference.References;
import dev.carom.bench.reference.Truth;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Computes what really happens in the experiment's scenes. */
@Command(
    name = "reference",
    description = {
      "Computes what really happens in the experiment's scenes, and in one with gravity.",
      "Event after event in arbitrary precision, each decision proved, until every"
          + " place is known to the last bit of a double and a run with twice the digits"
          + " agrees. Takes about two minutes.",
      "With --scene FILE it prints where the circles of any small scene are at the end, in as many"
          + " digits as asked."
    },
    footer = {"", "Example: carom-bench reference base-1 --frames 100"})
final class ReferenceCommand extends BenchCommand {

  private static final double DIGITS_PER_BIT = Math.log10(2);

  private static final String HEADER =
      "scene   circles  impacts  digits: least  median   most  10^x worst  seconds    bytes";

  @Parameters(
      paramLabel = "SCENE",
      arity = "0..*",
      description = "base-1, base-2, base-3, fast-1, radii or falling (default: all of them).")
  private List<String> scenes;

  @Option(
      names = "--scene",
      paramLabel = "FILE",
      description = "Print circle,x,y at the end for a scene from a file, instead of SCENE.")
  private Path file;

  @Option(
      names = "--digits",
      paramLabel = "N",
      defaultValue = "30",
      description =
          "Digits behind the point, with --scene; at most 39,000 (default: ${DEFAULT-VALUE}).")
  private int digits;

  @Option(
      names = "--frames",
      paramLabel = "N",
      defaultValue = "600",
      description = "How many frames, each one unit of time (default: ${DEFAULT-VALUE}).")
  private int frames;

  @Option(
      names = "--write",
      paramLabel = "DIR",
      description = "Store the references, as they stand in this jar.")
  private Path folder;

  @Override
  void run() throws IOException {
    Bounded.atLeast(1, "--frames", frames, spec);
    Bounded.atLeast(0, "--digits", digits, spec);
    Bounded.atMost(LastPlace.MOST_DECIMALS, "--digits", digits, spec);
    if (file != null) {
      printLastPlaces();
      return;
    }
    if (isGiven("--digits")) {
      throw refused("--digits needs --scene");
    }
    if (scenes == null) {
      scenes = References.STORED;
    }
    for (String name : scenes) {
      if (!References.STORED.contains(name)) {
        throw refused("SCENE is " + name + ": expected one of " + References.STORED);
      }
    }
    println(HEADER);
    for (String name : scenes) {
      println(truth(name, References.scene(name)));
    }
  }

  private void printLastPlaces() throws IOException {
    if (scenes != null || folder != null) {
      throw refused("--scene excludes SCENE and --write");
    }
    PrintWriter out = spec.commandLine().getOut();
    Scene scene = Scene.read(file);
    List<LastPlace> places;
    try (Progress progress = Progress.start(file.toString(), scene.count(Kind.CIRCLE))) {
      places = LastPlace.of(scene, frames, digits, progress::step);
    }
    out.println("circle,x,y");
    for (LastPlace place : places) {
      out.println(
          place.circle() + "," + place.x().toPlainString() + "," + place.y().toPlainString());
    }
    out.flush();
  }

  private String truth(String name, Scene scene) throws IOException {
    long start = System.nanoTime();
    Truth truth;
    try (Progress progress = Progress.start(name, scene.count(Kind.CIRCLE))) {
      truth = Truth.of(scene, frames, progress::step);
    }
    double seconds = (System.nanoTime() - start) / 1e9;
    int[] bits = truth.neededBits();
    return String.format(
        Locale.ROOT,
        "%-6s  %7d  %,7d  %13.0f  %6.0f  %5.0f  %10.1f  %7.1f  %7s",
        name,
        truth.circles(),
        truth.impacts(),
        bits[0] * DIGITS_PER_BIT,
        bits[bits.length / 2] * DIGITS_PER_BIT,
        bits[bits.length - 1] * DIGITS_PER_BIT,
        truth.worstLog10Conditioning(),
        seconds,
        folder == null
            ? "-"
            : String.format(Locale.ROOT, "%,d", References.write(truth, name, folder)));
  }
}
