// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import dev.carom.bench.cli.CaromBench;
import java.util.Locale;

/** Where {@code java -jar carom-bench.jar} starts. */
public final class Main {

  private Main() {}

  /**
   * Runs one command and exits with its code: 0 when all went well, 1 for a failed run or bad data,
   * 2 for a command line that cannot be understood. The language of the machine changes no output.
   *
   * @param args the command and its options
   */
  public static void main(String[] args) {
    Locale.setDefault(Locale.ROOT);
    System.exit(CaromBench.execute(args));
  }
}
