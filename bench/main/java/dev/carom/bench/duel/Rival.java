// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.duel;

import dev.carom.bench.methods.Contender;
import dev.carom.bench.methods.Methods;
import dev.carom.bench.peers.Contenders;
import java.util.Locale;

/** The methods that can play beside this library, by name. */
public enum Rival {
  BOX2D("Box2D, as it comes", "gdx-box2d-defaults"),
  DYN4J("dyn4j, as it comes", "dyn4j-defaults"),
  JBOX2D("JBox2D, as it comes", "jbox2d-defaults"),
  PUBLISHED("the published algorithm", "poster"),
  SUBSTEPS("8 substeps a frame", "substeps-8"),
  BOX2D_BEST("Box2D at its best", "gdx-box2d-best"),
  DYN4J_BEST("dyn4j at its best", "dyn4j-best"),
  JBOX2D_BEST("JBox2D at its best", "jbox2d-best");

  private final String title;
  private final String id;

  Rival(String title, String id) {
    this.title = title;
    this.id = id;
  }

  /** Its name in headings: a phrase. */
  public String title() {
    return title;
  }

  /** The method. */
  Contender contender() {
    return Contenders.byId(id);
  }

  /** This library, which plays by the same rules. */
  static Contender carom() {
    return Methods.CAROM;
  }

  /** Its name in options. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
