// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import java.util.Arrays;

/**
 * Flights of circles and all else that determines their future, in flat arrays: one row each. The
 * live circles, the undo log, snapshots and the recorded past are tables of this kind. A row goes
 * from one table to another by way of a {@link MovingCircle}. So a new field of a circle needs one
 * line in a {@code get} and one in a {@code put} here, and no more.
 *
 * <p>Each row has the columns of its flight and of the circle's past impacts. The columns of its
 * next impact are missing in the recorded past. Other columns exist only once a circle needs them:
 * those of gravity, of contact, of sensors among circles, and the ignore lists of jammed circles.
 * What was never stored in a row reads as zeros, so these stand for a circle without any of that.
 */
public class FlightTable {

  // The columns of doubles, after those of a FlightRow.
  public static final int CLEARED = FlightRow.SIZE;
  public static final int RESTITUTION = 8;
  static final int NUMBERS = 9;

  // In the past the ints stand together in place of the radius, which no flight changes: so a row
  // of it is in one array. The low bits are those of the contact, and below them of STUCK.
  private static final int PAST_INTS = FlightRow.RADIUS;
  private static final int PAST_NUMBERS = FlightRow.RADIUS + 1;

  // The columns of ints.
  public static final int LAST = 0;

  /** The next impact; without one, NOTHING - {@link MovingCircle#sensedCode}. */
  public static final int NEXT = 1;

  /** See {@link ContactWord}. */
  private static final int CONTACT = 2;

  private static final int LOOKAHEAD = 3;
  public static final int STUCK = 4;
  public static final int CODES = 5;

  // The columns of gravity: the acceleration, and the support. An awake member of those in contact
  // flies straight: in place of its acceleration is the rate of change of its momentum.
  private static final int GX = 0;
  private static final int GY = 1;
  private static final int SUPPORT = 2;
  private static final int FALL = 3;

  // The columns of the momentum by mass of an awake member.
  private static final int PX = 0;
  private static final int PY = 1;
  private static final int MOMENTUM = 2;

  // The columns of the last circle that a sensor reported: the time of contact, and which it was.
  private static final int HEAD = 0;
  private static final int TAIL = 1;
  private static final int PARTNER = 2;
  private static final int SENSED = 3;

  // Others may copy these two references into locals. They change when the table gets more room.
  public double[] state;
  public int[] codes;

  private int capacity;
  private final int first;
  private final int stride;
  private final int firstCode;
  private final int codeStride;

  /** Whether any of the following columns exists. */
  boolean hasRare;

  /** Three doubles a row, see {@link #GX}; null until a circle falls, slides or rests. */
  private double[] falls;

  /** Two doubles a row, see {@link #PX}; null until there is an awake member. */
  private double[] momenta;

  /** Three doubles a row, see {@link #HEAD}; null until a sensor reports another circle. */
  private double[] sensed;

  /** The ignore list of each jammed circle; null until there is one. */
  public IgnoreList[] jams;

  /** The {@link ContactRow} of each member; null until one is kept here. */
  public double[][] contactRows;

  /** Creates a table with room for so many rows. */
  public FlightTable(int room) {
    this(room, 0, NUMBERS, 0, CODES);
  }

  /** Creates a table of all its columns, see {@link #numbers}. */
  public FlightTable(double[][] numbers, int[] codes, IgnoreList[] jams, double[][] contactRows) {
    this(0);
    capacity = numbers[0].length / NUMBERS;
    state = numbers[0];
    falls = numbers[1];
    sensed = numbers[2];
    momenta = numbers[3];
    this.codes = codes;
    this.jams = jams;
    this.contactRows = contactRows;
    hasRare = true;
  }

  /** Creates a table of the past, which has no ints, no radius, and no rows of contact. */
  static FlightTable past() {
    return new FlightTable(0, 0, PAST_NUMBERS, 0, 0);
  }

  /** Creates a table with further columns, and with numbers before its first row. */
  FlightTable(int room, int first, int stride, int firstCode, int codeStride) {
    this.first = first;
    this.stride = stride;
    this.firstCode = firstCode;
    this.codeStride = codeStride;
    capacity = room;
    state = new double[at(room)];
    codes = new int[codesAt(room)];
  }

  /** The number of rows for which there is room. */
  public final int capacity() {
    return capacity;
  }

