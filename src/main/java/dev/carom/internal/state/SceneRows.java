// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.state;

import dev.carom.internal.sweep.ObstacleShape;
import dev.carom.internal.util.DoubleList;
import java.util.Arrays;

/**
 * The circles or obstacles of one kind while a scene is built: for each a row of doubles, which
 * begins with coordinates and ends with the restitution, its {@link ContactFlags} and its {@link
 * Filter}.
 */
final class SceneRows {

  private final String kind;
  private final int width;
  private final int coordinates;
  private final DoubleList values = new DoubleList();
  private byte[] traits = new byte[16];

  /** Null as long as all have the default. */
  private long[] filters;

  SceneRows(ObstacleShape shape) {
    this(shape.name, shape.row, shape.coordinates);
  }

  SceneRows(String kind, int width, int coordinates) {
    this.kind = kind;
    this.width = width;
    this.coordinates = coordinates;
  }

  int count() {
    return values.size() / width;
  }

  /** The name of number i in messages, as "line 3"; bounds have no number. */
  String name(int i) {
    return kind.equals("bounds") ? kind : kind + " " + i;
  }

  double get(int i, int column) {
    return values.get(i * width + column);
  }

  void add(double... row) {
    values.add(row);
    if (count() > traits.length) {
      traits = Arrays.copyOf(traits, 2 * count());
    }
    traits[count() - 1] = 0;
    if (filters != null && count() > filters.length) {
      filters = Filter.copyOf(filters, 2 * count());
    }
  }

  void setLastRestitution(double e) {
    values.setLast(e);
  }

  int lastTraits() {
    return traits[count() - 1];
  }

  void setLastTraits(int t) {
    traits[count() - 1] = (byte) t;
  }

  long lastFilter() {
    return Filter.of(filters, count() - 1);
  }

  void setLastFilter(long filter) {
    if (filters == null && filter != Filter.DEFAULT) {
      filters = Filter.defaults(traits.length);
    }
    if (filters != null) {
      filters[count() - 1] = filter;
    }
  }

  /** The filters of all; null if each is the default. */
  long[] filters() {
    return Filter.unlessDefault(filters, count());
  }

  /** The flags of all; null if none has any. */
  byte[] traits() {
    for (int i = 0; i < count(); i++) {
      if (traits[i] != 0) {
        return Arrays.copyOf(traits, count());
      }
    }
    return null;
  }

  double largestCoordinate() {
    double largest = 0;
    for (int i = 0; i < count(); i++) {
      for (int column = 0; column < coordinates; column++) {
        largest = Math.max(largest, Math.abs(get(i, column)));
      }
    }
    return largest;
  }

  double[] toArray() {
    return values.toArray();
  }
}
