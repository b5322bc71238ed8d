// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Content of a folder before and after a file is written, or fails to be written. */
class WholeFileTest {

  @TempDir private Path folder;

  private void assumeLinks() {
    assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"));
  }

  @Test
  void itAppearsAtTheEnd() throws IOException {
    Path file = Files.writeString(folder.resolve("p.csv"), "old");
    try (WholeFile whole = WholeFile.create(file)) {
      whole.out().write("new".getBytes(StandardCharsets.UTF_8));
      assertThat(file).hasContent("old");
      whole.commit();
    }
    assertThat(file).hasContent("new");
    assertThat(folder.toFile().list()).containsExactly("p.csv");
  }

  @Test
  void itDoesNotAppearUnlessItIsCommitted() throws IOException {
    Path file = folder.resolve("p.csv");
    try (WholeFile whole = WholeFile.create(file)) {
      whole.out().write('n');
    }
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void whatIsBesideItStays() throws IOException {
    Path other = Files.writeString(folder.resolve("p.csv.draft"), "mine");
    WholeFile.write(folder.resolve("p.csv"), "new");
    assertThat(other).hasContent("mine");
    assertThat(folder.resolve("p.csv")).hasContent("new");
  }

  @Test
  void aLinkStaysOne() throws IOException {
    assumeLinks();
    Path file = Files.writeString(folder.resolve("p.csv"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), Path.of("p.csv"));
    Path toNone = Files.createSymbolicLink(folder.resolve("none.csv"), Path.of("q.csv"));
    WholeFile.write(link, "new");
    WholeFile.write(toNone, "first");
    assertThat(link).isSymbolicLink();
    assertThat(file).hasContent("new");
    assertThat(toNone).isSymbolicLink();
    assertThat(folder.resolve("q.csv")).hasContent("first");
  }

  @Test
  void whoMayReadItStaysTheSame() throws IOException {
    assumeLinks();
    Path file = Files.writeString(folder.resolve("p.csv"), "old");
    Set<PosixFilePermission> own = PosixFilePermissions.fromString("rw-------");
    Files.setPosixFilePermissions(file, own);
    WholeFile.write(file, "new");
    assertThat(Files.getPosixFilePermissions(file)).isEqualTo(own);
    Path usual = Files.writeString(folder.resolve("usual"), "");
    WholeFile.write(folder.resolve("q.csv"), "new");
    assertThat(Files.getPosixFilePermissions(folder.resolve("q.csv")))
        .isEqualTo(Files.getPosixFilePermissions(usual));
  }

  @Test
  void aFailureNamesTheFileAndTheCause() throws IOException {
    Path nowhere = folder.resolve("none").resolve("p.csv");
    assertThatThrownBy(() -> WholeFile.write(nowhere, "new"))
        .isInstanceOf(IOException.class)
        .hasMessage(nowhere + ": cannot be written: no such folder");
    assumeLinks();
    Path loop = folder.resolve("loop");
    Files.createSymbolicLink(loop, loop);
    assertThatThrownBy(() -> WholeFile.write(loop, "new"))
        .hasMessage(loop + ": cannot be written: more than 40 symbolic links in a row (a loop?)");
    assertThat(folder.toFile().list()).containsExactly("loop");
  }

  @Test
  void aDeviceHasNoDraft() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full));
    assertThatThrownBy(() -> WholeFile.write(full, "new"))
        .hasMessage("/dev/full: cannot be written: No space left on device");
    assertThat(full).exists();
  }
}
