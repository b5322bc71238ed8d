// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.Duel;
import dev.carom.bench.duel.ScoreLine;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.JComponent;

/** Both scores of a duel, side by side under the scenes. */
final class ScorePane extends JComponent {

  private static final long serialVersionUID = 1;

  private final transient Arena arena;
  private final SceneCanvas canvas;

  ScorePane(Arena arena, SceneCanvas canvas) {
    this.arena = arena;
    this.canvas = canvas;
    setPreferredSize(new Dimension(1, ScoreBoard.HEIGHT));
  }

  /** The lines of the left side, then those of the right side. */
  List<List<ScoreLine>> scores() {
    Duel duel = arena.duel();
    int frame = arena.frame();
    return List.of(duel.caromScore(frame), duel.rivalScore(frame));
  }

  @Override
  protected void paintComponent(Graphics to) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      Style.Scheme scheme = canvas.painter().scheme();
      g.setColor(scheme.paper());
      g.fillRect(0, 0, getWidth(), getHeight());
      double half = getWidth() / 2.0;
      List<List<ScoreLine>> scores = scores();
      String rival = arena.duel().rival().title();
      Rectangle2D left = new Rectangle2D.Double(0, 0, half, getHeight());
      ScoreBoard.draw(g, left, "Carom", scores.get(0), scheme);
      Rectangle2D right = new Rectangle2D.Double(half, 0, half, getHeight());
      ScoreBoard.draw(g, right, rival, scores.get(1), scheme);
    } finally {
      g.dispose();
    }
  }
}
