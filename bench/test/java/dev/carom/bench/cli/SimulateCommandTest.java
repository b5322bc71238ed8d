// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SimulateCommandTest {

  /** One circle between a wall, a peg and a line, with times that are exact. */
  private static final String SCENE =
      """
      wall,0,0,100,100
      peg,50,90,2
      line,30,0,30,40
      line,60,0,60,40
      circle,40,20,5,10,0
      circle,50,73,5,0,10
      circle,15,80,5,-8,0
      """;

  @TempDir private Path folder;

  private Path scene;
  private Path positions;
  private Path impacts;

  @BeforeEach
  void write() throws IOException {
    scene = folder.resolve("scene.csv");
    positions = folder.resolve("positions.csv");
    impacts = folder.resolve("impacts.csv");
    Files.writeString(scene, SCENE);
  }

  /** A wall that moves with u turns v into -v + 2 u: here -2 into 8, at time 2. */
  @Test
  void aWallThatMovesPushes() throws IOException {
    Files.writeString(
        scene,
        """
        line,0,-10,0,10,vx=3
        peg,100,50,1,vy=-2
        circle,11,0,1,-2,0
        circle,100,27,2,0,8
        """);

    Cli.run(
        "simulate --scene", scene, "--frames", 3, "--positions", positions, "--impacts", impacts);

    assertThat(positions).content().endsWith("3,0,15.0,0.0\n3,1,100.0,31.0\n");
    assertThat(impacts)
        .hasContent(
            """
            time,circle,obstacle,feature,x,y,nx,ny,speed,outcome
            2.0,0,line 0,SIDE,6.0,0.0,1.0,0.0,5.0,BOUNCED
            2.0,1,peg 0,CIRCLE,100.0,45.0,0.0,-1.0,10.0,BOUNCED
            """);
  }

  /** By another name: a link. */
  @Test
  void theSceneIsNotOverwritten() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), scene);

    Cli run = Cli.run("simulate --scene", scene, "--frames", 2, "--impacts", link);

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(scene).hasContent(SCENE);
  }

  @Test
  void writesPositionsAfterEveryFrame() throws IOException {
    Cli run = Cli.run("simulate --scene", scene, "--frames", 2, "--positions", positions);

    assertThat(run.exitCode()).isZero();
    assertThat(positions)
        .hasContent(
            """
            frame,circle,x,y
            1,0,50.0,20.0
            1,1,50.0,83.0
            1,2,7.0,80.0
            2,0,50.0,20.0
            2,1,50.0,73.0
            2,2,11.0,80.0
            """);
  }

  @Test
  void writesImpactsInTheOrderOfTime() throws IOException {
    Cli run = Cli.run("simulate --scene", scene, "--frames", 2, "--impacts", impacts);

    assertThat(impacts)
        .hasContent(
            """
            time,circle,obstacle,feature,x,y,nx,ny,speed,outcome
            1.0,1,peg 0,CIRCLE,50.0,88.0,0.0,-1.0,10.0,BOUNCED
            1.25,2,wall left,SIDE,0.0,80.0,1.0,0.0,8.0,BOUNCED
            1.5,0,line 1,SIDE,60.0,20.0,-1.0,0.0,10.0,BOUNCED
            """);
    assertThat(run.out())
        .isEqualToNormalizingNewlines("time 2.0: 3 circles, 3 impacts, 1 of them with walls\n");
  }

  @Test
  void aCollisionIsOneRowOfTheLowerNumber() throws IOException {
    Files.writeString(scene, "circle,12,0,3,-2,0\ncircle,0,0,1,2,0,1\ncollide,1\n");
    Cli.run("simulate --scene", scene, "--frames", 3, "--impacts", impacts);

    assertThat(impacts)
        .hasContent(
            """
            time,circle,obstacle,feature,x,y,nx,ny,speed,outcome
            2.0,0,circle 1,CIRCLE,5.0,0.0,1.0,0.0,4.0,BOUNCED
            """);
  }

  @Test
  void theLastColumnIsWhatTheImpactDid() throws IOException {
    Files.writeString(
        scene,
        """
        line,10,0,10,9,response=sensor
        line,26,0,26,9,response=halt
        circle,1,5,1,8,0
        circle,40,5,2,3,0,inf
        circle,55,5,1,0,0,inf
        collide,1
        """);

    Cli.run("simulate --scene", scene, "--frames", 4, "--impacts", impacts);

    assertThat(impacts)
        .hasContent(
            """
            time,circle,obstacle,feature,x,y,nx,ny,speed,outcome
            1.0,0,line 0,SIDE,10.0,5.0,-1.0,0.0,8.0,SENSED
            3.0,0,line 1,SIDE,26.0,5.0,-1.0,0.0,8.0,HALTED
            4.0,1,circle 2,CIRCLE,54.0,5.0,-1.0,0.0,3.0,PASSED
            """);
  }

  @Test
  void aFrameIsAsLongAsAsked() throws IOException {
    Cli.run(
        "simulate --scene",
        scene,
        "--frames",
        8,
        "--dt",
        0.25,
        "--positions",
        positions,
        "--impacts",
        impacts);

    assertThat(positions).content().contains("\n4,1,50.0,83.0\n").contains("\n8,2,11.0,80.0\n");
    assertThat(impacts).content().contains("\n1.25,2,wall left").contains("\n1.5,0,line 1");
  }

  @Test
  void writesNothingWhenTheOtherFileCannotBeWritten() {
    Path nowhere = folder.resolve("nowhere/impacts.csv");

    Cli run =
        Cli.run(
            "simulate --scene",
            scene,
            "--frames",
            1,
            "--positions",
            positions,
            "--impacts",
            nowhere);

    assertThat(run.exitCode()).isEqualTo(1);
    assertThat(run.err()).contains(nowhere + ": cannot be written: no such folder").hasLineCount(1);
    assertThat(folder.toFile().list()).containsExactly("scene.csv");
  }

  @Test
  void circlesThatBeginWhereTheyOverlapAreToldOfTen() throws IOException {
    Files.writeString(scene, "wall,0,0,9,9\ncollide,0\n" + "circle,1,5,2,0,0\n".repeat(10));
    Cli ten = Cli.run("simulate --scene", scene, "--frames", 1);
    Files.writeString(scene, "wall,0,0,9,9\ncollide,0\n" + "circle,1,5,2,0,0\n".repeat(13));
    Cli more = Cli.run("simulate --scene", scene, "--frames", 1);

    assertThat(ten.exitCode()).isZero();
    assertThat(ten.err()).hasLineCount(10);
    assertThat(more.err().lines())
        .hasSize(11)
        .startsWith(
            "carom-bench simulate: warning: circle 0: distance from the left wall is 1.0: expected"
                + " at least 2.0, its radius")
        .endsWith("carom-bench simulate: warning: and 3 more");
    assertThat(more.out()).hasLineCount(1);
  }

  /** A limit on the size of files stands for a disk that is full. */
  @Test
  void whereTheDiskIsFullOneLineNamesTheFile() throws Exception {
    assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"));
    List<String> command = new ArrayList<>();
    command.addAll(List.of("sh", "-c", "ulimit -f 8; exec \"$@\"", "sh"));
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:-UsePerfData", "-cp", System.getProperty("java.class.path")));
    command.addAll(List.of("dev.carom.bench.Main", "simulate", "--scene", scene.toString()));
    command.addAll(List.of("--frames", "2000", "--positions", positions.toString()));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();

    String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertThat(told)
        .isEqualToNormalizingNewlines(
            "carom-bench simulate: " + positions + ": cannot be written: File too large\n");
    assertThat(process.waitFor()).isEqualTo(1);
    assertThat(folder.toFile().list()).containsExactly("scene.csv");
  }
}
