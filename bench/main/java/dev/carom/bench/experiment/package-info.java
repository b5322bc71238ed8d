// SPDX-License-Identifier: Apache-2.0

/**
 * The experiment: the scene of crosses in which the published run was made, generated from a seed
 * to the same bits on every machine.
 */
package dev.carom.bench.experiment;
