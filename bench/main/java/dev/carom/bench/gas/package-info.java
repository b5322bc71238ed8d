// SPDX-License-Identifier: Apache-2.0

/** Measures a gas of colliding circles: time per collision, energy, deepest overlap. */
package dev.carom.bench.gas;
