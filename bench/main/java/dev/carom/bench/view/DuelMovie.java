// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.bench.charts.AnimatedGif;
import dev.carom.bench.charts.Style;
import dev.carom.bench.duel.Duel;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A duel as a GIF that plays for ever: both sides, and their scores. Needs no screen. */
public final class DuelMovie {

  private static final int WIDTH = 800;
  private static final int HEAD = 32;
  private static final int SCENE = 300;
  private static final double TITLE = 15;
  private static final int INSET = 26;
  private static final int COLORS = 32;

  /** Frames from image to image. */
  private static final int STRIDE = 2;

  /** The time of an image in hundredths of a second: two frames at 60 a second, about. */
  private static final int DELAY = 3;

  private static final int REST = 150;

  private final Duel duel;
  private final String title;
  private final ScenePainter painter;

  private DuelMovie(Duel duel, String title) {
    this.duel = duel;
    this.title = title;
    painter = new ScenePainter(duel.scene());
  }

  /**
   * Plays a duel and draws every second frame.
   *
   * @param title the heading
   * @param frames how many, at least 0
   * @return the bytes of a GIF file, {@value #WIDTH} pixels wide
   * @throws IOException if this Java cannot write GIF
   */
  public static byte[] gif(Duel duel, String title, int frames) throws IOException {
    DuelMovie movie = new DuelMovie(duel, title);
    duel.carom(frames); // all of it before the first image is drawn, which would cost it its caches
    duel.rival(frames);
    List<BufferedImage> images = new ArrayList<>();
    for (int frame = 0; frame <= frames; frame += STRIDE) {
      images.add(movie.image(frame));
    }
    return AnimatedGif.of(images, COLORS, DELAY, REST);
  }

  private BufferedImage image(int frame) {
    int height = HEAD + SCENE + ScoreBoard.HEIGHT;
    BufferedImage image = new BufferedImage(WIDTH, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    try {
      Style.smooth(g);
      g.setColor(painter.scheme().paper());
      g.fillRect(0, 0, WIDTH, height);
      head(g, frame);
      int half = WIDTH / 2;
      scene(g, new Rectangle(0, HEAD, half, SCENE), frame, true);
      scene(g, new Rectangle(half, HEAD, half, SCENE), frame, false);
      Rectangle2D left = new Rectangle2D.Double(0, HEAD + SCENE, half, ScoreBoard.HEIGHT);
      ScoreBoard.draw(g, left, "Carom", duel.caromScore(frame), painter.scheme());
      Rectangle2D right = new Rectangle2D.Double(half, HEAD + SCENE, half, ScoreBoard.HEIGHT);
      String rival = duel.rival().title();
      ScoreBoard.draw(g, right, rival, duel.rivalScore(frame), painter.scheme());
    } finally {
      g.dispose();
    }
    return image;
  }

  private void head(Graphics2D g, int frame) {
    g.setFont(Style.bold(TITLE));
    g.setColor(painter.scheme().ink());
    g.drawString(title, INSET, HEAD - 8);
    String time = String.format(Locale.ROOT, "frame %d", frame);
    g.setFont(Style.font(TITLE));
    g.setColor(painter.scheme().quiet());
    int width = g.getFontMetrics().stringWidth(time);
    g.drawString(time, WIDTH - INSET - width, HEAD - 8);
  }

  private void scene(Graphics2D to, Rectangle area, int frame, boolean own) {
    Graphics2D g = (Graphics2D) to.create();
    try {
      painter.draw(g, area, duel.scene(), own ? duel::carom : duel::rival, frame);
    } finally {
      g.dispose();
    }
  }
}
