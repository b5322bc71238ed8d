// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Outcome;
import dev.carom.Scene;
import dev.carom.World;
import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * SHA-256 over the bits of a run: of every impact in the order of the log (time, circle, kind,
 * obstacle, feature, contact point, normal, approach speed, whether it jams or settles), and of
 * every circle's place and velocity at the end. How the run is cut into frames does not matter.
 *
 * <p>The arithmetic's order decides these bits, and nothing else does: not the virtual machine, its
 * compilers, or the processor. So a change of the order of operations in the library changes the
 * hash, and so does a change of the scene.
 */
public final class RunHash {

  /** Bytes of one row: six doubles, two numbers, three small ones; and more than one of a state. */
  private static final int ROW = 6 * Double.BYTES + 2 * Integer.BYTES + 3;

  private static final int BUFFER = 1 << 14;

  /** The most impacts that a call lists in the log: their rows take some 160 MB. */
  private static final long WORK = 2_000_000;

  private final MessageDigest digest = sha256();
  private final ByteBuffer bytes = ByteBuffer.allocate(BUFFER);
  private final String hex;
  private long impacts;

  private RunHash(Scene scene, int frames) {
    World world = new World(scene);
    for (int frame = 1; frame <= frames; frame++) {
      boolean complete;
      do {
        complete = world.advanceTo(frame, WORK);
        add(world.impacts());
      } while (!complete);
    }
    addStates(world);
    flush();
    hex = HexFormat.of().formatHex(digest.digest());
  }

  /**
   * Runs a scene.
   *
   * @param frames how many units of time, at least 0
   */
  public static RunHash of(Scene scene, int frames) {
    return new RunHash(scene, frames);
  }

  /** 64 hexadecimal digits. */
  public String hex() {
    return hex;
  }

  /** How many impacts the run had. */
  public long impacts() {
    return impacts;
  }

  private void add(ImpactLog log) {
    impacts += log.size();
    for (int row = 0; row < log.size(); row++) {
      makeRoom();
      bytes
          .putDouble(log.time(row))
          .putInt(log.circle(row))
          .put((byte) log.kind(row).ordinal())
          .putInt(log.id(row))
          .put((byte) log.feature(row).ordinal())
          .putDouble(log.x(row))
          .putDouble(log.y(row))
          .putDouble(log.nx(row))
          .putDouble(log.ny(row))
          .putDouble(log.approachSpeed(row))
          .put(outcome(log.outcome(row)));
    }
  }

  /** The other outcomes follow from the rest of the row and the scene. */
  private static byte outcome(Outcome outcome) {
    return (byte)
        switch (outcome) {
          case JAMMED -> 1;
          case SETTLED -> 2;
          default -> 0;
        };
  }

  private void addStates(World world) {
    for (int i = 0; i < world.count(Kind.CIRCLE); i++) {
      makeRoom();
      bytes
          .putDouble(world.x(i))
          .putDouble(world.y(i))
          .putDouble(world.vx(i))
          .putDouble(world.vy(i));
    }
  }

  private void makeRoom() {
    if (bytes.remaining() < ROW) {
      flush();
    }
  }

  private void flush() {
    digest.update(bytes.flip());
    bytes.clear();
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has it", e);
    }
  }
}
