// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Impact;
import dev.carom.Line;
import dev.carom.Scene;
import dev.carom.SceneBuilder;
import dev.carom.SweptCircle;
import dev.carom.Vec2;
import dev.carom.bench.charts.Courses;
import dev.carom.bench.charts.Motion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures of the Javadoc show what the library does: they are drawn from its answers. With {@code
 * -Dcarom.pictures=write} they are written anew.
 */
class GuidePicturesTest {

  private static final Path FOLDER = Path.of("../src/main/javadoc/dev.carom/dev/carom/doc-files");

  private static final String TOUCH_HEAD =
      """
      <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 215" width="640" height="215" font-family="Helvetica, Arial, DejaVu Sans, sans-serif" font-size="14" text-anchor="middle">
        <title>An impact needs both: the circle touches or overlaps the line, and comes nearer to it</title>
        <defs><marker id="head" viewBox="0 0 10 10" refX="8" refY="5" markerWidth="5" markerHeight="5" orient="auto"><path d="M0 0L10 5L0 10z" fill="#D55E00"/></marker></defs>
        <rect width="640" height="215" rx="6" fill="#FFFFFF"/>
      """;

  private static final Map<String, Supplier<String>> PICTURES =
      Map.of(
          "sweep.svg", GuidePicturesTest::sweep,
          "touch.svg", GuidePicturesTest::touch,
          "heap.svg", () -> moving("Balls fall, bounce, and rest in a heap", heap(), 360),
          "contact.svg", () -> moving("A ball slides over a joint and into a corner", bowl(), 300),
          "moving.svg", () -> moving("A line that moves pushes balls along", broom(), 200));

  @ParameterizedTest
  @ValueSource(strings = {"sweep.svg", "touch.svg", "heap.svg", "contact.svg", "moving.svg"})
  void aPictureShowsWhatTheLibraryDoes(String name) throws IOException {
    String drawn = PICTURES.get(name).get();
    if ("write".equals(System.getProperty("carom.pictures"))) {
      Files.writeString(FOLDER.resolve(name), drawn);
    }
    assertThat(FOLDER.resolve(name)).as("drawn by -Dcarom.pictures=write").hasContent(drawn);
  }

  private static String moving(String title, Scene scene, int frames) {
    Courses courses = Courses.of(scene, frames, 1);
    return Motion.svg(scene, title, List.of(new Motion.Side("", courses)), frames / 60.0);
  }

