// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Insets;

/** A flow of components from the left, which asks for as many rows as its width makes it take. */
final class WrapLayout extends FlowLayout {

  private static final long serialVersionUID = 1;

  WrapLayout(int hgap, int vgap) {
    super(LEFT, hgap, vgap);
  }

  @Override
  public Dimension preferredLayoutSize(Container target) {
    synchronized (target.getTreeLock()) {
      return size(target);
    }
  }

  @Override
  public Dimension minimumLayoutSize(Container target) {
    return new Dimension(1, preferredLayoutSize(target).height);
  }

  private Dimension size(Container target) {
    Insets insets = target.getInsets();
    int most = target.getWidth() > 0 ? target.getWidth() : Integer.MAX_VALUE;
    int room = most - insets.left - insets.right - 2 * getHgap();
    int x = 0;
    int row = 0;
    int widest = 0;
    int height = 0;
    for (Component c : target.getComponents()) {
      Dimension d = c.getPreferredSize();
      if (x > 0 && x + d.width > room) {
        height += row + getVgap();
        x = 0;
        row = 0;
      }
      x += (x > 0 ? getHgap() : 0) + d.width;
      row = Math.max(row, d.height);
      widest = Math.max(widest, x);
    }
    return new Dimension(
        Math.min(most, widest + insets.left + insets.right + 2 * getHgap()),
        height + row + insets.top + insets.bottom + 2 * getVgap());
  }
}
