// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JComponent;

/** Lays a panel out once more when the width of its tool bar changed, and with it its rows. */
final class Rewrap extends ComponentAdapter {

  private final JComponent panel;
  private int width;

  Rewrap(JComponent panel) {
    this.panel = panel;
  }

  @Override
  public void componentResized(ComponentEvent e) {
    if (e.getComponent().getWidth() != width) {
      width = e.getComponent().getWidth();
      panel.revalidate();
    }
  }
}