  private static Scene heap() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 400, 240).gravity(0, -0.15);
    scene.line(0, 100, 200, 0).line(200, 0, 400, 100);
    for (int i = 0; i < 18; i++) {
      scene.circle(70 + 52 * (i % 6) + 3 * (i / 6), 120 + 40 * (i / 6), 15, 0, 0).restitution(0.6);
    }
    return scene.build();
  }

  private static Scene bowl() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 400, 200).gravity(0, -0.08);
    scene.line(0, 170, 120, 60).line(120, 60, 300, 20).line(300, 20, 400, 150);
    return scene.circle(30, 175, 16, 0, 0).restitution(0).build();
  }

  private static Scene broom() {
    SceneBuilder scene = Scene.builder().bounds(0, 0, 400, 160);
    scene.line(20, 10, 20, 150).velocity(1.4, 0);
    return scene
        .circle(90, 110, 16, 0, 0)
        .circle(180, 60, 16, 0, 0)
        .circle(250, 90, 16, -1, 0.4)
        .build();
  }

  /** A circle at its start and at its impact, with the point, the normal and the time. */
  private static String sweep() {
    SweptCircle circle = new SweptCircle(70, 200, 40, 260, -105);
    Line line = new Line(220, 30, 385, 120);
    Impact hit = circle.cast(line, 1).orElseThrow();
    Vec2 from = new Vec2(circle.x(), circle.y());
    Vec2 to =
        new Vec2(circle.x() + circle.vx() * hit.time(), circle.y() + circle.vy() * hit.time());
    Vec2 tip = new Vec2(to.x() + 75 * hit.normal().x(), to.y() + 75 * hit.normal().y());
    return """
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 560 260" width="560" height="260" font-family="Helvetica, Arial, DejaVu Sans, sans-serif" font-size="15">
          <title>A sweep: a circle at time 0, and at its impact with a line</title>
          <defs><marker id="normal" viewBox="0 0 10 10" refX="8" refY="5" markerWidth="5" markerHeight="5" orient="auto"><path d="M0 0L10 5L0 10z" fill="#D55E00"/></marker></defs>
          <rect width="560" height="260" rx="6" fill="#FFFFFF"/>
          <path d="%s" stroke="#22262B" stroke-width="3" stroke-linecap="round"/>
          <path d="%s" stroke="#0072B2" stroke-width="1.5" stroke-dasharray="5 4"/>
          <g fill="#56B4E9" fill-opacity="0.25" stroke="#0072B2" stroke-width="1.5"><circle %s r="40" stroke-dasharray="5 4"/><circle %s r="40"/></g>
          <path d="%s" stroke="#D55E00" stroke-width="2.5" marker-end="url(#normal)"/>
          <circle %s r="4.5" fill="#D55E00"/>
          <g fill="#22262B"><text x="%.0f" y="%.0f" text-anchor="middle">time 0</text><text x="%.0f" y="%.0f">time %.3f</text></g>
          <g fill="#D55E00"><text x="%.0f" y="%.0f">normal</text><text x="%.0f" y="%.0f">point</text></g>
        </svg>
        """
        .formatted(
            path(new Vec2(line.ax(), line.ay()), new Vec2(line.bx(), line.by())),
            path(from, to),
            at(from),
            at(to),
            path(to, tip),
            at(hit.point()),
            from.x(),
            260 - from.y() + 60,
            to.x() + 42,
            260 - to.y() - 20,
            hit.time(),
            tip.x() + 9,
            260 - tip.y() + 5,
            hit.point().x() + 8,
            260 - hit.point().y() + 18);
  }

  /** Circles over a line, with their velocities, and when each of them hits it. */
  private static String touch() {
    return TOUCH_HEAD
        + touch(0, "apart,", "comes nearer", 45, -40)
        + touch(1, "touches,", "comes nearer", 30, -40)
        + touch(2, "touches,", "leaves", 30, 40)
        + touch(3, "overlaps,", "comes nearer", 20, -40)
        + touch(4, "overlaps,", "leaves", 20, 40)
        + "</svg>\n";
  }

  private static String touch(int panel, String how, String way, double height, double vy) {
    double x = 64 + 128 * panel;
    Line line = new Line(x - 50, 150, x + 50, 150);
    SweptCircle circle = new SweptCircle(x, 150 + height, 30, 0, vy);
    double time = circle.timeToLine(line.ax(), line.ay(), line.bx(), line.by(), 10);
    Vec2 from = new Vec2(circle.x(), circle.y());
    Vec2 tip = new Vec2(circle.x(), circle.y() + circle.vy());
    String answer = time <= 10 ? String.format(Locale.ROOT, "impact at %.3g", time) : "no impact";
    return """
          <path d="%s" stroke="#22262B" stroke-width="3" stroke-linecap="round"/>
          <circle %s r="30" fill="#56B4E9" fill-opacity="0.35" stroke="#0072B2" stroke-width="1.5"/>
          <path d="%s" stroke="#D55E00" stroke-width="2.5" marker-end="url(#head)"/>
          <text x="%.0f" y="155">%s</text><text x="%.0f" y="174">%s</text><text x="%.0f" y="200" font-weight="bold" fill="%s">%s</text>
        """
        .formatted(
            path(new Vec2(line.ax(), line.ay()), new Vec2(line.bx(), line.by())),
            at(from),
            path(from, tip),
            x,
            how,
            x,
            way,
            x,
            time <= 10 ? "#D55E00" : "#22262B",
            answer);
  }

  private static String path(Vec2 from, Vec2 to) {
    return String.format(
        Locale.ROOT, "M%.1f %.1fL%.1f %.1f", from.x(), 260 - from.y(), to.x(), 260 - to.y());
  }

  private static String at(Vec2 place) {
    return String.format(Locale.ROOT, "cx=\"%.1f\" cy=\"%.1f\"", place.x(), 260 - place.y());
  }
}
