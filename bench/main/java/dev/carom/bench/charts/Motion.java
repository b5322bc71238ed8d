// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outline;
import dev.carom.Scene;
import dev.carom.Vec2;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * A scene in motion as an animated SVG, which plays for ever. Flights are lines and parabolas
 * there, too, so it is sharp and smooth at any size. Its colours follow the reader's choice of
 * light or dark. It needs no script, so that it moves as an image of a page. Where nothing moves,
 * the end is seen.
 */
public final class Motion {

  /**
   * One of several that play a scene.
   *
   * @param name its heading
   * @param courses of the scene's circles
   */
  public record Side(String name, Courses courses) {}

  private static final double WIDTH = 440;
  private static final double GAP = 20;
  private static final double HEAD = 44;
  private static final double FOOT = 28;

  private static final double FRAMES_A_SECOND = 60;

  private static final String STYLE =
      """
      <style>
      .paper{fill:#faf9f5}.floor{fill:#fff}text{fill:#22262b;font:bold 22px DejaVu Sans,Verdana,sans-serif}
      .ink{fill:none;stroke:#22262b;stroke-width:2;stroke-linecap:round;vector-effect:non-scaling-stroke}
      .foot{font-weight:normal;font-size:17px}.solid{fill:#22262b}.bad,.gone{fill:#d55e00}
      .c{fill-opacity:.8;stroke:#0072b2;stroke-width:1.25}.c circle{vector-effect:non-scaling-stroke}
      @media(prefers-color-scheme:dark){.paper{fill:#1b1d21}.floor{fill:#24272c}text{fill:#e8e6e1}
      .ink{stroke:#e8e6e1}.solid{fill:#e8e6e1}.bad,.gone{fill:#f2803a}.c{stroke:#56b4e9}}
      </style>
      """;

  private final Scene scene;
  private final Rectangle2D extent;
  private final double seconds;
  private final int digits;
  private final StringBuilder svg = new StringBuilder();

  private Motion(Scene scene, double seconds) {
    this.scene = scene;
    this.seconds = seconds;
    extent = SceneExtent.of(scene);
    double size = Math.max(extent.getWidth(), extent.getHeight());
    digits = Math.max(0, 4 - (int) Math.ceil(Math.log10(size)));
  }

  /**
   * Draws it.
   *
   * @param scene the scene at time 0
   * @param title what it shows, for those who cannot see it
   * @param sides side by side; of several, each has its name and the number of its lost circles
   * @param seconds how long it plays before it begins anew, greater than 0
   * @return the text of an SVG file
   */
  public static String svg(Scene scene, String title, List<Side> sides, double seconds) {
    return new Motion(scene, seconds).draw(title, sides);
  }

  /**
   * Puts it into a page with a button that pauses it and a slider that goes to any time.
   *
   * @param svg what {@link #svg} made
   * @return the text of an HTML file that needs no other
   */
  public static String html(String svg, String title, double seconds) {
    return """
    <!DOCTYPE html>
    <html lang="en"><head><meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <title>%s</title>
    <style>:root{color-scheme:light dark}body{margin:1rem auto;max-width:60rem;padding:0 1rem;font-family:sans-serif}
    svg{width:100%%;height:auto}p{display:flex;gap:1rem}input{flex:1}</style></head><body>
    %s<p><button>Pause</button><input type="range" min="0" max="%s" step="0.01" aria-label="time"></p>
    <script>
    const svg = document.querySelector("svg"), button = document.querySelector("button");
    const time = document.querySelector("input");
    button.onclick = () => {
      svg.animationsPaused() ? svg.unpauseAnimations() : svg.pauseAnimations();
      button.textContent = svg.animationsPaused() ? "Play" : "Pause";
    };
    time.oninput = () => svg.setCurrentTime(+time.value);
    (function follow() {
      if (!svg.animationsPaused()) time.value = svg.getCurrentTime() %% %s;
      requestAnimationFrame(follow);
    })();
    </script></body></html>
    """
        .formatted(text(title), svg, seconds, seconds);
  }

  private String draw(String title, List<Side> sides) {
    boolean named = sides.size() > 1;
    double head = named ? HEAD : GAP;
    double height = WIDTH * extent.getHeight() / extent.getWidth();
    double width = sides.size() * (WIDTH + GAP) + GAP;
    double foot = named ? FOOT : 0;
    put(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f'>",
        width, head + height + GAP + foot);
    svg.append("<title>").append(text(title)).append("</title>\n").append(STYLE);
    svg.append("<rect class='paper' width='100%' height='100%'/>\n");
    // An svg element for each side would clip it, too, but has a clock of its own.
    put("<clipPath id='side'>%s</clipPath>%n", rectangle("", extent));
    for (int i = 0; i < sides.size(); i++) {
      place(i, head);
      obstacles(sides.get(i).courses.duration());
      circles(sides.get(i).courses);
      svg.append("</g>\n");
    }
    for (int i = 0; named && i < sides.size(); i++) {
      head(sides.get(i), left(i));
      place(i, head);
      exits(sides.get(i).courses);
      svg.append("</g>\n");
    }
    if (named) {
      put("<text class='foot' x='%.0f' y='%.0f'>", GAP, head + height + GAP + 12);
      svg.append(foot(sides)).append("</text>\n");
    }
    return svg.append("</svg>\n").toString();
  }

