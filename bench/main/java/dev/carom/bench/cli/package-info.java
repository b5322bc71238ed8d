// SPDX-License-Identifier: Apache-2.0

/** The command line: options, files and messages. What is measured stands in other packages. */
package dev.carom.bench.cli;
