// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.charts;

import dev.carom.Bounds;
import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Obstacle;
import dev.carom.Outline;
import dev.carom.Response;
import dev.carom.Vec2;
import dev.carom.World;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/**
 * What is seen of a world while somebody plays: its things as they are at equal steps of time, and
 * straight on between. Things may come, move, turn and go. Where nothing moves, the end is seen.
 * {@link Motion} is exact, but knows a scene that nobody changes only.
 */
public final class Film {

  /** What is off by less, as a part of the picture's width, cannot be seen. */
  private static final double VISIBLE = 5e-4;

  private static final int WIDTH = 420;
  private static final int MARGIN = 6;
  private static final int TINTS = 4;

  private static final String STYLE =
      """
      <style>
      .paper{fill:#faf9f5}.ink,.floor{stroke:#22262b;stroke-width:1.5;stroke-linecap:round;vector-effect:non-scaling-stroke}
      .ink{fill:none}.floor{fill:#fff}.gap{stroke-dasharray:3 5}.solid{fill:#22262b}
      .t0{fill:#d55e00}.t1{fill:#0072b2}.t2{fill:#009e73}.t3{fill:#e69f00}
      @media(prefers-color-scheme:dark){.paper{fill:#1b1d21}.floor{fill:#24272c}.ink,.floor{stroke:#e8e6e1}.solid{fill:#e8e6e1}
      .t0{fill:#f2803a}.t1{fill:#56b4e9}.t2{fill:#2fc79a}.t3{fill:#f0b93a}}
      </style>
      """;

  private final Rectangle2D extent;
  private final double scale;
  private final double seconds;
  private final Map<Kind, Map<Integer, Track>> tracks = new TreeMap<>();
  private final Bounds bounds;
  private int frames;

  /** One thing: its numbers at each step from the first at which it is there. */
  private static final class Track {

    final int first;
    final String start;
    final List<String> names;
    final List<double[]> places = new ArrayList<>();

    Track(int first, String start, List<String> names) {
      this.first = first;
      this.start = start;
      this.names = names;
    }
  }

  /**
   * A film without frames.
   *
   * @param world whose scene tells what part of the plane is seen
   * @param seconds from one frame to the next, greater than 0
   */
  public Film(World world, double seconds) {
    extent = SceneExtent.of(world.scene());
    bounds = world.scene().bounds().orElse(null);
    scale = WIDTH / extent.getWidth();
    this.seconds = seconds;
  }

  /** Adds a frame: a world as it is now. */
  public void add(World world) {
    for (Kind kind : List.of(Kind.LINE, Kind.PEG, Kind.CIRCLE)) {
      for (int id : world.ids(kind)) {
        Obstacle shape = world.shape(kind, id);
        Map<Integer, Track> those = tracks.computeIfAbsent(kind, k -> new TreeMap<>());
        those.computeIfAbsent(id, k -> track(world, kind, k)).places.add(numbers(shape));
      }
    }
    frames++;
  }

  private Track track(World world, Kind kind, int id) {
    Obstacle shape = world.shape(kind, id);
    boolean isSensor = world.traits(kind, id).response() == Response.SENSOR;
    String tint = "t" + id % TINTS;
    if (shape instanceof Circle circle) {
      String style = kind == Kind.PEG ? "solid" : isSensor ? "ink gap" : tint;
      String start = "circle class='%s' r='%s'".formatted(style, number(scale * circle.radius()));
      return new Track(frames, start, List.of("cx", "cy"));
    }
    if (shape instanceof Line) {
      String start = "line class='" + (isSensor ? "ink gap" : "ink") + "'";
      return new Track(frames, start, List.of("x1", "y1", "x2", "y2"));
    }
    boolean isSolid = ((Outline) shape).solid();
    String start = isSolid ? "polygon class='" + tint + "'" : "polyline class='ink'";
    return new Track(frames, start, List.of("points"));
  }

  /** The numbers of a shape, in pixels of the picture. */
  private double[] numbers(Obstacle shape) {
    List<Vec2> points =
        shape instanceof Circle circle
            ? List.of(new Vec2(circle.x(), circle.y()))
            : shape instanceof Line line
                ? List.of(new Vec2(line.ax(), line.ay()), new Vec2(line.bx(), line.by()))
                : ((Outline) shape).points();
    return points.stream().flatMapToDouble(p -> DoubleStream.of(x(p.x()), y(p.y()))).toArray();
  }

  private double x(double x) {
    return MARGIN + scale * (x - extent.getX());
  }

  private double y(double y) {
    return MARGIN + scale * (extent.getMaxY() - y);
  }

