// SPDX-License-Identifier: Apache-2.0
/** Whether runs give the same bits everywhere: a hash of all that happens in them. */
package dev.carom.bench.hash;
