// SPDX-License-Identifier: Apache-2.0
/** The calendar queue, which tells whose event is next. */
package dev.carom.internal.queue;
