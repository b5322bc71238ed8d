// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * Where the figures come from.
 *
 * @param cpu the processor's name and how many of its cores are ours
 * @param jdk the virtual machine's name and version
 * @param flags the options it was started with; forks get the same
 */
public record Machine(String cpu, String jdk, String flags) {

  private static final Path CPU_INFO = Path.of("/proc/cpuinfo");

  /** Looks at the machine that we run on, and returns its description. */
  public static Machine current() {
    return new Machine(
        "%s, %d cores".formatted(cpuName(), Runtime.getRuntime().availableProcessors()),
        "%s %s".formatted(System.getProperty("java.vm.name"), Runtime.version()),
        String.join(" ", ManagementFactory.getRuntimeMXBean().getInputArguments()));
  }

  /**
   * The name of the processor alone. Linux tells it in a file, Windows in the environment.
   *
   * @return the name; elsewhere the kind must do
   */
  public static String cpuName() {
    try (Stream<String> lines = Files.lines(CPU_INFO)) {
      return lines
          .filter(line -> line.startsWith("model name"))
          .map(line -> line.substring(line.indexOf(':') + 1).strip())
          .findFirst()
          .orElseGet(Machine::cpuKind);
    } catch (IOException e) {
      return cpuKind();
    }
  }

  private static String cpuKind() {
    String identifier = System.getenv("PROCESSOR_IDENTIFIER");
    return identifier == null ? System.getProperty("os.arch") : identifier;
  }
}
