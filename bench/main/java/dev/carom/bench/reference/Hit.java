// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.reference;

import dev.carom.Feature;
import dev.carom.Kind;

/**
 * One impact of a run.
 *
 * @param circle which circle; of a pair the lower number
 * @param kind the kind of thing it hit
 * @param obstacle which thing of that kind; of a pair the other circle
 * @param feature the part that was hit
 */
record Hit(int circle, Kind kind, int obstacle, Feature feature) {}