  /** The index of the first double of row i. */
  public final int at(int i) {
    return first + i * stride;
  }

  /** The index of the first int of row i. */
  public final int codesAt(int i) {
    return firstCode + i * codeStride;
  }

  /** Makes room for accelerations, all 0. */
  public final void allowGravity() {
    if (falls == null) {
      falls = new double[FALL * capacity];
      hasRare = true;
    }
  }

  /** Whether circles may have accelerations. */
  public final boolean allowsGravity() {
    return falls != null;
  }

  /** Makes room for so many rows. */
  final void resize(int room) {
    move(0, room);
  }

  /** Moves all rows towards the beginning, by so many rows, into room for so many. */
  final void move(int by, int room) {
    capacity = room;
    state = moved(state, by * stride, at(room));
    int of = by * codeStride;
    codes = codeStride == 0 ? codes : Arrays.copyOfRange(codes, of, of + codesAt(room));
    falls = moved(falls, FALL * by, FALL * room);
    sensed = moved(sensed, SENSED * by, SENSED * room);
    momenta = moved(momenta, MOMENTUM * by, MOMENTUM * room);
    jams = jams == null ? null : Arrays.copyOfRange(jams, by, by + room);
    contactRows = contactRows == null ? null : Arrays.copyOfRange(contactRows, by, by + room);
  }

  private static double[] moved(double[] column, int by, int size) {
    if (column == null || column.length != size) {
      return column == null ? null : Arrays.copyOfRange(column, by, by + size);
    }
    System.arraycopy(column, by, column, 0, size - by);
    return column;
  }

  // Rows.

  /** Writes a circle to row i. */
  public final void put(int i, MovingCircle m) {
    int k = at(i);
    int c = codesAt(i);
    if (codeStride > 0) {
      putFlight(m, state, k, codes, c);
    } else {
      FlightRow.put(m, state, k);
      long low = (long) m.stuck << ContactWord.BITS | ContactWord.of(m);
      state[k + PAST_INTS] = Double.longBitsToDouble((long) m.last << Integer.SIZE | low);
    }
    putRare(i, m);
  }

  /** Reads row i into a circle. Its id and its filter stay, as they are not in the row. */
  public final void get(int i, MovingCircle m) {
    int k = at(i);
    int c = codesAt(i);
    FlightRow.get(m, state, k);
    if (codeStride > 0) {
      getNext(m, state, k, codes, c);
      getPast(m, codes, c);
    } else {
      m.newFlight();
      long ints = Double.doubleToRawLongBits(state[k + PAST_INTS]);
      m.last = (int) (ints >> Integer.SIZE);
      m.stuck = (int) ints >> ContactWord.BITS;
      ContactWord.recall((int) ints, m);
    }
    getRare(i, m);
  }

  /** Writes the columns that every table of the present has. */
  static void putFlight(MovingCircle m, double[] state, int k, int[] codes, int c) {
    FlightRow.put(m, state, k);
    state[k + CLEARED] = m.cleared;
    state[k + RESTITUTION] = m.restitution;
    // The first and the last column first: then compilers check the range of the others with them.
    codes[c + LAST] = m.last;
    codes[c + STUCK] = m.stuck;
    codes[c + NEXT] = m.next == MovingCircle.NOTHING ? m.next - m.sensedCode : m.next;
    codes[c + CONTACT] = ContactWord.of(m);
    codes[c + LOOKAHEAD] = m.lookahead;
  }

  private static void getNext(MovingCircle m, double[] state, int k, int[] codes, int c) {
    m.cleared = state[k + CLEARED];
    m.restitution = state[k + RESTITUTION];
    m.lookahead = codes[c + LOOKAHEAD];
    int next = codes[c + NEXT];
    m.next = Math.max(next, MovingCircle.NOTHING);
    m.sensedCode = next < 0 ? MovingCircle.NOTHING - next : 0;
  }

  static void getPast(MovingCircle m, int[] codes, int c) {
    m.last = codes[c + LAST];
    m.stuck = codes[c + STUCK];
    ContactWord.recall(codes[c + CONTACT], m);
  }

  /** Whether a circle may have anything in the columns that exist only if needed. */
  boolean mayBeRare(MovingCircle m) {
    return hasRare || m.isRare();
  }

