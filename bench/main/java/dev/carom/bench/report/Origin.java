// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import dev.carom.bench.replay.Machine;
import dev.carom.bench.results.Metadata;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Finds out where results will come from. */
public final class Origin {

  private static final String FOLDER = "/dev/carom/bench/scenes/";
  private static final List<String> SCENES =
      List.of("base-1", "base-2", "base-3", "fast-1", "radii");
  private static final String UNKNOWN = "unknown";
  private static final String OLD = ", %s commits old when this page was made";

  private Origin() {}

  /**
   * Looks at the machine, the sources and the scenes.
   *
   * @param seeds of what is drawn at random
   * @param date of the run
   * @param quick whether it is the short run
   * @throws IOException if a scene is not in the jar
   */
  public static Metadata of(Map<String, Long> seeds, String date, boolean quick)
      throws IOException {
    Machine machine = Machine.current();
    return new Metadata(
        Machine.cpuName(),
        Runtime.getRuntime().availableProcessors(),
        "%s %s, %s"
            .formatted(
                System.getProperty("os.name"),
                System.getProperty("os.version"),
                System.getProperty("os.arch")),
        machine.jdk(),
        machine.flags(),
        commit(),
        hashes(),
        seeds,
        date,
        quick);
  }

  private static Map<String, String> hashes() throws IOException {
    Map<String, String> hashes = new TreeMap<>();
    for (String scene : SCENES) {
      try (InputStream in = Origin.class.getResourceAsStream(FOLDER + scene + ".csv")) {
        if (in == null) {
          throw new IOException(FOLDER + scene + ".csv is not in the jar");
        }
        byte[] hash = MessageDigest.getInstance("SHA-256").digest(in.readAllBytes());
        hashes.put(scene, HexFormat.of().formatHex(hash));
      } catch (NoSuchAlgorithmException e) {
        throw new IllegalStateException("every Java has SHA-256", e);
      }
    }
    return hashes;
  }

  /**
   * The commit of the sources in the working folder, if they are under git; it says if they
   * changed.
   */
  private static String commit() {
    return git("describe", "--always", "--dirty", "--abbrev=40", "--exclude=*").orElse(UNKNOWN);
  }

  /** How old a measured commit is: words to stand behind it; none if that is not known here. */
  static String age(String commit) {
    String bare = commit.replace("-dirty", "");
    return bare.matches("[0-9a-f]{7,40}")
        ? git("rev-list", "--count", bare + "..HEAD").map(OLD::formatted).orElse("")
        : "";
  }

  /** What git says, or nothing if it cannot say. */
  private static Optional<String> git(String... arguments) {
    try {
      Process git =
          new ProcessBuilder(Stream.concat(Stream.of("git"), Stream.of(arguments)).toList())
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
      return git.waitFor() == 0 && !said.isEmpty() ? Optional.of(said) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
