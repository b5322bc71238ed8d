// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

/** The exact answer to a question, to which a detector's is held. */
public interface Truth {

  /** What is hit. */
  Part part();

  /** The unit normal; null for a miss. */
  Normal normal();

  /** The correctly rounded time of impact, of two equally near doubles the even one. */
  double time();

  /** {@code (candidate - t) / ulp(t)}, rounded; infinite for a candidate that is not finite. */
  double errorInUlps(double candidate);

  default boolean hit() {
    return part() != Part.NONE;
  }

  /** The greatest error of a component of a given normal; infinite if it is not a number. */
  default double normalError(double nx, double ny) {
    double error = normal().error(nx, ny);
    return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
  }
}
