// SPDX-License-Identifier: Apache-2.0
/** Scene files and snapshots, read and written. */
package dev.carom.internal.io;
