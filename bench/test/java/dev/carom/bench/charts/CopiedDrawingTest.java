// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.World;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The classes that draw a scene can be copied into any Swing program: they need the library only.
 */
class CopiedDrawingTest {

  private static final List<String> FILES =
      List.of("SceneDrawing", "SceneExtent", "Sides", "Still", "Style", "WorldScene");

  @Test
  void compilesBesideTheLibraryAlone(@TempDir Path out) {
    String library = World.class.getProtectionDomain().getCodeSource().getLocation().getPath();
    List<String> args = new ArrayList<>(List.of("-cp", library, "-d", out.toString()));
    args.addAll(List.of("-proc:none", "-sourcepath", out.toString()));
    FILES.forEach(name -> args.add("main/java/dev/carom/bench/charts/" + name + ".java"));
    ByteArrayOutputStream complaints = new ByteArrayOutputStream();

    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, complaints, args.toArray(String[]::new));

    assertThat(failed).as(complaints.toString(StandardCharsets.UTF_8)).isZero();
    assertThat(out.resolve("dev/carom/bench/charts/SceneDrawing.class")).exists();
  }
}
