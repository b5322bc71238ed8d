// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.zip.InflaterInputStream;

/** Reads what {@link ReferenceWriter} wrote. */
final class ReferenceReader {

  private ReferenceReader() {}

  /** Reads a reference to its end; the name is for errors. */
  static Reference read(InputStream source, String name) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(new InflaterInputStream(source)))) {
      int version = in.readInt();
      boolean falling = version == ReferenceWriter.FALLING;
      if (version != ReferenceWriter.STRAIGHT && !falling) {
        throw new IOException(
            "%s: version %d: expected %d or %d"
                .formatted(name, version, ReferenceWriter.STRAIGHT, ReferenceWriter.FALLING));
      }
      int frames = in.readInt();
      int circles = in.readInt();
      double[] gravity = {falling ? in.readDouble() : 0, falling ? in.readDouble() : 0};
      double[][][] states = new double[circles][][];
      float[][] conditioning = new float[circles][];
      for (int i = 0; i < circles; i++) {
        states[i] = readStates(frames, gravity, in);
        conditioning[i] = readConditioning(frames, in);
      }
      return new StoredReference(frames, states, conditioning);
    }
  }

  private static double[][] readStates(int frames, double[] gravity, DataInputStream in)
      throws IOException {
    int[] starts = new int[in.readInt() + 1];
    for (int i = 0; i < starts.length - 1; i++) {
      starts[i] = in.readInt();
    }
    starts[starts.length - 1] = frames + 1;
    double[][] states = new double[frames + 1][];
    for (int i = 0; i < starts.length - 1; i++) {
      Stretch stretch = readStretch(starts[i], starts[i + 1], gravity, in);
      for (int frame = starts[i]; frame < starts[i + 1]; frame++) {
        states[frame] =
            new double[] {
              stretch.place(0, frame),
              stretch.place(1, frame),
              stretch.velocity(0, frame),
              stretch.velocity(1, frame)
            };
      }
    }
    return states;
  }

  private static Stretch readStretch(int start, int end, double[] gravity, DataInputStream in)
      throws IOException {
    double[] heads = new double[CircleFrames.TAILS];
    float[] tails = new float[CircleFrames.TAILS];
    for (int i = 0; i < heads.length; i++) {
      heads[i] = in.readDouble();
    }
    for (int i = 0; i < tails.length && end > start + 1; i++) {
      tails[i] = in.readFloat();
    }
    return new Stretch(start, heads, tails, gravity);
  }

  private static float[] readConditioning(int frames, DataInputStream in) throws IOException {
    float[] logs = new float[frames + 1];
    int thousandths = 0;
    for (int frame = 0; frame <= frames; frame++) {
      thousandths += in.readInt();
      boolean finite = Math.abs(thousandths) < ReferenceWriter.MOST;
      logs[frame] = finite ? thousandths / 1000f : thousandths * Float.POSITIVE_INFINITY;
    }
    return logs;
  }
}
