// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.OutlinePoints;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.state.SceneDataBuilder;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import dev.carom.internal.util.Refusal;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.util.EnumMap;
import java.util.Map;

/** Reads the rows of a scene file into a builder. */
final class SceneReader {

  private static final int RADIUS = SceneRowKind.CIRCLE.names().indexOf("radius");
  private static final int MASS = SceneRowKind.CIRCLE.names().indexOf("mass");

  private static final String SOLID = "solid";

  private final SceneDataBuilder builder = new SceneDataBuilder();

  /**
   * Line and column of each circle's radius. A radius that is too small for a coordinate further
   * down is detected only after the last row.
   */
  private final IntList radiusPlaces = new IntList();

  /** The velocity that the options of a row give. */
  private double vx;

  private double vy;

  /** The line of the row of each kind of which there may be only one. */
  private final Map<SceneRowKind, Integer> singles = new EnumMap<>(SceneRowKind.class);

  SceneData read(Reader in) throws IOException {
    BufferedReader lines = new BufferedReader(in);
    String text = lines.readLine();
    if (text != null && text.startsWith("\ufeff")) {
      text = text.substring(1);
    }
    for (int line = 1; text != null; line++) {
      SceneRow row = SceneRow.of(line, text);
      if (row != null) {
        read(row);
      }
      text = lines.readLine();
    }
    return build();
  }

  private void read(SceneRow row) throws RowException {
    try {
      switch (row.kind()) {
        case WALL -> wall(row);
        case LINE -> builder.obstacle(KindNumber.LINE, row.numbers());
        case OUTLINE -> builder.outline(outline(row));
        case PEG -> builder.obstacle(KindNumber.PEG, row.numbers());
        case CIRCLE -> circle(row);
        case COLLIDE -> collide(row);
        case GRAVITY -> gravity(row);
      }
      options(row);
    } catch (IllegalArgumentException e) {
      throw row.error(e);
    }
  }

  private void wall(SceneRow row) throws RowException {
    only(row);
    builder.bounds(side(row, 1), side(row, 2), side(row, 3), side(row, 4));
  }

  private static double side(SceneRow row, int field) throws RowException {
    return switch (row.field(field)) {
      case "-inf", "-Infinity" -> Double.NEGATIVE_INFINITY;
      case "inf", "Infinity" -> Double.POSITIVE_INFINITY;
      default -> row.number(field);
    };
  }

  private static OutlinePoints outline(SceneRow row) throws RowException {
    double[] xy = row.numbers();
    if (xy.length % 2 != 0) {
      throw row.error(row.plain(), "y is missing: expected " + row.kind().shape());
    }
    boolean isSolid = false;
    for (int i = row.plain(); i < row.size(); i++) {
      if (row.key(i).equals(SOLID)) {
        isSolid = flag(row, i, SOLID, row.value(i));
      }
    }
    return new OutlinePoints(xy, isSolid);
  }

  private void circle(SceneRow row) throws RowException {
    builder.circle(row.number(1), row.number(2), row.number(3), row.number(4), row.number(5));
    if (row.plain() > MASS) {
      builder.mass(mass(row));
    }
    radiusPlaces.add(row.line());
    radiusPlaces.add(row.column(RADIUS));
  }

  private static double mass(SceneRow row) throws RowException {
    String mass = row.field(MASS);
    if (mass.equals("inf") || mass.equals("Infinity")) {
      return Double.POSITIVE_INFINITY;
    }
    double number = SceneText.finite(mass);
    if (Double.isNaN(number)) {
      String reason = "mass is " + SceneText.quoted(mass) + ": expected ";
      throw row.error(MASS, reason + "a number from 2^-500 to 2^500, or inf");
    }
    return number;
  }

  private void collide(SceneRow row) throws RowException {
    only(row);
    builder.collide = flag(row, 1, "collide", row.field(1));
  }

  private void gravity(SceneRow row) throws RowException {
    only(row);
    builder.gravity(row.number(1), row.number(2));
  }

