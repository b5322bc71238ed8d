// SPDX-License-Identifier: Apache-2.0
/**
 * Physics engines that others use, set up to play the same scenes: each as it comes, and as well as
 * its documentation allows.
 */
package dev.carom.bench.peers;
