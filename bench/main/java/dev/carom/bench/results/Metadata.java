// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import java.util.Map;
import java.util.TreeMap;

/**
 * Where results come from: what it takes to tell whether two sets may be put together, and to
 * measure again.
 *
 * @param cpu the processor's name
 * @param cores how many of its cores are ours
 * @param os the operating system's name, version and kind of machine
 * @param jdk the virtual machine's name and version
 * @param flags the options it was started with
 * @param commit of the sources, or {@code unknown}
 * @param scenes the SHA-256 of each scene file, by the scene's name
 * @param seeds the seeds of what was drawn at random, by its name
 * @param date of the run, as the caller gave it
 * @param quick whether the short run was asked for, which has fewer forks and values
 */
public record Metadata(
    String cpu,
    int cores,
    String os,
    String jdk,
    String flags,
    String commit,
    Map<String, String> scenes,
    Map<String, Long> seeds,
    String date,
    boolean quick) {

  /** Keeps copies, sorted by name. */
  public Metadata {
    scenes = new TreeMap<>(scenes);
    seeds = new TreeMap<>(seeds);
  }

  /**
   * Whether rows of both may stand in one table: all but the date is the same.
   *
   * @return whether they match
   */
  public boolean matches(Metadata other) {
    return equals(
        new Metadata(
            other.cpu,
            other.cores,
            other.os,
            other.jdk,
            other.flags,
            other.commit,
            other.scenes,
            other.seeds,
            date,
            other.quick));
  }
}
