// SPDX-License-Identifier: Apache-2.0

/** What a gas of colliding circles takes: time per collision, energy kept, deepest overlap. */
package dev.carom.bench.gas;
