// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.ImpactLog;

/**
 * An impact that was seen.
 *
 * @param circle the id of the circle
 * @param x the x coordinate of the contact point
 * @param y the y coordinate of the contact point
 * @param nx the x component of the unit normal
 * @param ny the y component of the unit normal
 */
record Mark(double time, int circle, double x, double y, double nx, double ny) {

  static Mark of(ImpactLog log, int row) {
    return new Mark(
        log.time(row), log.circle(row), log.x(row), log.y(row), log.nx(row), log.ny(row));
  }
}
