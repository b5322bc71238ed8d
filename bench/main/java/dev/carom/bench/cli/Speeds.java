// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * A range of speeds, written {@code 1..10}; one number is a range of its own.
 *
 * @param least the lowest speed
 * @param most the highest speed
 */
record Speeds(double least, double most) {

  @Override
  public String toString() {
    return Decimals.plain(least) + ".." + Decimals.plain(most);
  }

  /** Reads what stands on the command line. */
  static final class Converter implements ITypeConverter<Speeds> {

    @Override
    public Speeds convert(String text) {
      int dots = text.indexOf("..");
      try {
        double least = Double.parseDouble(dots < 0 ? text : text.substring(0, dots));
        double most = dots < 0 ? least : Double.parseDouble(text.substring(dots + 2));
        if (Double.isFinite(least) && Double.isFinite(most)) {
          return new Speeds(least, most);
        }
      } catch (NumberFormatException e) {
        throw refused(text);
      }
      throw refused(text);
    }

    private static TypeConversionException refused(String text) {
      return new TypeConversionException("'" + text + "' is not a speed, or a range such as 1..10");
    }
  }
}
