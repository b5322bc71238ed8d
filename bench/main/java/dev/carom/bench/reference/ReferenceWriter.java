// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Stores the course of a scene, deflated. Not 600 states a circle but its flights: the state at the
 * first frame of each, as heads and, where more than one frame needs them, tails.
 *
 * <p>Numbers are big-endian. First the version, the frames and the circles; from version 2 on the
 * gravity as two doubles, which a course without gravity does without; then for each circle the
 * number of its stretches and their first frames, the stretches (four doubles, and four floats
 * where it is longer than a frame), and the conditioning: thousandths of the base-10 logarithm, the
 * first one and then differences, each as an int.
 */
final class ReferenceWriter {

  static final int STRAIGHT = 1;
  static final int FALLING = 2;

  /** Thousandths of the logarithm at which the conditioning is called infinite. */
  static final int MOST = 300_001;

  private ReferenceWriter() {}

  static void write(Truth truth, OutputStream target) throws IOException {
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
    try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(target, deflater))) {
      double[] gravity = truth.gravity();
      boolean falling = gravity[0] != 0 || gravity[1] != 0;
      out.writeInt(falling ? FALLING : STRAIGHT);
      out.writeInt(truth.frames());
      out.writeInt(truth.circles());
      for (int axis = 0; axis < gravity.length && falling; axis++) {
        out.writeDouble(gravity[axis]);
      }
      for (int i = 0; i < truth.circles(); i++) {
        writeStretches(stretches(truth.course(i), gravity), truth.frames(), out);
        writeConditioning(truth, i, out);
      }
    } finally {
      deflater.end();
    }
  }

  /** As few as give each state to the last bit. */
  static List<Stretch> stretches(CircleFrames course, double[] gravity) {
    List<Stretch> stretches = new ArrayList<>();
    Stretch last = null;
    for (int frame = 0; frame < course.states.length; frame++) {
      boolean same = last != null && course.flights[frame] == course.flights[last.start];
      if (!same || !last.tells(course, frame)) {
        last = Stretch.of(course, frame, gravity);
        stretches.add(last);
      }
    }
    return stretches;
  }

  private static void writeStretches(List<Stretch> stretches, int frames, DataOutputStream out)
      throws IOException {
    out.writeInt(stretches.size());
    for (Stretch stretch : stretches) {
      out.writeInt(stretch.start);
    }
    for (int i = 0; i < stretches.size(); i++) {
      Stretch stretch = stretches.get(i);
      int end = i + 1 < stretches.size() ? stretches.get(i + 1).start : frames + 1;
      for (double head : stretch.heads) {
        out.writeDouble(head);
      }
      if (end > stretch.start + 1) {
        for (float tail : stretch.tails) {
          out.writeFloat(tail);
        }
      }
    }
  }

  private static void writeConditioning(Truth truth, int circle, DataOutputStream out)
      throws IOException {
    int last = 0;
    for (int frame = 0; frame <= truth.frames(); frame++) {
      double log = truth.log10Conditioning(frame, circle);
      int thousandths = (int) Math.max(-MOST, Math.min(MOST, Math.rint(1000 * log)));
      out.writeInt(thousandths - last);
      last = thousandths;
    }
  }
}
