// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.WindowConstants;

/** Keeps a command going while its window is open. */
final class Windows {

  private Windows() {}

  /** Opens a window and waits until it is closed. */
  static void show(Supplier<JFrame> maker) {
    if (GraphicsEnvironment.isHeadless()) {
      throw new IllegalStateException(
          "a window needs a screen, and there is none: --png FILE draws a picture instead");
    }
    CountDownLatch closed = new CountDownLatch(1);
    EventQueue.invokeLater(() -> open(maker, closed));
    try {
      closed.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void open(Supplier<JFrame> maker, CountDownLatch closed) {
    JFrame frame = maker.get();
    frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            closed.countDown();
          }
        });
    frame.setLocationByPlatform(true);
    frame.setVisible(true);
  }
}
