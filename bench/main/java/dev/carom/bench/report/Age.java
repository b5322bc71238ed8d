// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** How old a measured commit is, where its history is at hand. */
final class Age {

  private Age() {}

  /** Words to stand behind a commit; none if its history is not known here. */
  static String of(String commit) {
    String bare = commit.replace("-dirty", "");
    if (!bare.matches("[0-9a-f]{7,40}")) {
      return "";
    }
    try {
      Process git =
          new ProcessBuilder(List.of("git", "rev-list", "--count", bare + "..HEAD"))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      String count =
          new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
      return git.waitFor() == 0 && count.matches("\\d+") ? words(count) : "";
    } catch (IOException e) {
      return "";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "";
    }
  }

  private static String words(String count) {
    return switch (count) {
      case "0" -> "the newest one when this page was made";
      case "1" -> "1 commit old when this page was made";
      default -> count + " commits old when this page was made";
    };
  }
}
