// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.util.IntList;
import java.util.Arrays;

/**
 * Which rows of a kind belong to one obstacle with one id: the sides of an outline, which follow
 * each other. As long as no rows were joined, the id of an obstacle is the number of its row.
 */
final class JoinedRows {

  /** The id of each row; null while no rows are joined. */
  private int[] ids;

  /** The first row of each id, and last the number of all rows; null likewise. */
  private int[] firsts;

  private int rows;
  private int idLimit;

  JoinedRows copy() {
    JoinedRows copy = new JoinedRows();
    copy.ids = ids == null ? null : ids.clone();
    copy.firsts = ids == null ? null : firsts.clone();
    copy.rows = rows;
    copy.idLimit = idLimit;
    return copy;
  }

  /** Adds a row with an id of its own. */
  void add() {
    if (ids != null) {
      if (rows == ids.length) {
        ids = Arrays.copyOf(ids, 2 * rows + 2);
        firsts = Arrays.copyOf(firsts, 2 * rows + 3);
      }
      ids[rows] = idLimit;
      firsts[idLimit] = rows;
      firsts[idLimit + 1] = rows + 1;
    }
    rows++;
    idLimit++;
  }

  /** Lets the last row belong to the obstacle of the row before it. */
  void join() {
    if (ids == null) {
      ids = new int[rows];
      firsts = new int[rows + 1];
      Arrays.setAll(ids, row -> row);
      Arrays.setAll(firsts, row -> row);
    }
    idLimit--;
    ids[rows - 1] = idLimit - 1;
    firsts[idLimit] = rows;
  }

  /** Whether rows were ever joined. */
  boolean areAny() {
    return ids != null;
  }

  /** One more than the largest id. */
  int idLimit() {
    return idLimit;
  }

  int id(int row) {
    return ids == null ? row : ids[row];
  }

  /** The first row of an id; of the limit, the number of rows. */
  int first(int id) {
    return ids == null ? id : firsts[id];
  }

  /** Whether a row belongs to the obstacle of the row before it. */
  boolean isJoined(int row) {
    return ids != null && row > 0 && ids[row] == ids[row - 1];
  }

  /** The rows that belong to the obstacle of the row before them. */
  int[] joined() {
    IntList joined = new IntList();
    for (int row = 0; ids != null && row < rows; row++) {
      if (isJoined(row)) {
        joined.add(row);
      }
    }
    return joined.toArray();
  }
}
