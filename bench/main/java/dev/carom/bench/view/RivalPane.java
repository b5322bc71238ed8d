// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.duel.Duel;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;

/** The rival's side of a duel, drawn like the player's scene. */
final class RivalPane extends JComponent {

  private static final long serialVersionUID = 1;

  private final transient Arena arena;
  private final SceneCanvas canvas;

  RivalPane(Arena arena, SceneCanvas canvas) {
    this.arena = arena;
    this.canvas = canvas;
    addMouseWheelListener(this::zoom);
  }

  private void zoom(MouseWheelEvent e) {
    canvas.zoom(SceneCanvas.factor(e), e.getPoint());
    repaint();
  }

  @Override
  protected void paintComponent(Graphics to) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      ScenePainter painter = canvas.painter();
      g.setColor(painter.scheme().paper());
      g.fillRect(0, 0, getWidth(), getHeight());
      Duel duel = arena.duel();
      Rectangle2D area = new Rectangle2D.Double(0, 0, getWidth(), getHeight());
      painter.draw(g, area, duel.scene(), duel::rival, arena.frame());
    } finally {
      g.dispose();
    }
  }
}
