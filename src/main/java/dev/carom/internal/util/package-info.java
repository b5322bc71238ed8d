// SPDX-License-Identifier: Apache-2.0
/** Checks of arguments, small lists, and the constants for kinds. */
package dev.carom.internal.util;
