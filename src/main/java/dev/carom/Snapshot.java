// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import dev.carom.internal.io.SnapshotFile;
import dev.carom.internal.state.WorldState;
import dev.carom.internal.util.Check;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/**
 * A {@code Snapshot} is a copy of everything that determines the future of a {@link World}. It
 * serves saved games, and netcode that goes back to play a late input. Immutable, safe for use by
 * several threads.
 *
 * <pre>{@code
 * World world =
 *     new World(Scene.builder().bounds(0, 0, 100, 100).circle(50, 50, 10, 8, 0).build());
 * Snapshot saved = world.snapshot();
 * world.step(6);
 * System.out.println(world.x(0)); // 82.0
 * world.restore(saved);
 * world.setVelocity(0, 0, 3);
 * world.step(6);
 * System.out.println(world.y(0)); // 68.0
 * }</pre>
 *
 * <p>To load a saved game, make a world of any scene with equal bounds and the same {@link
 * Scene#collide collide}, and restore the snapshot that {@link #read read} returns.
 *
 * <p>A world into which a snapshot is restored goes on as the one it was taken from, bit for bit.
 * Equal snapshots mean equal futures. Two worlds with equal snapshots that get the same edits and
 * steps have equal snapshots at every moment, so a game can compare two machines.
 *
 * <p>Two things are not in it: the log of the last step, and caches. So after {@link World#restore
 * World.restore} the next step searches once for every circle.
 */
public final class Snapshot {

  final WorldState state;

  Snapshot(WorldState state) {
    this.state = state;
  }

  /**
   * Returns the time at which the snapshot was taken.
   *
   * @return at least 0
   */
  public double now() {
    return state.now();
  }

  /**
   * Reads a snapshot.
   *
   * @param in where to read, buffered for speed; it is not closed, and read no further than the
   *     snapshot goes
   * @return the snapshot
   * @throws IOException if reading fails, or if the bytes are not a whole snapshot, written by
   *     {@link #write} in a version that this library knows; the message says what is wrong
   */
  public static Snapshot read(InputStream in) throws IOException {
    return new Snapshot(SnapshotFile.read(Check.notNull("in", in)));
  }

  /**
   * Writes this snapshot in a format of its own, with a version and a check sum.
   *
   * <p>It takes 105 bytes a circle, 41 a line, 33 a peg, and 151 for the rest, 119 without bounds.
   * To these come 84 more for each line or peg that moves or moved before, and 1 for each that was
   * removed. Each side of an outline is a line, and each but its first takes 4 more. Some states of
   * one circle make all circles larger:
   *
   * <ul>
   *   <li>If any circle falls, slides or rests, all take 24 more.
   *   <li>If any circles are in contact under gravity, all take 20 more. Each of them takes 208
   *       more, and 32 for each thing near it.
   *   <li>If a sensor reported another circle in the present flight of any, all take 24 more.
   *   <li>If any circle is jammed, all take 4 more, and 4 for each thing that they are jammed by.
   *   <li>If any circle, line or peg has a {@linkplain Filter filter} of its own, all of its kind
   *       take 8 more.
   * </ul>
   *
   * @param out where to write, buffered for speed; it is neither flushed nor closed
   * @throws IOException if writing fails
   */
  public void write(OutputStream out) throws IOException {
    SnapshotFile.write(state, Check.notNull("out", out));
  }

  /**
   * Returns a hash of 64 bits, to compare the states of two machines without sending them.
   *
   * <p>It is the first 8 bytes, big-endian, of the SHA-256 digest of the bytes that {@link #write
   * write} writes. Equal snapshots have equal hashes, on every machine and Java virtual machine.
   * Two unequal ones have the same hash with a probability of 2^-64. A version of this library that
   * writes another format computes other hashes. A call takes time in proportion to the circles,
   * lines and pegs.
   *
   * @return the hash
   */
  public long hash64() {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      OutputStream out = new DigestOutputStream(OutputStream.nullOutputStream(), digest);
      BufferedOutputStream buffered = new BufferedOutputStream(out);
      write(buffered);
      buffered.flush();
      return ByteBuffer.wrap(digest.digest()).getLong();
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("each Java platform must have SHA-256", e);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // nothing is written anywhere
    }
  }

  /**
   * Tells whether another snapshot holds the same, to the bit. Then the futures of the two are
   * equal.
   *
   * <p>Worlds that went the same way in steps of different lengths have equal snapshots. The
   * exception to equal futures are circles that collide so fast that they <a
   * href="doc-files/rules.html#extreme">outrun the clock</a>.
   *
   * @param other any object
   * @return whether it is an equal snapshot
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof Snapshot that && state.equals(that.state);
  }

  @Override
  public int hashCode() {
    return state.flights().hashCode();
  }

  @Override
  public String toString() {
    return "Snapshot[now=%s, circles=%s, lines and pegs=%s]"
        .formatted(state.now(), state.registry().count(), state.obstacles().size());
  }
}
