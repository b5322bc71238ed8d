// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import com.sun.management.ThreadMXBean;
import dev.carom.bench.methods.Method;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

/** Measures frames in the calling thread. */
final class Stopwatch {

  private static final int EMPTY_PAIRS = 10_001;

  private Stopwatch() {}

  /** Plays as many frames as there is room, and writes down the nanoseconds of each. */
  static void play(Method method, long[] nanos) {
    for (int frame = 0; frame < nanos.length; frame++) {
      long start = System.nanoTime();
      method.frame();
      nanos[frame] = System.nanoTime() - start;
    }
  }

  /** The bytes that this thread allocates while it plays a number of frames. */
  static long bytesAllocated(Method method, int frames) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long[] nanos = new long[frames];
    long thread = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(thread);
    long asking = threads.getThreadAllocatedBytes(thread) - before;
    before = threads.getThreadAllocatedBytes(thread);
    play(method, nanos);
    return threads.getThreadAllocatedBytes(thread) - before - asking;
  }

  /** The cost of the two time stamps around a frame: the median of many empty pairs. */
  static long emptyPairNanos() {
    long[] nanos = new long[EMPTY_PAIRS];
    for (int i = 0; i < nanos.length; i++) {
      long start = System.nanoTime();
      nanos[i] = System.nanoTime() - start;
    }
    Arrays.sort(nanos);
    return nanos[nanos.length / 2];
  }
}
