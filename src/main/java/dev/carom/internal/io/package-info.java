// SPDX-License-Identifier: Apache-2.0
/** Reads and writes scene files and snapshots. */
package dev.carom.internal.io;
