// SPDX-License-Identifier: Apache-2.0
/** The calendar queue, which yields the circle with the next event. */
package dev.carom.internal.queue;
