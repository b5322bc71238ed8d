// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * The colours that serve several pictures best, for a format that has few: those that occur most,
 * each the mean of its neighbourhood; every other one becomes the nearest of them. The last index
 * is kept free for the transparent colour.
 */
final class Palette {

  /** Neighbourhoods: colours that agree in the upper 5 bits of red, green and blue. */
  private static final int CELLS = 1 << 15;

  /** A difference of 20 of 255 in each of red, green and blue. */
  private static final int ALIKE = 9 * 20 * 20;

  private final int[] colors;
  private final int[] nearest = new int[CELLS];

  private Palette(int[] colors) {
    this.colors = colors;
    Arrays.fill(nearest, -1);
  }

  /** At most so many colours, with the transparent one. */
  static Palette of(List<BufferedImage> images, int size) {
    long[][] cells = new long[CELLS][];
    for (BufferedImage image : images) {
      for (int rgb : pixels(image)) {
        count(cells, rgb);
      }
    }
    int[] colors =
        Arrays.stream(cells)
            .filter(cell -> cell != null)
            .sorted(Comparator.comparingLong((long[] cell) -> -cell[3])) // stable: ties by colour
            .mapToInt(Palette::mean)
            .toArray();
    return new Palette(distinct(colors, size - 1));
  }

  /** The first ones, without those that hardly differ from one before. */
  private static int[] distinct(int[] colors, int most) {
    int[] chosen = new int[most];
    int n = 0;
    for (int i = 0; i < colors.length && n < most; i++) {
      int color = colors[i];
      if (Arrays.stream(chosen, 0, n).allMatch(other -> distance(other, color) > ALIKE)) {
        chosen[n++] = color;
      }
    }
    return Arrays.copyOf(chosen, n);
  }

  static int[] pixels(BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static void count(long[][] cells, int rgb) {
    int cell = cell(rgb);
    if (cells[cell] == null) {
      cells[cell] = new long[4];
    }
    cells[cell][0] += rgb >> 16 & 255;
    cells[cell][1] += rgb >> 8 & 255;
    cells[cell][2] += rgb & 255;
    cells[cell][3]++;
  }

  private static int cell(int rgb) {
    return ((rgb >> 19 & 31) << 10) | ((rgb >> 11 & 31) << 5) | (rgb >> 3 & 31);
  }

  private static int mean(long[] cell) {
    long n = cell[3];
    return (int) (mean(cell[0], n) << 16 | mean(cell[1], n) << 8 | mean(cell[2], n));
  }

  private static long mean(long sum, long n) {
    return (sum + n / 2) / n;
  }

  /** The number of colours, without the transparent one. */
  int size() {
    return colors.length;
  }

  /** The colour at an index as 0xRRGGBB. */
  int color(int index) {
    return colors[index];
  }

  /** The index of the colour that stands for another. */
  int index(int rgb) {
    int cell = cell(rgb);
    if (nearest[cell] < 0) {
      nearest[cell] = search((rgb & 0xF8F8F8) | 0x040404); // by cell, not by who asks first
    }
    return nearest[cell];
  }

  private int search(int rgb) {
    int best = 0;
    for (int i = 1; i < colors.length; i++) {
      if (distance(colors[i], rgb) < distance(colors[best], rgb)) {
        best = i;
      }
    }
    return best;
  }

  /** Whether two indices stand for colours that hardly differ. */
  boolean alike(int a, int b) {
    return distance(colors[a], colors[b]) <= ALIKE;
  }

  private static int distance(int a, int b) {
    int red = (a >> 16 & 255) - (b >> 16 & 255);
    int green = (a >> 8 & 255) - (b >> 8 & 255);
    int blue = (a & 255) - (b & 255);
    return 2 * red * red + 4 * green * green + 3 * blue * blue;
  }
}
