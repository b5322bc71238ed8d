// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleTable;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.TreeMap;

/**
 * Classes of circles by size, each with its own cells. There is one class per power of two among
 * the radii, but neighbouring ones share a class as long as their circles do not crowd its cells.
 * Otherwise a small circle among ten octaves of sparse circles would cross ten grids from one
 * collision to the next. A quadtree was measured: it is slower, as it visits more nodes than a grid
 * has cells.
 */
public final class SizeClasses {

  /** Makes a cell wider than a diameter, as rounding may delay the notice of a crossing. */
  private static final double SLACK = 1 + 0x1p-20;

  /** The same under gravity, where circles that lie on each other are found by their cells. */
  private static final double HEAP_SLACK = 1 + 0x1p-6;

  /**
   * Widens a cell by this part of the largest coordinate: 16 ulps, more than a position and an edge
   * err by.
   */
  private static final double ROUNDING = 0x1p-48;

  /**
   * Circles further apart than this many diameters are sparse: their cells are as wide as their
   * mean distance. Measured. Small circles among large ones would otherwise cross thousands of
   * cells of their own size from one collision to the next.
   */
  private static final double SPARSE = 3;

  /** The width of the cells of a circle that is alone, which begins in the middle of one. */
  static final double ENDLESS = 0x1p500;

  /** The number of circles per cell that is no crowd yet: measured. */
  private static final double CROWD = 2;

  /**
   * An octave of radii: the number of its circles, their largest radius, and the number of circles
   * in it and all smaller octaves.
   */
  private static final class Octave {
    private int members;
    private double largest;
    private int listed;

    void add(double radius) {
      members++;
      largest = Math.max(largest, radius);
    }
  }

  private final TreeMap<Integer, Octave> octaves = new TreeMap<>();
  private final double area;

  /** The longer side of the extent. */
  private final double side;

  private final double slack;
  private final double diameters;
  private final boolean falls;

  /** Whether there is one circle only. */
  private final boolean alone;

  /** The largest radius of each class and the width of its cells, the smallest class first. */
  public final double[] radii;

  public final double[] widths;

  /** The exponents of all radii, ascending, and the class of each. */
  private final int[] exponents;

  private final int[] classes;

  /**
   * @param ids the slots of the circles
   * @param diameters the width of a cell in largest diameters, at least 1
   */
  public SizeClasses(CircleTable circles, int[] ids, BoundingBox extent, double diameters) {
    area = extent.area();
    side = extent.side();
    slack = ROUNDING * extent.farthest();
    this.diameters = diameters;
    falls = circles.allowsGravity();
    alone = ids.length == 1;
    for (int i : ids) {
      double radius = circles.radius(i);
      octaves.computeIfAbsent(Math.getExponent(radius), e -> new Octave()).add(radius);
    }
    exponents = octaves.keySet().stream().mapToInt(Integer::intValue).toArray();
    classes = new int[exponents.length];
    Deque<Octave> heads = heads();
    radii = heads.stream().mapToDouble(octave -> octave.largest).toArray();
    widths = heads.stream().mapToDouble(this::width).toArray();
  }

  /** The largest octave of each class. Assigns each octave its class. */
  private Deque<Octave> heads() {
    int listed = 0;
    for (Octave octave : octaves.values()) {
      listed += octave.members;
      octave.listed = listed;
    }
    Deque<Octave> heads = new ArrayDeque<>();
    double room = 0;
    int place = exponents.length;
    for (Octave octave : octaves.descendingMap().values()) {
      room -= octave.members;
      if (room < 0) {
        heads.addFirst(octave);
        double width = width(octave);
        room = CROWD * area / (width * width) - octave.members;
      }
      classes[--place] = heads.size();
    }
    for (int i = 0; i < classes.length; i++) {
      classes[i] = heads.size() - classes[i];
    }
    return heads;
  }

  private double width(Octave octave) {
    if (alone) {
      return ENDLESS;
    }
    double diameter = 2 * octave.largest * (falls ? HEAP_SLACK : SLACK) * diameters;
    double distance = Math.max(Math.sqrt(area / octave.listed), side / octave.listed);
    double width = distance > SPARSE * diameter ? distance : diameter;
    return width > 0 ? width + slack : 1; // a diameter of 0 is that of points
  }

  /** The error bound of a position and an edge. */
  public double slack() {
    return slack;
  }

  /** The class of a radius; -1 if the classes were made without it. */
  public int of(double radius) {
    int octave = Arrays.binarySearch(exponents, Math.getExponent(radius));
    return octave < 0 || radius > radii[classes[octave]] ? -1 : classes[octave];
  }
}
