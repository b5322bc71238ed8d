// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import java.awt.Graphics2D;
import java.util.concurrent.atomic.AtomicLong;
import org.jfree.svg.SVGHints;

/** The text that a browser shows when the pointer rests on a mark. An image has none. */
final class Hover {

  /** The name of the groups, which {@link Picture} takes away: there are many of them. */
  static final String GROUP = "hover-";

  /** A picture demands that no two of its groups have one name. */
  private static final AtomicLong NEXT = new AtomicLong();

  private Hover() {}

  /** Draws something that has a text of its own. */
  static void over(Graphics2D g, String text, Runnable drawing) {
    String name = GROUP + NEXT.getAndIncrement();
    g.setRenderingHint(SVGHints.KEY_BEGIN_GROUP, name);
    g.setRenderingHint(SVGHints.KEY_ELEMENT_TITLE, text);
    drawing.run();
    g.setRenderingHint(SVGHints.KEY_END_GROUP, name);
  }
}
