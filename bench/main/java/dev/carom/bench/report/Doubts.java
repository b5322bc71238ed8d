// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.util.List;

/** Questions of a careful reader, with the answers that no measurement gives. */
final class Doubts {

  private Doubts() {}

  static List<String> all() {
    return List.of(
        "Who measured? The authors of Carom, with a harness of their own; every number can be made"
            + " again by the command above, and the methods are short programs that can be read.",
        "What is timed? One call that moves all circles on by a frame; nothing is drawn. Carom and"
            + " the other event-driven methods compute a place when it is read, engines in that call:"
            + " to read all 100 takes Carom about 0.3 µs more (jmh -p circles=100"
            + " GrowthBenchmark.positions).",
        "Who says what is true? A program of its own, also by the authors of Carom: it computes in"
            + " as many digits as it takes, and shares no arithmetic with Carom.",
        "Are the engines treated fairly? Tables have each twice, at its defaults and tuned: as small"
            + " tolerances, no sleep and no lost speed as its settings allow. We may have missed a"
            + " better setting. They do more than Carom does: rotation, friction, polygons, joints,"
            + " stacks; none of that is used here.",
        "Where is Box2D 3? Its bindings for Java (box2d-jni of fabmax, box2d-jni of JNightRider,"
            + " gdx-box2d 3.1 of libGDX) did not resolve from Maven Central where this was built, so"
            + " Box2D 2 stands for it.",
        "Is one frame enough? Longer runs among ends of lines multiply every error, also that of the"
            + " start, until a run in doubles says nothing about who computes better; the charts of"
            + " runs show how soon. Energy, penetration and lost circles are of whole runs.",
        "Does exact mean that positions are exact? No. Decisions and times of impact are exact for"
            + " the doubles that a question has; the state after each impact is rounded to doubles.",
        "One machine: times are of the processor named above, with two cores that others may use."
            + " Ratios of one run are better evidence than its nanoseconds.");
  }
}
