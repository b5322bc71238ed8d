// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.bench.experiment.CannotPlaceException;
import dev.carom.bench.replay.GoldenRun;
import dev.carom.bench.replay.RunHash;
import dev.carom.bench.replay.StoredHashes;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Tells the hash of runs, and whether they are those of every other machine. */
@Command(
    name = "hash",
    description = {
      "Compares the bits of golden runs with stored hashes.",
      "Plays four long runs (lines; pairs; all mixed; falls). The hash is the SHA-256"
          + " over the bits of all their impacts, and of places and velocities at the end:"
          + " it is the same on every virtual machine. Takes seconds, with --long 10.",
      "With --frames it tells the hash of a scene of your own, which 'replay --demand' takes."
    },
    footer = {"", "Example: carom-bench hash --scene scene.csv --frames 600"})
final class HashCommand extends BenchCommand {

  @Mixin private SceneOptions scene;

  @Option(
      names = "--frames",
      paramLabel = "N",
      description = "Hash so many frames of one scene, instead of the stored runs.")
  private Integer frames;

  @Option(names = "--long", description = "Play the stored runs 20 times as long, too.")
  private boolean longToo;

  @Override
  void run() throws IOException, CannotPlaceException {
    PrintWriter out = spec.commandLine().getOut();
    if (frames != null && longToo) {
      throw refused("--frames and --long exclude each other");
    }
    if (frames != null) {
      Bounded.atLeast(0, "--frames", frames, spec);
      out.println(RunHash.of(scene.scene(), frames).hex());
      out.flush();
      return;
    }
    if (scene.isGiven()) {
      throw refused("--frames is missing: expected how many frames of that scene");
    }
    playGoldenRuns(out);
  }

  /** Prints all of them, also those after one that differs. */
  private void playGoldenRuns(PrintWriter out) throws IOException, CannotPlaceException {
    StoredHashes stored = StoredHashes.read();
    List<String> differing = new ArrayList<>();
    for (boolean longer : longToo ? new boolean[] {false, true} : new boolean[] {false}) {
      for (GoldenRun run : GoldenRun.values()) {
        RunHash hash = run.play(longer);
        String label = run.label(longer);
        boolean same = hash.hex().equals(stored.of(label));
        out.printf(
            Locale.ROOT,
            "%-10s %s  %,9d impacts in %,7d frames, %s%n",
            label,
            hash.hex(),
            hash.impacts(),
            run.frames(longer),
            same ? "as stored" : "NOT AS STORED");
        out.flush();
        if (!same) {
          differing.add(label + ": expected " + stored.of(label));
        }
      }
    }
    if (!differing.isEmpty()) {
      throw new IllegalStateException(
          String.join("; ", differing)
              + ". Either the order of the arithmetic or a scene has changed, or this virtual"
              + " machine computes in another way");
    }
  }
}
