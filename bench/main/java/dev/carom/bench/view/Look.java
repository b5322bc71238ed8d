// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import dev.carom.bench.charts.Style;
import java.util.Map;

/** How the windows look: FlatLaf, light or dark, in the colours of the report. */
public final class Look {

  private static final String ACCENT = "@accentColor";

  private Look() {}

  /** Gives all windows that are made from now on the light look. */
  public static void install() {
    set(false);
  }

  /** Gives all windows, those that are open too, a look. */
  static void set(boolean dark) {
    Style.Scheme scheme = scheme(dark);
    String accent = String.format("#%06x", scheme.rim().getRGB() & 0xFFFFFF);
    FlatLaf.setGlobalExtraDefaults(Map.of(ACCENT, accent));
    if (dark) {
      FlatDarkLaf.setup();
    } else {
      FlatLightLaf.setup();
    }
    FlatLaf.updateUI();
  }

  /** The colours of drawings in that look. */
  static Style.Scheme scheme(boolean dark) {
    return dark ? Style.Scheme.DARK : Style.Scheme.LIGHT;
  }
}