  /** What one has to know to read several sides. */
  private String foot(List<Side> sides) {
    int frames = (int) sides.get(0).courses.duration();
    double slower = seconds * FRAMES_A_SECOND / frames;
    return (slower > 1 ? plain(slower, 1) + " times slower. " : "")
        + (scene.collide() ? "" : "Circles ignore each other. ")
        + "Orange: lost through a line or a wall; in the end "
        + sides.stream()
            .map(side -> String.valueOf(side.courses.lostUntil(frames)))
            .collect(Collectors.joining(" and ", "", "."));
  }

  private static double left(int side) {
    return GAP + side * (WIDTH + GAP);
  }

  /** Begins a group whose coordinates are those of the scene. */
  private void place(int side, double top) {
    double scale = WIDTH / extent.getWidth();
    put(
        "<g clip-path='url(#side)'"
            + " transform='translate(%.0f,%.0f) scale(%s,-%s) translate(%s,%s)'>%n",
        left(side),
        top,
        plain(scale, 6),
        plain(scale, 6),
        number(-extent.getX()),
        number(-extent.getMaxY()));
  }

  private void put(String format, Object... values) {
    svg.append(String.format(Locale.ROOT, format, values));
  }

  /** The name, and the counter: one text for each of its numbers, of which one is seen. */
  private void head(Side side, double left) {
    put("<text x='%.0f' y='32'>%s</text>%n", left, text(side.name));
    Map<Integer, Integer> since = new TreeMap<>();
    int frames = (int) side.courses.duration();
    for (int frame = 0; frame <= frames; frame++) {
      since.putIfAbsent(side.courses.lostUntil(frame), frame);
    }
    for (Map.Entry<Integer, Integer> count : since.entrySet()) {
      int lost = count.getKey();
      String style = lost > 0 ? " class='bad'" : "";
      String seen = lost < side.courses.lostUntil(frames) ? " opacity='0'" : "";
      put("<text x='%.0f' y='32' text-anchor='end'%s%s>", left + WIDTH, style, seen);
      put("%d of %d lost", lost, side.courses.circles());
      double from = count.getValue() / side.courses.duration();
      double to =
          since.entrySet().stream()
              .filter(other -> other.getKey() > lost)
              .mapToDouble(other -> other.getValue() / side.courses.duration())
              .min()
              .orElse(1);
      if (since.size() > 1) {
        discrete("opacity", "0;1;0", "0;" + share(from) + ";" + share(to));
      }
      svg.append("</text>\n");
    }
  }

  private void discrete(String attribute, String values, String times) {
    put(
        "<animate attributeName='%s' dur='%ss' repeatCount='indefinite' calcMode='discrete'"
            + " values='%s' keyTimes='%s'/>",
        attribute, seconds, values, times);
  }

  private void obstacles(double duration) {
    if (scene.bounds().isPresent()) {
      Bounds b = scene.bounds().get();
      Rectangle2D walls = new Rectangle2D.Double();
      walls.setFrameFromDiagonal(
          Math.max(b.xmin(), extent.getMinX()),
          Math.max(b.ymin(), extent.getMinY()),
          Math.min(b.xmax(), extent.getMaxX()),
          Math.min(b.ymax(), extent.getMaxY()));
      svg.append(rectangle(" class='floor'", walls)).append('\n');
      put("<path class='ink' d='%s'/>%n", wall(b));
    }
    for (int i = 0; i < scene.count(Kind.LINE); i++) {
      Obstacle shape = scene.shape(Kind.LINE, i);
      boolean solid = shape instanceof Outline outline && outline.solid();
      put("<path class='ink%s' d='%s'", solid ? " solid" : "", path(shape));
      moves(scene.velocity(Kind.LINE, i), duration);
      svg.append("</path>\n");
    }
    for (int i = 0; i < scene.count(Kind.PEG); i++) {
      Circle peg = (Circle) scene.shape(Kind.PEG, i);
      put(
          "<circle class='solid' cx='%s' cy='%s' r='%s'",
          number(peg.x()), number(peg.y()), number(peg.radius()));
      moves(scene.velocity(Kind.PEG, i), duration);
      svg.append("</circle>\n");
    }
  }

  private String rectangle(String attributes, Rectangle2D r) {
    return "<rect%s x='%s' y='%s' width='%s' height='%s'/>"
        .formatted(
            attributes,
            number(r.getX()),
            number(r.getY()),
            number(r.getWidth()),
            number(r.getHeight()));
  }

  private String wall(Bounds b) {
    return "M%s,%sH%sV%sH%sZ"
        .formatted(
            number(b.xmin()),
            number(b.ymin()),
            number(b.xmax()),
            number(b.ymax()),
            number(b.xmin()));
  }