  /**
   * Draws it.
   *
   * @param title what it shows, for those who cannot see it
   * @return the text of an SVG file, which plays for ever
   */
  public String svg(String title) {
    StringBuilder svg = new StringBuilder();
    svg.append(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %.0f'><title>%s</title>%n%s"
            .formatted(WIDTH + 2 * MARGIN, scale * extent.getHeight() + 2 * MARGIN, title, STYLE));
    svg.append("<rect class='paper' width='100%' height='100%'/>\n");
    if (bounds != null) {
      svg.append(
          "<rect class='floor' x='%s' y='%s' width='%s' height='%s'/>%n"
              .formatted(
                  number(x(bounds.xmin())),
                  number(y(bounds.ymax())),
                  number(scale * (bounds.xmax() - bounds.xmin())),
                  number(scale * (bounds.ymax() - bounds.ymin()))));
    }
    tracks.values().stream()
        .map(Map::values)
        .flatMap(Collection::stream)
        .forEach(
            track -> {
              svg.append('<').append(track.start);
              draw(svg, track);
            });
    return svg.append("</svg>\n").toString();
  }

  private void draw(StringBuilder svg, Track track) {
    List<Integer> keys = keys(track.places);
    String name = track.start.substring(0, track.start.indexOf(' '));
    StringBuilder moves = new StringBuilder();
    for (int i = 0; i < track.names.size(); i++) {
      List<String> values = new ArrayList<>();
      for (int key : keys) {
        values.add(value(track, key, i));
      }
      svg.append(" %s='%s'".formatted(track.names.get(i), values.get(values.size() - 1)));
      if (values.stream().distinct().count() > 1) {
        moves.append(animate(track.names.get(i), track.first, keys, values));
      }
    }
    int end = track.first + track.places.size();
    if (end < frames) {
      svg.append(" opacity='0'");
    }
    if (track.first > 0 || end < frames) {
      moves.append(seen(track.first, end));
    }
    svg.append(moves.isEmpty() ? "/>" : ">" + moves + "</" + name + ">").append('\n');
  }

  private static String value(Track track, int key, int i) {
    double[] place = track.places.get(key);
    return track.names.size() > 1
        ? number(place[i])
        : Arrays.stream(place).mapToObj(Film::number).collect(Collectors.joining(" "));
  }

  private String animate(String name, int first, List<Integer> keys, List<String> values) {
    String times = keys.stream().map(k -> time(first + k)).collect(Collectors.joining(";"));
    String all = String.join(";", values);
    int last = first + keys.get(keys.size() - 1);
    return "<animate attributeName='%s' dur='%ss' repeatCount='indefinite' keyTimes='%s%s%s' values='%s%s%s'/>"
        .formatted(
            name,
            number(seconds * (frames - 1)),
            first > 0 ? "0;" : "",
            times,
            last < frames - 1 ? ";1" : "",
            first > 0 ? values.get(0) + ";" : "",
            all,
            last < frames - 1 ? ";" + values.get(values.size() - 1) : "");
  }

  private String seen(int first, int end) {
    boolean isLate = first > 0;
    boolean goes = end < frames;
    return "<animate attributeName='opacity' dur='%ss' repeatCount='indefinite' calcMode='discrete' keyTimes='0%s%s' values='%s%s%s'/>"
        .formatted(
            number(seconds * (frames - 1)),
            isLate ? ";" + time(first) : "",
            goes ? ";" + time(end) : "",
            isLate ? 0 : 1,
            isLate ? ";1" : "",
            goes ? ";0" : "");
  }

  /** The steps between which all numbers change evenly, as far as can be seen. */
  private static List<Integer> keys(List<double[]> places) {
    List<Integer> keys = new ArrayList<>(List.of(0));
    int last = places.size() - 1;
    int from = 0;
    for (int to = 2; to <= last; to++) {
      if (!isEven(places, from, to)) {
        from = to - 1;
        keys.add(from);
      }
    }
    if (last > 0) {
      keys.add(last);
    }
    return keys;
  }

  private static boolean isEven(List<double[]> places, int from, int to) {
    double[] a = places.get(from);
    double[] b = places.get(to);
    for (int k = from + 1; k < to; k++) {
      double share = (k - from) / (double) (to - from);
      for (int i = 0; i < a.length; i++) {
        if (Math.abs(a[i] + share * (b[i] - a[i]) - places.get(k)[i]) > VISIBLE * WIDTH) {
          return false;
        }
      }
    }
    return true;
  }

  private String time(int frame) {
    return Motion.plain(frame / (double) (frames - 1), 4);
  }

  private static String number(double x) {
    return Motion.plain(x, 1);
  }
}
