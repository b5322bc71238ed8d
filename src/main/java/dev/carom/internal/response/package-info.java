// SPDX-License-Identifier: Apache-2.0
/** What an impact does: impulses, normals, and the rules for circles that are stuck. */
package dev.carom.internal.response;
