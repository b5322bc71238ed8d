// SPDX-License-Identifier: Apache-2.0

/**
 * Pictures: scenes, motion and charts, as PNG and SVG, without a screen. The same input gives the
 * same bytes on one machine; on another the fonts may differ. {@link SceneDrawing}, {@link Still},
 * and {@link Style} need nothing but the library and java.desktop, so that windows and examples can
 * use them too.
 *
 * <p>Scenes are drawn with y upwards, as {@link dev.carom.Wall} names the walls.
 */
package dev.carom.bench.charts;
