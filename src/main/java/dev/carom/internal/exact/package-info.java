// SPDX-License-Identifier: Apache-2.0
/**
 * Exact arithmetic: double-double numbers, sums of doubles without rounding and dyadic numbers, the
 * signs and times computed with them, and the budget of that work.
 */
package dev.carom.internal.exact;