  private String path(Obstacle shape) {
    List<Vec2> points =
        shape instanceof Line line
            ? List.of(new Vec2(line.ax(), line.ay()), new Vec2(line.bx(), line.by()))
            : ((Outline) shape).points();
    String ends = shape instanceof Outline outline && outline.solid() ? "Z" : "";
    return points.stream()
        .map(point -> number(point.x()) + "," + number(point.y()))
        .collect(Collectors.joining("L", "M", ends));
  }

  /** Ends a tag. */
  private void moves(Vec2 velocity, double duration) {
    if (velocity.length() > 0) {
      String end = number(velocity.x() * duration) + " " + number(velocity.y() * duration);
      put(
          " transform='translate(%s)'><animateTransform attributeName='transform' type='translate'"
              + " dur='%ss' repeatCount='indefinite' from='0 0' to='%s'/>",
          end, seconds, end);
    } else {
      svg.append('>');
    }
  }

  private void circles(Courses courses) {
    svg.append("<g class='c' fill='#56b4e9'>\n"); // no rule of a style may hide its change
    for (int i = 0; i < courses.circles(); i++) {
      Vec2 end = courses.at(i, courses.duration());
      put(
          "<circle cx='%s' cy='%s' r='%s'%s>",
          number(end.x()),
          number(end.y()),
          number(((Circle) scene.shape(Kind.CIRCLE, i)).radius()),
          courses.lost(i).isPresent() ? " fill='#d55e00'" : "");
      flight("cx", courses.x(i));
      flight("cy", courses.y(i));
      if (courses.lost(i).isPresent()) {
        double at = courses.lost(i).getAsInt() / courses.duration();
        discrete("fill", "#56b4e9;#d55e00", "0;" + share(at));
      }
      svg.append("</circle>\n");
    }
    svg.append("</g>\n");
  }

  /** What left the picture stays at its edge, so that all that are lost can be counted. */
  private void exits(Courses courses) {
    for (int i = 0; i < courses.circles(); i++) {
      if (courses.lost(i).isPresent()) {
        exit(courses, i, ((Circle) scene.shape(Kind.CIRCLE, i)).radius());
      }
    }
  }

  private void exit(Courses courses, int i, double radius) {
    int end = (int) courses.duration();
    int out = end + 1;
    while (out > 0 && isOutside(courses.at(i, out - 1), radius)) {
      out--;
    }
    if (out <= end) {
      Vec2 at = courses.at(i, out);
      double x = Math.max(extent.getMinX(), Math.min(extent.getMaxX(), at.x()));
      double y = Math.max(extent.getMinY(), Math.min(extent.getMaxY(), at.y()));
      put("<circle class='gone' cx='%s' cy='%s' r='%s'>", number(x), number(y), number(radius));
      discrete("opacity", "0;1", "0;" + share(out / courses.duration()));
      svg.append("</circle>\n");
    }
  }

  private boolean isOutside(Vec2 at, double radius) {
    return at.x() < extent.getMinX() - radius
        || at.x() > extent.getMaxX() + radius
        || at.y() < extent.getMinY() - radius
        || at.y() > extent.getMaxY() + radius;
  }

  private void flight(String attribute, List<Courses.Key> keys) {
    if (keys.size() < 2 || keys.stream().mapToDouble(Courses.Key::p).distinct().count() == 1) {
      return;
    }
    double end = keys.get(keys.size() - 1).t();
    put("<animate attributeName='%s' dur='%ss' repeatCount='indefinite'", attribute, seconds);
    put(" keyTimes='%s'", joined(keys, key -> share(key.t() / end)));
    put(" values='%s'", joined(keys, key -> number(key.p())));
    if (keys.stream().anyMatch(key -> key.a() != 0)) {
      put(" calcMode='spline' keySplines='%s'", splines(keys));
    }
    svg.append("/>");
  }

  /** A piece of a parabola without a turn: the share of its way against that of its time. */
  private static String splines(List<Courses.Key> keys) {
    StringBuilder text = new StringBuilder();
    for (int i = 1; i < keys.size(); i++) {
      Courses.Key from = keys.get(i - 1);
      double duration = keys.get(i).t() - from.t();
      double sum = 2 * from.v() + from.a() * duration; // twice the mean velocity
      double first = from.a() == 0 || sum == 0 ? 1.0 / 3 : 2 * from.v() / (3 * sum);
      double last =
          from.a() == 0 || sum == 0
              ? 2.0 / 3
              : 1 - 2 * (from.v() + from.a() * duration) / (3 * sum);
      text.append(i == 1 ? "" : ";").append(".333 ").append(within(first));
      text.append(" .667 ").append(within(last));
    }
    return text.toString();
  }

  private static String within(double share) {
    return plain(Math.max(0, Math.min(1, share)), 3);
  }

  private static String joined(List<Courses.Key> keys, Function<Courses.Key, String> text) {
    return keys.stream().map(text).collect(Collectors.joining(";"));
  }

  private static String share(double share) {
    return plain(share, 5);
  }

  private String number(double x) {
    return plain(x, digits);
  }

  static String plain(double x, int digits) {
    BigDecimal rounded = BigDecimal.valueOf(x).setScale(digits, RoundingMode.HALF_EVEN);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  private static String text(String plain) {
    return plain.replace("&", "&amp;").replace("<", "&lt;");
  }
}
