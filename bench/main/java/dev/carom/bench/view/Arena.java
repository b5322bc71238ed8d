// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.bench.duel.Duel;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.reference.Reference;

/**
 * The duel beside a player: it follows the player from the moment at which it was begun, forwards
 * and backwards, and begins anew where the player's scene is edited.
 */
final class Arena {

  private final Player player;
  private Rival rival;
  private Duel duel;
  private Scene known;
  private Reference truth;
  private int edits;
  private double start;

  Arena(Player player) {
    this.player = player;
  }

  /** Chooses the rival; null for none. */
  void challenge(Rival chosen) {
    rival = chosen;
    begin();
  }

  /** Sets the true course of a scene, from its start. */
  void setTruth(Scene scene, Reference course) {
    known = scene;
    truth = course;
  }

  private void begin() {
    close();
    if (rival != null) {
      Scene scene = player.scene();
      duel = new Duel(scene, rival, scene.equals(known) ? truth : null);
      start = player.shown();
      edits = player.edits();
    }
  }

  void close() {
    if (duel != null) {
      duel.close();
      duel = null;
    }
  }

  /** Whether a rival plays. */
  boolean isOpen() {
    return duel != null;
  }

  /** The duel, of what the player shows. */
  Duel duel() {
    if (edits != player.edits()) {
      begin();
    }
    return duel;
  }

  /** The last frame that ended at the moment shown, or before; 0 before the duel began. */
  int frame() {
    double frames = (player.shown() - start) / player.frame();
    return (int) Math.max(0, Math.floor(frames + 1e-9));
  }
}
