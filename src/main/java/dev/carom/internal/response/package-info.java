// SPDX-License-Identifier: Apache-2.0
/**
 * The effect of an impact: impulses and normals; the contact of heaps under gravity ({@code
 * ContactCore}); and circles that are stuck.
 */
package dev.carom.internal.response;
