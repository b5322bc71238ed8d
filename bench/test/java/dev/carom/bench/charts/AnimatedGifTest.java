// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.Test;

class AnimatedGifTest {

  private static final int FRAMES = 7;

  /** A red square on white that moves to the right, 4 pixels a frame. */
  private static final List<BufferedImage> SQUARES =
      IntStream.range(0, FRAMES).mapToObj(AnimatedGifTest::square).toList();

  private static BufferedImage square(int frame) {
    BufferedImage image = new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setColor(Color.WHITE);
    g.fillRect(0, 0, 40, 20);
    g.setColor(Color.RED);
    g.fillRect(4 * frame, 5, 8, 8);
    g.dispose();
    return image;
  }

  @Test
  void hasEveryFrameAndShowsThemAsTheyWere() throws IOException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    byte[] gif = AnimatedGif.of(SQUARES, 16, 4, 100);
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(gif)));
    assertThat(reader.getNumImages(true)).isEqualTo(FRAMES);
    BufferedImage screen = new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < FRAMES; i++) {
      screen.createGraphics().drawImage(reader.read(i), 0, 0, null);
      assertThat(Palette.pixels(screen)).isEqualTo(Palette.pixels(SQUARES.get(i)));
    }
  }

  @Test
  void playsForEverWithOnePaletteForAll() throws IOException {
    String gif = new String(AnimatedGif.of(SQUARES, 16, 4, 100), StandardCharsets.ISO_8859_1);
    assertThat(gif).startsWith("GIF89a").containsOnlyOnce("NETSCAPE2.0\3\1\0\0\0");
    // An image: its control (4 hundredths, transparent 15), perhaps the loop, then its descriptor,
    // the whole 40 x 20 without a table of its own.
    assertThat(gif.split("\\x21\\xF9\\x04\\x05\\x04\\x00\\x0F\\x00", -1)).hasSize(FRAMES);
    assertThat(gif.split("\\x21\\xF9\\x04\\x05\\x64\\x00\\x0F\\x00", -1)).hasSize(2);
    assertThat(gif.split("\\x2C\\x00{4}\\x28\\x00\\x14\\x00[\\x00-\\x7F]", -1)).hasSize(FRAMES + 1);
  }

  @Test
  void fewColorsStandForMany() {
    BufferedImage rainbow = new BufferedImage(360, 1, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < 360; x++) {
      rainbow.setRGB(x, 0, Color.HSBtoRGB(x / 360f, 1, 1));
    }
    Palette palette = Palette.of(List.of(rainbow), 16);
    assertThat(palette.size()).isEqualTo(15);
    assertThat(palette.index(palette.color(3))).isEqualTo(3);
  }
}
