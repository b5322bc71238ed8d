// SPDX-License-Identifier: Apache-2.0
/** Questions that move nothing: what is hit first, what is nearest, what overlaps. */
package dev.carom.internal.query;
