// SPDX-License-Identifier: Apache-2.0
/** The effect of an impact: impulses, normals, and the rules for circles that are stuck. */
package dev.carom.internal.response;
