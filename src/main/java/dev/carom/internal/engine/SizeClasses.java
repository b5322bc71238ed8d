// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.state.BoundingBox;
import dev.carom.internal.state.CircleTable;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.TreeMap;

/**
 * Circles by size: a class for each power of two among the radii, but neighbouring ones share a
 * class as long as their circles do not crowd its cells. Ten octaves of circles far apart, each
 * with cells of its own, would else make a small circle cross ten grids from one collision to the
 * next; measured, so is a quadtree, which visits more nodes than a grid has cells.
 */
public final class SizeClasses {

  /** Wider than a diameter, so that a crossing may be noticed late by rounding. */
  private static final double SLACK = 1 + 0x1p-20;

  /** And by so much of the largest coordinate: 16 ulps, more than a place and an edge err by. */
  private static final double ROUNDING = 0x1p-48;

  /**
   * So many diameters apart circles are sparse, and cells as wide as their mean distance: measured.
   * Small circles among large ones would else cross thousands of cells of their own size from one
   * collision to the next.
   */
  private static final double SPARSE = 3;

  /** So many circles a cell are no crowd yet: measured. */
  private static final double CROWD = 2;

  /** An octave of radii: how many, the largest, and how many it and all smaller ones have. */
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
  private final double slack;
  private final double diameters;

  /** Of each class, the smallest first: the largest radius, and the width of a cell. */
  public final double[] radii;

  public final double[] widths;

  /** The exponents of all radii, ascending, and the class of each. */
  private final int[] exponents;

  private final int[] classes;

  /**
   * @param ids of the circles
   * @param diameters how many of the largest diameters a cell is wide, at least 1
   */
  public SizeClasses(CircleTable circles, int[] ids, BoundingBox extent, double diameters) {
    area = extent.area();
    slack = ROUNDING * extent.farthest();
    this.diameters = diameters;
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

  /** The largest octave of each class; tells each octave its class. */
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
    double diameter = 2 * octave.largest * SLACK * diameters;
    double distance = Math.sqrt(area / octave.listed);
    return (distance > SPARSE * diameter ? distance : diameter) + slack;
  }

  /** By so much a place and an edge may err. */
  public double slack() {
    return slack;
  }

  /** The class of a radius, or -1 if it is none of those from which the classes were made. */
  public int of(double radius) {
    int octave = Arrays.binarySearch(exponents, Math.getExponent(radius));
    return octave < 0 || radius > radii[classes[octave]] ? -1 : classes[octave];
  }
}
