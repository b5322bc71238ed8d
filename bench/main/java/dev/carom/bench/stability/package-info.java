// SPDX-License-Identifier: Apache-2.0
/**
 * Where methods fail: grids of small scenes, each judged against its true course, which is known in
 * closed form or computed in high precision.
 */
package dev.carom.bench.stability;
