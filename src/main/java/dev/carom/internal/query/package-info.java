// SPDX-License-Identifier: Apache-2.0
/** Questions that change nothing: the first thing hit, the nearest thing, overlapping things. */
package dev.carom.internal.query;
