// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;

/** All kinds of queries: those of the committed cases, whole-number lattices, and walls. */
public final class Families {
  private Families() {}

  public static List<Family> all() {
    return List.of(
        new Family("seg_uniform", SegmentFamilies::uniform),
        new Family("seg_near_graze", SegmentFamilies::nearGraze),
        new Family("seg_voronoi_edge", SegmentFamilies::voronoiEdge),
        new Family("seg_start_touching", SegmentFamilies::startTouching),
        new Family("seg_start_overlapping", SegmentFamilies::startOverlapping),
        new Family("seg_start_on_line", SegmentTies::startOnLine),
        new Family("seg_fast", SegmentFamilies::fast),
        new Family("seg_slow", SegmentFamilies::slow),
        new Family("seg_shallow", SegmentFamilies::shallow),
        new Family("seg_far", SegmentFamilies::far),
        new Family("seg_tiny_scale", d -> SegmentFamilies.scaled(d, 1e-12, 1e-5)),
        new Family("seg_huge_scale", d -> SegmentFamilies.scaled(d, 1e8, 1e15)),
        new Family("seg_radius_zero", SegmentFamilies::radiusZero),
        new Family("seg_radius_small", d -> SegmentFamilies.radius(d, 1e-15, 1e-2)),
        new Family("seg_radius_large", d -> SegmentFamilies.radius(d, 1e3, 1e12)),
        new Family("seg_segment_short", SegmentFamilies::segmentShort),
        new Family("seg_collinear", SegmentTies::collinear),
        new Family("seg_parallel_at_r", SegmentTies::parallelAtRadius),
        new Family("seg_window_end", SegmentFamilies::windowEnd),
        new Family("seg_tie_plus_tiny", SegmentTies::tiePlusTiny),
        new Family("seg_extreme_magnitude", SegmentFamilies::extremeMagnitude),
        new Family("seg_poster_cases", SegmentFamilies::posterCases),
        new Family("seg_lattice", SegmentTies::lattice),
        new Family("seg_near_tie_end", NearTies::end),
        new Family("seg_near_tie_side", NearTies::side),
        new Family("seg_near_tie_corner", NearTies::corner),
        new Family("circ_uniform", PairFamilies::uniform),
        new Family("circ_near_graze", PairFamilies::nearGraze),
        new Family("circ_touching", PairFamilies::touching),
        new Family("circ_overlapping", PairFamilies::overlapping),
        new Family("circ_concentric", PairFamilies::concentric),
        new Family("circ_same_velocity", PairFamilies::sameVelocity),
        new Family("circ_head_on", PairFamilies::headOn),
        new Family("circ_fast", PairFamilies::fast),
        new Family("circ_far", PairFamilies::far),
        new Family("circ_size_ratio", PairFamilies::sizeRatio),
        new Family("circ_extreme_magnitude", PairFamilies::extremeMagnitude),
        new Family("circ_lattice", PairFamilies::lattice),
        new Family("circ_near_tie", NearTies::pair),
        new Family("wall_uniform", WallFamilies::uniform),
        new Family("wall_touching", WallFamilies::touching),
        new Family("wall_far", WallFamilies::far),
        new Family("wall_window_end", WallFamilies::windowEnd),
        new Family("wall_extreme", WallFamilies::extreme),
        new Family("wall_lattice", WallFamilies::lattice),
        new Family("wall_corner", WallFamilies::corner));
  }

  /** The kinds of queries about a line that moves. */
  public static List<Family> ofMovingLines() {
    return all().stream()
        .filter(family -> family.name().startsWith("seg_"))
        .map(MovingLineQuery::of)
        .toList();
  }
}