  /** Writes the columns that exist only if needed. */
  final void putRare(int i, MovingCircle m) {
    if (mayBeRare(m)) {
      putRareColumns(i, m);
    }
  }

  private void putRareColumns(int i, MovingCircle m) {
    if (falls != null || m.isFalling() || m.landing != MovingCircle.NOTHING) {
      allowGravity();
      putFall(i, m);
    }
    if (sensed != null || m.sensedPartner != MovingCircle.NOT_SENSED) {
      putSensed(i, m.sensedHead, m.sensedTail, m.sensedPartner);
    }
    if (jams != null || m.jam != null) {
      jams = jams == null ? new IgnoreList[capacity()] : jams;
      jams[i] = m.jam;
      hasRare = true;
    }
  }

  private void putFall(int i, MovingCircle m) {
    boolean awake = m.mode == MovingCircle.AWAKE;
    int k = FALL * i;
    falls[k + GX] = awake ? m.ax : m.gx;
    falls[k + GY] = awake ? m.ay : m.gy;
    falls[k + SUPPORT] = m.supportWord();
    if (awake) {
      momenta = momenta == null ? new double[MOMENTUM * capacity] : momenta;
      momenta[MOMENTUM * i + PX] = m.px;
      momenta[MOMENTUM * i + PY] = m.py;
    }
    if (codeStride > 0 && (contactRows != null || m.contactRow != null)) {
      contactRows = contactRows == null ? new double[capacity][] : contactRows;
      contactRows[i] = m.contactRow;
    }
  }

  /** Reads the columns that exist only if needed. */
  final void getRare(int i, MovingCircle m) {
    if (mayBeRare(m)) {
      getRareColumns(i, m);
    }
  }

  private void getRareColumns(int i, MovingCircle m) {
    m.clearRare();
    if (falls != null) {
      getFall(i, m);
    }
    if (sensed != null) {
      int k = SENSED * i;
      m.sensedHead = sensed[k + HEAD];
      m.sensedTail = sensed[k + TAIL];
      m.sensedPartner = sensedPartner(i);
    }
    m.jam = jam(i);
  }

  private void getFall(int i, MovingCircle m) {
    m.setSupport(supportWord(i));
    m.gx = gx(i);
    m.gy = gy(i);
    m.contactRow = contactRow(i);
    if (isAwake(i) && momenta != null) {
      m.ax = falls[FALL * i + GX];
      m.ay = falls[FALL * i + GY];
      m.px = momenta[MOMENTUM * i + PX];
      m.py = momenta[MOMENTUM * i + PY];
    }
  }

  // Circles sensed.

  /** Stores the last contact of circle i with another one that a sensor reported. */
  public final void putSensed(int i, double head, double tail, int partner) {
    if (sensed == null) {
      sensed = new double[SENSED * capacity];
      hasRare = true;
    }
    int k = SENSED * i;
    sensed[k + HEAD] = head;
    sensed[k + TAIL] = tail;
    sensed[k + PARTNER] = partner - MovingCircle.NOT_SENSED;
  }

  private int sensedPartner(int i) {
    return sensed == null
        ? MovingCircle.NOT_SENSED
        : MovingCircle.NOT_SENSED + (int) sensed[SENSED * i + PARTNER];
  }

  /**
   * Whether a sensor has reported this contact of circle i. It has reported one contact and all
   * earlier ones, in order of time (head, tail), then of partner.
   */
  public final boolean isSensed(int i, double head, double tail, int partner) {
    int known = sensedPartner(i);
    if (known == MovingCircle.NOT_SENSED || head != sensed[SENSED * i + HEAD]) {
      return known != MovingCircle.NOT_SENSED && head < sensed[SENSED * i + HEAD];
    }
    double knownTail = sensed[SENSED * i + TAIL];
    return tail != knownTail ? tail < knownTail : partner <= known;
  }

  // One circle.

  /** The ignore list of a circle; null if it is not jammed. */
  public final IgnoreList jam(int i) {
    return jams == null ? null : jams[i];
  }

  /** The {@link ContactRow} of a circle; null if none is kept here. */
  private double[] contactRow(int i) {
    return contactRows == null ? null : contactRows[i];
  }