  /** Refuses a second row of a kind. */
  private void only(SceneRow row) throws RowException {
    Integer first = singles.putIfAbsent(row.kind(), row.line());
    if (first != null) {
      throw row.error(
          0, "a second " + row.field(0) + " row, after line " + first + ": expected one only");
    }
  }

  private void options(SceneRow row) throws RowException {
    vx = 0;
    vy = 0;
    for (int i = row.plain(); i < row.size(); i++) {
      if (!row.kind().isThing()) {
        throw row.error(i, SceneText.quoted(row.field(i)) + " is out of place: expected no more");
      }
      for (int k = row.plain(); k < i; k++) {
        if (row.key(k).equals(row.key(i))) {
          throw row.error(i, row.key(i) + " is given twice: expected once");
        }
      }
      option(row, i);
    }
    if (vx != 0 || vy != 0) {
      builder.velocity(vx, vy);
    }
  }

  private void option(SceneRow row, int i) throws RowException {
    String key = row.key(i);
    if (key.equals("restitution")) {
      builder.restitution(row.option(i));
    } else if (key.equals("response")) {
      builder.response(response(row, i));
    } else if (key.equals("category")) {
      builder.category(bits(row, i));
    } else if (key.equals("mask")) {
      builder.mask(bits(row, i));
    } else if (key.equals("vx") && moves(row)) {
      vx = row.option(i);
    } else if (key.equals("vy") && moves(row)) {
      vy = row.option(i);
    } else if (key.equals("oneway") && isOfLines(row)) {
      if (flag(row, i, "oneway", row.value(i))) {
        builder.oneWay();
      }
    } else if (!key.equals(SOLID) || row.kind() != SceneRowKind.OUTLINE) {
      throw row.error(i, "key " + SceneText.quoted(key) + " is unknown: expected " + keys(row));
    }
  }

  /** The 32 bits of a category or a mask, as the int that they are. */
  private static int bits(SceneRow row, int i) throws RowException {
    try {
      return Integer.parseInt(row.value(i));
    } catch (NumberFormatException e) {
      String reason = row.key(i) + " is " + SceneText.quoted(row.value(i)) + ": expected ";
      throw row.error(i, reason + "a whole number from -2147483648 to 2147483647");
    }
  }

  /** The keys that a row may have, as messages name them. */
  private static String keys(SceneRow row) {
    String all = "restitution=NUMBER, response=WORD, category=INTEGER";
    return switch (row.kind()) {
      case LINE -> all + ", mask=INTEGER, vx=NUMBER, vy=NUMBER or oneway=0|1";
      case OUTLINE -> all + ", mask=INTEGER, vx=NUMBER, vy=NUMBER, oneway=0|1 or solid=0|1";
      case PEG -> all + ", mask=INTEGER, vx=NUMBER or vy=NUMBER";
      default -> all + " or mask=INTEGER";
    };
  }

  /** Whether the things of a kind of rows may have a velocity as an option. */
  private static boolean moves(SceneRow row) {
    return isOfLines(row) || row.kind() == SceneRowKind.PEG;
  }

  private static boolean isOfLines(SceneRow row) {
    return row.kind() == SceneRowKind.LINE || row.kind() == SceneRowKind.OUTLINE;
  }

  private static int response(SceneRow row, int i) throws RowException {
    int response = SceneRowKind.RESPONSES.indexOf(row.value(i));
    if (response < 0) {
      throw row.error(
          i, "response is " + SceneText.quoted(row.value(i)) + ": expected bounce, halt or sensor");
    }
    return response;
  }

  /** Parses the text of field i, which must be 0 or 1. */
  private static boolean flag(SceneRow row, int i, String name, String text) throws RowException {
    if (!text.equals("0") && !text.equals("1")) {
      throw row.error(i, name + " is " + SceneText.quoted(text) + ": expected 0 or 1");
    }
    return text.equals("1");
  }

  private SceneData build() throws RowException {
    try {
      return builder.build();
    } catch (IllegalArgumentException e) {
      int place = 2 * builder.firstTooSmall();
      throw new RowException(
          radiusPlaces.get(place), radiusPlaces.get(place + 1), Refusal.reason(e));
    }
  }
}
