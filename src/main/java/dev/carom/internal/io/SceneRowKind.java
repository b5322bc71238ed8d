// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import dev.carom.internal.state.ContactFlags;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/** The rows that a scene file can have, each with the names of its fields. */
public enum SceneRowKind {
  WALL("wall,xmin,ymin,xmax,ymax"),
  LINE("line,ax,ay,bx,by"),
  PEG("peg,x,y,radius"),
  CIRCLE("circle,x,y,radius,vx,vy[,mass]"),
  COLLIDE("collide,0|1");

  /** The words for the responses, by their numbers in {@link ContactFlags}. */
  public static final List<String> RESPONSES = List.of("bounce", "halt", "sensor");

  private static final SceneRowKind[] KINDS = values();

  private final String shape;
  private final String word;
  private final int required;
  private final int allowed;

  SceneRowKind(String shape) {
    this.shape = shape;
    word = names().get(0);
    allowed = names().size();
    required = allowed - (shape.endsWith("]") ? 1 : 0);
  }

  /** The kind whose rows begin with a given word; null if there is none. */
  static SceneRowKind of(String word) {
    for (SceneRowKind kind : KINDS) {
      if (kind.word.equals(word)) {
        return kind;
      }
    }
    return null;
  }

  /** What messages say is expected at the start of a row. */
  static String words() {
    String[] words = Arrays.stream(KINDS).map(kind -> kind.word).toArray(String[]::new);
    int last = words.length - 1;
    return String.join(", ", Arrays.copyOf(words, last)) + " or " + words[last];
  }

  /** How such a row looks; what stands in brackets may be left out. */
  String shape() {
    return shape;
  }

  /** The names of the fields; field 0 is the word for the kind. */
  List<String> names() {
    return Pattern.compile("\\[?,|]").splitAsStream(shape).toList();
  }

  /** How many fields a row has at least. */
  int required() {
    return required;
  }

  /** How many fields a row has at most, those of key=value not counted. */
  int allowed() {
    return allowed;
  }
}
