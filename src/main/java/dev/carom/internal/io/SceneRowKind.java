// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.ContactFlags;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** The kinds of rows in a scene file, each with the names of its fields. */
public enum SceneRowKind {
  WALL("wall,xmin,ymin,xmax,ymax"),
  LINE("line,ax,ay,bx,by"),
  OUTLINE("outline,x,y,x,y,..."),
  PEG("peg,x,y,radius"),
  CIRCLE("circle,x,y,radius,vx,vy[,mass]"),
  COLLIDE("collide,0|1"),
  GRAVITY("gravity,gx,gy");

  /** The words for the responses, indexed by the constants of {@link ContactFlags}. */
  public static final List<String> RESPONSES = List.of("bounce", "halt", "sensor");

  private static final SceneRowKind[] KINDS = values();

  private final String shape;
  private final String word;
  private final int required;
  private final int allowed;

  SceneRowKind(String shape) {
    this.shape = shape;
    word = names().get(0);
    int fields = names().size();
    boolean isOpen = shape.endsWith("...");
    allowed = isOpen ? Integer.MAX_VALUE : fields;
    required = fields - (isOpen || shape.endsWith("]") ? 1 : 0);
  }

  /** The kind whose rows begin with the given word; null if there is none. */
  static SceneRowKind of(String word) {
    for (SceneRowKind kind : KINDS) {
      if (kind.word.equals(word)) {
        return kind;
      }
    }
    return null;
  }

  /** Whether such a row is of a thing, which may have key=value fields. */
  boolean isThing() {
    return this != COLLIDE && this != GRAVITY;
  }

  /** The words that can begin a row, as messages list them. */
  static String words() {
    String[] words = Arrays.stream(KINDS).map(kind -> kind.word).toArray(String[]::new);
    int last = words.length - 1;
    return String.join(", ", Arrays.copyOf(words, last)) + " or " + words[last];
  }

  /** The form of such a row; a part in brackets is optional. */
  String shape() {
    return shape;
  }

  /** The name of a field, of which there may be more than names. */
  String name(int field) {
    return this == OUTLINE && field > 0 ? field % 2 == 1 ? "x" : "y" : names().get(field);
  }

  /** The names of the fields; field 0 is the word for the kind. */
  List<String> names() {
    return Pattern.compile("\\[?,|]").splitAsStream(shape).toList();
  }

  /** The least number of fields of a row. */
  int required() {
    return required;
  }

  /** The largest number of fields of a row, key=value fields not counted. */
  int allowed() {
    return allowed;
  }
}
