// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.carom.Kind;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.World;
import java.io.StringReader;
import java.util.Arrays;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** A film shows what was there at each step, and nothing before and after. */
class FilmTest {

  private static final int FRAMES = 60;

  private static final Scene SCENE =
      Scene.builder()
          .gravity(0, -0.2)
          .bounds(0, 0, 408, 300)
          .line(50, 40, 120, 40)
          .outline(Outline.rectangle(300, 200, 340, 220))
          .circle(60, 250, 10, 3, 0)
          .circle(200, 100, 10, 0, 0)
          .build();

  @Test
  void eachThingIsWhereItWasWhenItWas() throws Exception {
    World world = new World(SCENE);
    Film film = new Film(world, 0.05);
    double[] height = new double[FRAMES];
    double[] paddle = new double[FRAMES];
    for (int frame = 0; frame < FRAMES; frame++) {
      height[frame] = world.y(0);
      paddle[frame] = world.line(0).ax();
      film.add(world);
      if (frame == 19) {
        world.moveTo(Kind.LINE, 0, 90, 40, 40);
      }
      if (frame == 29) {
        world.remove(Kind.CIRCLE, 1);
        world.remove(Kind.LINE, 1);
      }
      world.step(1);
    }
    Document svg = parse(film.svg("a test"));
    NodeList circles = svg.getElementsByTagName("circle");
    Element line = (Element) svg.getElementsByTagName("line").item(0);
    for (int frame = 0; frame < FRAMES; frame++) {
      double time = frame / (FRAMES - 1.0);
      double up = at((Element) circles.item(0), "cy", time, true);
      double before = at((Element) circles.item(0), "cy", 0, true);
      double scale = scale((Element) circles.item(0));
      assertEquals(scale * (height[0] - height[frame]), up - before, 0.5);
      double aside = at(line, "x1", time, true) - at(line, "x1", 0, true);
      assertEquals(scale * (paddle[frame] - paddle[0]), aside, 0.5);
      double seen = at((Element) circles.item(1), "opacity", time, false);
      assertEquals(frame <= 29 ? 1 : 0, seen, "frame " + frame);
    }
    Element brick = (Element) svg.getElementsByTagName("polygon").item(0);
    assertEquals(0, at(brick, "opacity", 0.9, false));
    assertTrue(film.svg("a test").length() < 10_000, "few keys tell a parabola");
  }

  private static double scale(Element circle) {
    return Double.parseDouble(circle.getAttribute("r")) / 10;
  }

  private static Document parse(String svg) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(svg)));
  }

  /** What a browser shows of an attribute after a share of the film. */
  private static double at(Element element, String attribute, double share, boolean isEven) {
    NodeList all = element.getElementsByTagName("animate");
    for (int i = 0; i < all.getLength(); i++) {
      Element move = (Element) all.item(i);
      if (move.getAttribute("attributeName").equals(attribute)) {
        return value(numbers(move, "keyTimes"), numbers(move, "values"), share, isEven);
      }
    }
    return Double.parseDouble(element.getAttribute(attribute));
  }

  private static double[] numbers(Element move, String name) {
    return Arrays.stream(move.getAttribute(name).split(";"))
        .mapToDouble(Double::parseDouble)
        .toArray();
  }

  private static double value(double[] times, double[] values, double share, boolean isEven) {
    int k = 0;
    while (k + 1 < times.length && times[k + 1] <= share + 1e-4) {
      k++;
    }
    if (!isEven || k + 1 == times.length) {
      return values[k];
    }
    return values[k] + (share - times[k]) / (times[k + 1] - times[k]) * (values[k + 1] - values[k]);
  }
}
