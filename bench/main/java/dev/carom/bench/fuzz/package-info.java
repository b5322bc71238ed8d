// SPDX-License-Identifier: Apache-2.0
/** Random worlds and long runs, watched by rules that do not use the library's own detector. */
package dev.carom.bench.fuzz;
