// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.sweep;

import dev.carom.internal.exact.Gaps;
import dev.carom.internal.util.Part;

/**
 * The codes of contacts: the part of a line or a disk that is hit first, and whether the impact is
 * at time 0.
 */
public final class Contact {

  /** Not a contact: plain doubles cannot decide, so the detector must. */
  public static final int DOUBT = -1;

  /** No impact. */
  public static final int MISS = 0;

  /** On the side of a line, the disk left of it; it may have {@link #NOW} added. */
  public static final int LEFT = 1;

  /** On the side of a line, the disk right of it; it may have {@link #NOW} added. */
  public static final int RIGHT = 2;

  /** On the start of a line; it may have {@link #NOW} added. */
  public static final int START = 3;

  /** On the end of a line; it may have {@link #NOW} added. */
  public static final int END = 4;

  /** On a disk, at a time above 0. */
  public static final int LATER = 5;

  /** On a disk at time 0; added to the part of a line where the impact is at time 0. */
  public static final int NOW = 8;

  /** The {@link Part} that is hit, by the contact without {@link #NOW}. */
  private static final int[] PARTS = {
    Part.CIRCLE, Part.SIDE, Part.SIDE, Part.START, Part.END, Part.CIRCLE
  };

  /** The region of {@link Gaps} in which a disk is, by the contact without {@link #NOW}. */
  private static final int[] REGIONS = {
    Gaps.BEFORE, Gaps.BESIDE, Gaps.BESIDE, Gaps.BEFORE, Gaps.BEYOND, Gaps.BEFORE
  };

  private Contact() {}

  /** The part of a line that is hit, {@link #LEFT} to {@link #END}; 0 or LATER on a disk. */
  public static int withoutTime(int contact) {
    return contact & ~NOW;
  }

  /** The region of {@link Gaps} in which the centre of a disk is at a contact. */
  public static int region(int contact) {
    return REGIONS[withoutTime(contact)];
  }

  /** The {@link Part} of a line or a disk that a contact stands for. */
  public static int part(int contact) {
    return PARTS[withoutTime(contact)];
  }
}
