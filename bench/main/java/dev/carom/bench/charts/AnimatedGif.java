// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.awt.image.SampleModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/**
 * Images of one size as a GIF that plays for ever. All share one palette, and each holds only the
 * pixels that changed to the eye, the others being transparent: that makes the file small.
 */
public final class AnimatedGif {

  private static final String STREAM = "javax_imageio_gif_stream_1.0";
  private static final String IMAGE = "javax_imageio_gif_image_1.0";

  private final List<BufferedImage> images;
  private final Palette palette;
  private final IndexColorModel colors;

  private AnimatedGif(List<BufferedImage> images, int colorCount) {
    this.images = images;
    palette = Palette.of(images, colorCount);
    colors = colorModel(palette, colorCount);
  }

  /**
   * The bytes of a GIF file.
   *
   * @param images at least one, all of one size
   * @param colorCount a power of two from 4 to 128
   * @param delay of each image in hundredths of a second
   * @param rest of the last image, before all begins again, in hundredths of a second
   * @throws IOException if this Java cannot write GIF
   */
  public static byte[] of(List<BufferedImage> images, int colorCount, int delay, int rest)
      throws IOException {
    return new AnimatedGif(images, colorCount).write(delay, rest);
  }

  private byte[] write(int delay, int rest) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
    try (ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.prepareWriteSequence(streamMetadata(writer));
      byte[] shown = new byte[images.get(0).getWidth() * images.get(0).getHeight()];
      Arrays.fill(shown, (byte) colors.getTransparentPixel());
      for (int i = 0; i < images.size(); i++) {
        BufferedImage changes = changes(shown, Palette.pixels(images.get(i)));
        IIOMetadata metadata = imageMetadata(writer, i == 0, i == images.size() - 1 ? rest : delay);
        writer.writeToSequence(new IIOImage(changes, null, metadata), null);
      }
      writer.endWriteSequence();
    } finally {
      writer.dispose();
    }
    return out.toByteArray();
  }

  /**
   * An image of the pixels that change, transparent elsewhere. Brings the shown indices up to date.
   */
  private BufferedImage changes(byte[] shown, int[] wanted) {
    int width = images.get(0).getWidth();
    int height = images.get(0).getHeight();
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colors);
    byte[] target = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
    for (int i = 0; i < wanted.length; i++) {
      int next = palette.index(wanted[i]);
      boolean stays = shown[i] != colors.getTransparentPixel() && palette.alike(shown[i], next);
      target[i] = (byte) (stays ? colors.getTransparentPixel() : next);
      shown[i] = stays ? shown[i] : (byte) next;
    }
    return image;
  }

  private static IndexColorModel colorModel(Palette palette, int count) {
    byte[] red = new byte[count];
    byte[] green = new byte[count];
    byte[] blue = new byte[count];
    for (int i = 0; i < palette.size(); i++) {
      red[i] = (byte) (palette.color(i) >> 16);
      green[i] = (byte) (palette.color(i) >> 8);
      blue[i] = (byte) palette.color(i);
    }
    int bits = Integer.numberOfTrailingZeros(count);
    return new IndexColorModel(bits, count, red, green, blue, count - 1);
  }

  private IIOMetadata streamMetadata(ImageWriter writer) throws IIOInvalidTreeException {
    IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
    IIOMetadataNode screen = node("LogicalScreenDescriptor");
    set(screen, "logicalScreenWidth", images.get(0).getWidth());
    set(screen, "logicalScreenHeight", images.get(0).getHeight());
    set(screen, "colorResolution", 8);
    set(screen, "pixelAspectRatio", 0);
    IIOMetadataNode table = node("GlobalColorTable");
    set(table, "sizeOfGlobalColorTable", colors.getMapSize());
    set(table, "backgroundColorIndex", 0);
    table.setAttribute("sortFlag", "FALSE");
    for (int i = 0; i < colors.getMapSize(); i++) {
      IIOMetadataNode entry = node("ColorTableEntry");
      set(entry, "index", i);
      set(entry, "red", colors.getRed(i));
      set(entry, "green", colors.getGreen(i));
      set(entry, "blue", colors.getBlue(i));
      table.appendChild(entry);
    }
    metadata.mergeTree(STREAM, tree(STREAM, screen, table));
    return metadata;
  }

  private IIOMetadata imageMetadata(ImageWriter writer, boolean first, int delay)
      throws IIOInvalidTreeException {
    // Not createFromRenderedImage: that forgets the colours and takes those of the web of 1996.
    SampleModel samples = colors.createCompatibleSampleModel(1, 1);
    ImageTypeSpecifier type = new ImageTypeSpecifier(colors, samples);
    IIOMetadata metadata = writer.getDefaultImageMetadata(type, null);
    IIOMetadataNode control = node("GraphicControlExtension");
    control.setAttribute("disposalMethod", "doNotDispose");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "TRUE");
    set(control, "delayTime", delay);
    set(control, "transparentColorIndex", colors.getTransparentPixel());
    metadata.mergeTree(IMAGE, first ? tree(IMAGE, control, loop()) : tree(IMAGE, control));
    return metadata;
  }

  /** The extension that Netscape 2.0 brought: 0 repetitions stand for no end. */
  private static IIOMetadataNode loop() {
    IIOMetadataNode extension = node("ApplicationExtension");
    extension.setAttribute("applicationID", "NETSCAPE");
    extension.setAttribute("authenticationCode", "2.0");
    extension.setUserObject(new byte[] {1, 0, 0});
    IIOMetadataNode extensions = node("ApplicationExtensions");
    extensions.appendChild(extension);
    return extensions;
  }

  private static IIOMetadataNode tree(String name, IIOMetadataNode... children) {
    IIOMetadataNode root = node(name);
    Arrays.asList(children).forEach(root::appendChild);
    return root;
  }

  private static IIOMetadataNode node(String name) {
    return new IIOMetadataNode(name);
  }

  private static void set(IIOMetadataNode node, String attribute, int value) {
    node.setAttribute(attribute, Integer.toString(value));
  }
}
