// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.TestScenes;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SceneFileTest {

  private static final double MAX = Double.MAX_VALUE;
  private static final double MIN = Double.MIN_VALUE;

  /** A scene that has everything a file can say. */
  private static Scene full() {
    SceneBuilder builder = Scene.builder().bounds(-1, -2, 801, 602).restitution(0.9);
    builder.line(0.1, 0.2, 0.3, 0.4).line(5, 6, 7, 8).restitution(1.5).peg(300, 200, 0);
    builder.peg(1, 2, 3).restitution(0).circle(10, 20, 5, -1, 1);
    builder.circle(30, 40, 5, -0.0, 0).mass(2.5);
    builder.circle(50, 60, 5, 0, 0).mass(Double.POSITIVE_INFINITY).restitution(1.0 / 3);
    return builder.build();
  }

  private static Scene read(String text) throws IOException {
    return Scene.read(new StringReader(text), "scene.csv");
  }

  private static String written(Scene scene) throws IOException {
    StringBuilder text = new StringBuilder();
    scene.write(text);
    return text.toString();
  }

  @Test
  void writesWallLinesPegsCircles() throws IOException {
    assertThat(written(full()))
        .isEqualTo(
            """
            wall,-1.0,-2.0,801.0,602.0,restitution=0.9
            line,0.1,0.2,0.3,0.4
            line,5.0,6.0,7.0,8.0,restitution=1.5
            peg,300.0,200.0,0.0
            peg,1.0,2.0,3.0,restitution=0.0
            circle,10.0,20.0,5.0,-1.0,1.0
            circle,30.0,40.0,5.0,-0.0,0.0,2.5
            circle,50.0,60.0,5.0,0.0,0.0,inf,restitution=0.3333333333333333
            """);
  }

  @Test
  void whatIsWrittenReadsBackEqual() throws IOException {
    assertThat(read(written(full()))).isEqualTo(full());
    Scene empty = Scene.builder().build();
    assertThat(written(empty)).isEmpty();
    assertThat(read("")).isEqualTo(empty);
  }

  @Test
  void whatHoldsAnywayMayBeSaid() throws IOException {
    assertThat(
            read(
                """
                collide,0
                line,1,2,3,4,response=bounce,oneway=0
                outline,0,0,9,0,9,9,solid=0
                peg,1,2,3,vx=0,vy=0
                """))
        .isEqualTo(
            Scene.builder()
                .line(1, 2, 3, 4)
                .outline(Outline.polyline(0, 0, 9, 0, 9, 9))
                .peg(1, 2, 3)
                .collide(false)
                .build());
  }

  @Test
  void theExampleOfTheJavadoc() throws IOException {
    String text =
        """
        # xmin, ymin, xmax, ymax
        wall,0,0,800,600
        # ax, ay, bx, by
        line,300,200,500,400,restitution=0.9
        # x, y, radius
        peg,600,300,25
        # x, y, radius, vx, vy and, if need be, the mass
        circle,100,100,10,4,3
        """;
    assertThat(read(text))
        .isEqualTo(
            Scene.builder()
                .bounds(0, 0, 800, 600)
                .line(300, 200, 500, 400)
                .restitution(0.9)
                .peg(600, 300, 25)
                .circle(100, 100, 10, 4, 3)
                .build());
  }

  @Test
  void numbersAtTheEndsOfTheirRange() throws IOException {
    Scene large =
        Scene.builder()
            .bounds(-MAX, -MAX, MAX, MAX)
            .restitution(MAX)
            .line(MAX, -MAX, -0.0, MIN)
            .restitution(MIN)
            .peg(-MAX, -MIN, MAX)
            .circle(MAX, -MAX, MAX, MAX, -MAX)
            .mass(0x1p500)
            .circle(-0.0, -MIN, 0x1p1000, Double.MIN_NORMAL, -0.0)
            .mass(0x1p-500)
            .restitution(-0.0)
            .gravity(-MAX, MIN)
            .build();
    SceneBuilder setup = Scene.builder().bounds(-MIN, -0.0, 0.0, MIN).peg(-0.0, 3 * MIN, MIN);
    setup.circle(-MIN, Math.nextDown(Double.MIN_NORMAL), 0x1p-1064, -0.0, MIN).gravity(-MIN, MAX);
    Scene small = setup.build();
    assertThat(read(written(large))).isEqualTo(large);
    assertThat(read(hex(written(large)))).isEqualTo(large);
    assertThat(read(written(small))).isEqualTo(small);
    assertThat(read(hex(written(small)))).isEqualTo(small);
  }

  /** Velocities may be any finite double, so every kind of bit pattern can be tried on them. */
  @Tag("long")
  @Test
  void anyBitsReadBack() throws IOException {
    SplittableRandom random = new SplittableRandom(1);
    SceneBuilder builder = Scene.builder();
    for (int i = 0; i < 20_000; i++) {
      builder.circle(0, 0, 1, anyFinite(random), anyFinite(random));
    }
    Scene scene = builder.build();
    assertThat(read(written(scene))).isEqualTo(scene);
    assertThat(read(hex(written(scene)))).isEqualTo(scene);
  }

  private static double anyFinite(SplittableRandom random) {
    double x = Double.longBitsToDouble(random.nextLong());
    return Double.isFinite(x) ? x : anyFinite(random);
  }

  /** The same text with every number as a hex float. */
  private static String hex(String text) {
    return Pattern.compile("-?\\d[-.E\\d]*")
        .matcher(text)
        .replaceAll(number -> Double.toHexString(Double.parseDouble(number.group())));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "line,1,2,3,4,restitution=0.5\ncollide,1",
        "line,1,2,3,4,restitution=0.5\r\ncollide,1\r\n",
        "line,1,2,3,4,restitution=0.5\rcollide,1",
        "\ufeffline,1,2,3,4,restitution=0.5",
        "\ufeff# comment\n\nline,1,2,3,4,restitution=0.5\n\n",
        "  \t\n # comment, with = and \u00e9\nline,1,2,3,4,restitution=0.5 # trailing, too\n#",
        "line,1,2,3,4,restitution=0.5#",
        " line\t, 1 ,2, 3,\t4 , restitution = 0.5 \t",
        "line,+1,2.,3e0,0x1p2,restitution=.5",
      })
  void whatIsPassedOver(String text) throws IOException {
    assertThat(read(text)).isEqualTo(Scene.builder().line(1, 2, 3, 4).restitution(0.5).build());
  }

  @ParameterizedTest
  @ValueSource(strings = {"inf", "Infinity", " inf "})
  void anInfiniteMass(String mass) throws IOException {
    assertThat(read("circle,1,2,3,4,5," + mass).traits(Kind.CIRCLE, 0).mass())
        .isEqualTo(Double.POSITIVE_INFINITY);
  }

  @Test
  void gravityReadsBackWhereverItsRowStands() throws IOException {
    Scene scene = Scene.builder().gravity(0.1, -1.0 / 3).circle(1, 2, 3, 4, 5).build();
    assertThat(written(scene))
        .isEqualTo(
            """
            gravity,0.1,-0.3333333333333333
            circle,1.0,2.0,3.0,4.0,5.0
            """);
    assertThat(read(written(scene))).isEqualTo(scene);
    assertThat(read("circle,1,2,3,4,5\n gravity , 0.1, -0x1.5555555555555p-2 # down\ncollide,1"))
        .isEqualTo(scene);
  }

  @Test
  void anyBitsOfGravityReadBack() throws IOException {
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 1000; i++) {
      Scene scene = Scene.builder().gravity(anyFinite(random), anyFinite(random)).build();
      assertThat(read(written(scene))).isEqualTo(scene);
      assertThat(read(hex(written(scene)))).isEqualTo(scene);
    }
  }

  @Test
  void readingAFileDoesNotMindCommentsInAnotherEncoding(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("latin-1.csv");
    Files.writeString(file, "# caf\u00e9\npeg,1,2,3\n", StandardCharsets.ISO_8859_1);
    assertThat(Scene.read(file).count(Kind.PEG)).isEqualTo(1);
  }

  @Test
  void aFileThatIsNotThere(@TempDir Path folder) {
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> Scene.read(folder.resolve("none.csv")));
  }

  @Test
  void aFolderIsNoSceneFile(@TempDir Path folder) {
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(() -> Scene.read(folder))
        .withMessage(folder + ": is a folder: expected a file");
  }

  @Test
  void writesAFileAndReplacesIt(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("scene.csv");
    TestScenes.read("base-1.csv").write(file);
    assertThat(Scene.read(file)).isEqualTo(TestScenes.read("base-1.csv"));
    full().write(file);
    assertThat(Scene.read(file)).isEqualTo(full());
    assertThat(folder.toFile().list()).containsExactly("scene.csv");
  }

  /** Not those of a temporary file, which only its owner can read. */
  @Test
  void aNewFileHasTheUsualPermissions(@TempDir Path folder) throws IOException {
    assumeTrue(isPosix(folder), "permissions to compare");
    Path file = folder.resolve("scene.csv");
    full().write(file);
    Path usual = Files.createFile(folder.resolve("usual"));
    assertThat(Files.getPosixFilePermissions(file)).isEqualTo(Files.getPosixFilePermissions(usual));
  }

  private static boolean isPosix(Path path) {
    return path.getFileSystem().supportedFileAttributeViews().contains("posix");
  }

  /** The file changes that the link stands for; the link stays one. */
  @Test
  void writesThroughASymbolicLink(@TempDir Path folder) throws IOException {
    assumeTrue(isPosix(folder), "links need no privilege");
    Path file = Files.createFile(folder.resolve("scene.csv"));
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), file);
    full().write(link);
    assertThat(link).isSymbolicLink();
    assertThat(Scene.read(file)).isEqualTo(full());
  }

  /** To a file that is not there yet, by another link, and to nowhere. */
  @Test
  void aLinkThatLeadsToNoFileMakesIt(@TempDir Path folder) throws IOException {
    assumeTrue(isPosix(folder), "links need no privilege");
    Path inner = Files.createDirectory(folder.resolve("inner"));
    Path link = Files.createSymbolicLink(inner.resolve("link.csv"), Path.of("..", "other.csv"));
    Path other = Files.createSymbolicLink(folder.resolve("other.csv"), Path.of("scene.csv"));
    full().write(link);
    assertThat(link).isSymbolicLink();
    assertThat(other).isSymbolicLink();
    assertThat(Scene.read(folder.resolve("scene.csv"))).isEqualTo(full());
    Path loop = folder.resolve("loop.csv");
    Files.createSymbolicLink(loop, loop);
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(() -> full().write(loop))
        .withMessage(loop + ": cannot be written: more than 40 symbolic links in a row (a loop?)");
    assertThat(folder.toFile().list()).hasSize(4);
  }

  /** As long as file systems allow: a draft has no room for more. */
  @Test
  void aLongNameIsWritten(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("s".repeat(251) + ".csv");
    full().write(file);
    assertThat(Scene.read(file)).isEqualTo(full());
  }

  @Test
  void aFailureLeavesNothingBehind(@TempDir Path folder) throws IOException {
    assertThatThrownBy(() -> full().write(folder)).isInstanceOf(IOException.class);
    assertThat(folder).isEmptyDirectory();
    Path nowhere = folder.resolve("none").resolve("scene.csv");
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(() -> full().write(nowhere))
        .withMessage(nowhere + ": cannot be written: no such folder");
    assertThat(folder).isEmptyDirectory();
  }

  /** A limit on the size of files stands for a disk that is full. */
  @Test
  void whereTheDiskIsFullTheMessageNamesTheFileAndTheOldOneStays(@TempDir Path folder)
      throws Exception {
    assumeTrue(isPosix(folder), "limits of a shell");
    Path file = Files.writeString(folder.resolve("scene.csv"), "circle,0,0,1,1,0\n");
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String classes = Path.of("target", "classes") + ":" + Path.of("target", "test-classes");
    Process process =
        new ProcessBuilder(
                List.of(
                    "sh",
                    "-c",
                    "ulimit -f 8; exec \"$@\"",
                    "sh",
                    java,
                    "-XX:-UsePerfData",
                    "-cp",
                    classes,
                    LargeScene.class.getName(),
                    file.toString()))
            .redirectErrorStream(true)
            .start();
    String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(told).isEqualTo(file + ": cannot be written: File too large");
    assertThat(file).hasContent("circle,0,0,1,1,0\n");
    assertThat(folder.toFile().list()).containsExactly("scene.csv");
  }

  /** Writes a scene of more than 4 kB. */
  static final class LargeScene {

    private LargeScene() {}

    public static void main(String[] files) {
      SceneBuilder scene = Scene.builder();
      for (int i = 0; i < 1000; i++) {
        scene.peg(i, i, 1);
      }
      try {
        scene.build().write(Path.of(files[0]));
      } catch (IOException e) {
        System.out.print(e.getMessage());
      }
    }
  }

  @Test
  void aDeviceThatIsFullIsNamed() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full));
    assertThatExceptionOfType(FileSystemException.class)
        .isThrownBy(() -> full().write(full))
        .withMessage("/dev/full: cannot be written: No space left on device");
  }

  @Test
  void whoMayReadAFileStaysTheSame(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("scene.csv"), "circle,0,0,1,1,0\n");
    assumeTrue(Files.getFileAttributeView(file, PosixFileAttributeView.class) != null);
    Set<PosixFilePermission> own = PosixFilePermissions.fromString("rw-------");
    Files.setPosixFilePermissions(file, own);
    Scene.read(file).write(file);
    assertThat(Files.getPosixFilePermissions(file)).isEqualTo(own);
  }
}