  /** The acceleration of the flight of a circle. */
  public final double gx(int i) {
    return falls == null || isAwake(i) ? 0 : falls[FALL * i + GX];
  }

  public final double gy(int i) {
    return falls == null || isAwake(i) ? 0 : falls[FALL * i + GY];
  }

  /** The {@link MovingCircle#supportWord} of a circle. */
  final int supportWord(int i) {
    return falls == null ? 0 : (int) falls[FALL * i + SUPPORT];
  }

  /** Whether something carries a circle: it slides, rests, or is in contact. */
  public final boolean isSupported(int i) {
    return supportWord(i) > 0;
  }

  /** Whether a circle is a member of those in contact. */
  public final boolean isMember(int i) {
    return supportWord(i) >= MovingCircle.WORD_OF_AWAKE;
  }

  /** Whether a circle is an awake member of those in contact. */
  public final boolean isAwake(int i) {
    return supportWord(i) == MovingCircle.WORD_OF_AWAKE;
  }

  /** Whether a circle rests as a member of those in contact. */
  public final boolean isFrozen(int i) {
    return supportWord(i) == MovingCircle.WORD_OF_FROZEN;
  }

  /** The line or wall on which a circle slides or rests; NOTHING if on none, or in contact. */
  public final int support(int i) {
    return MovingCircle.supportOf(supportWord(i));
  }

  public final double radius(int i) {
    return state[at(i) + FlightRow.RADIUS];
  }

  /** The head of the time at which a flight starts. */
  final double start(int i) {
    return state[at(i) + FlightRow.T];
  }

  /** How long a circle has been on its flight. */
  public final double since(int i, double now) {
    int k = at(i);
    return MovingCircle.since(state[k + FlightRow.T], state[k + FlightRow.TL], now);
  }

  /** The x coordinate of a circle, if no wall keeps it inside. */
  final double freeX(int i, double now) {
    int k = at(i);
    return MovingCircle.place(
        state[k + FlightRow.X], state[k + FlightRow.VX], gx(i), since(i, now));
  }

  final double freeY(int i, double now) {
    int k = at(i);
    return MovingCircle.place(
        state[k + FlightRow.Y], state[k + FlightRow.VY], gy(i), since(i, now));
  }

  /** A {@link #freeX} of a circle of a radius inside of walls, see {@link ObstacleTable#walls}. */
  final double confinedX(int i, double x, double radius, double[] walls) {
    return Confinement.x(walls, state[at(i) + FlightRow.X], x, radius);
  }

  final double confinedY(int i, double y, double radius, double[] walls) {
    return Confinement.y(walls, state[at(i) + FlightRow.Y], y, radius);
  }

  /** The velocity that a world shows of a circle: that of an awake member is its momentum. */
  public final double vx(int i, double now) {
    return isAwake(i)
        ? MovingCircle.velocity(momenta[MOMENTUM * i + PX], falls[FALL * i + GX], since(i, now))
        : flightX(i, now);
  }

  public final double vy(int i, double now) {
    return isAwake(i)
        ? MovingCircle.velocity(momenta[MOMENTUM * i + PY], falls[FALL * i + GY], since(i, now))
        : flightY(i, now);
  }

  /** The velocity at which the place of a circle changes. */
  public final double flightX(int i, double now) {
    return MovingCircle.velocity(state[at(i) + FlightRow.VX], gx(i), since(i, now));
  }

  public final double flightY(int i, double now) {
    return MovingCircle.velocity(state[at(i) + FlightRow.VY], gy(i), since(i, now));
  }

  // All columns.

  @Override
  public final boolean equals(Object other) {
    return other instanceof FlightTable that
        && Arrays.deepEquals(numbers(), that.numbers())
        && Arrays.equals(codes, that.codes)
        && Arrays.equals(jams, that.jams)
        && Arrays.deepEquals(contactRows, that.contactRows);
  }

  @Override
  public final int hashCode() {
    return Arrays.hashCode(state);
  }

  /** The columns of doubles, by group; null for a group that no circle needs. */
  public final double[][] numbers() {
    return new double[][] {state, falls, sensed, momenta};
  }

  /** The doubles of a row in a group, in a table without further columns. */
  public static int width(int group) {
    return new int[] {NUMBERS, FALL, SENSED, MOMENTUM}[group];
  }
}
