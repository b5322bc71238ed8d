// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import picocli.CommandLine.IVersionProvider;

/** The version that the jar's manifest tells. */
final class Version implements IVersionProvider {

  @Override
  public String[] getVersion() {
    String version = getClass().getPackage().getImplementationVersion();
    return new String[] {"carom-bench " + (version == null ? "(not packaged)" : version)};
  }
}
