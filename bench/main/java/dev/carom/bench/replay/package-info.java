// SPDX-License-Identifier: Apache-2.0

/**
 * The main measurement: a scene replayed by several methods in turn, each in fresh virtual machines
 * that JMH forks and warms up. Forks hand their raw frame times back through files; figures are
 * computed here from all of them.
 *
 * <p>Golden runs are replayed too, for their bits instead of their times: the hash of all that
 * happens in them is the same on every machine.
 */
package dev.carom.bench.replay;
