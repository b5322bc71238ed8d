// SPDX-License-Identifier: Apache-2.0
package dev.carom.oracle;

import java.util.List;

/** All kinds of queries: those of the committed cases, whole-number lattices, and walls. */
public final class Families {
  private Families() {}

  public static List<Family<Query>> all() {
    return List.of(
        Family.mirrored("seg_uniform", SegmentFamilies::uniform),
        Family.mirrored("seg_near_graze", SegmentFamilies::nearGraze),
        Family.mirrored("seg_voronoi_edge", SegmentFamilies::voronoiEdge),
        Family.mirrored("seg_start_touching", SegmentFamilies::startTouching),
        Family.mirrored("seg_start_overlapping", SegmentFamilies::startOverlapping),
        Family.mirrored("seg_start_on_line", SegmentTies::startOnLine),
        Family.mirrored("seg_fast", SegmentFamilies::fast),
        Family.mirrored("seg_slow", SegmentFamilies::slow),
        Family.mirrored("seg_shallow", SegmentFamilies::shallow),
        Family.mirrored("seg_far", SegmentFamilies::far),
        Family.mirrored("seg_tiny_scale", d -> SegmentFamilies.scaled(d, 1e-12, 1e-5)),
        Family.mirrored("seg_huge_scale", d -> SegmentFamilies.scaled(d, 1e8, 1e15)),
        Family.mirrored("seg_radius_zero", SegmentFamilies::radiusZero),
        Family.mirrored("seg_radius_small", d -> SegmentFamilies.radius(d, 1e-15, 1e-2)),
        Family.mirrored("seg_radius_large", d -> SegmentFamilies.radius(d, 1e3, 1e12)),
        Family.mirrored("seg_segment_short", SegmentFamilies::segmentShort),
        Family.mirrored("seg_collinear", SegmentTies::collinear),
        Family.mirrored("seg_parallel_at_r", SegmentTies::parallelAtRadius),
        Family.mirrored("seg_window_end", SegmentFamilies::windowEnd),
        Family.mirrored("seg_tie_plus_tiny", SegmentTies::tiePlusTiny),
        Family.mirrored("seg_extreme_magnitude", SegmentFamilies::extremeMagnitude),
        Family.mirrored("seg_poster_cases", SegmentFamilies::posterCases),
        Family.mirrored("seg_lattice", SegmentTies::lattice),
        Family.mirrored("seg_near_tie_end", NearTies::end),
        Family.mirrored("seg_near_tie_side", NearTies::side),
        Family.mirrored("seg_near_tie_corner", NearTies::corner),
        Family.mirrored("circ_uniform", PairFamilies::uniform),
        Family.mirrored("circ_near_graze", PairFamilies::nearGraze),
        Family.mirrored("circ_touching", PairFamilies::touching),
        Family.mirrored("circ_overlapping", PairFamilies::overlapping),
        Family.mirrored("circ_concentric", PairFamilies::concentric),
        Family.mirrored("circ_same_velocity", PairFamilies::sameVelocity),
        Family.mirrored("circ_head_on", PairFamilies::headOn),
        Family.mirrored("circ_fast", PairFamilies::fast),
        Family.mirrored("circ_far", PairFamilies::far),
        Family.mirrored("circ_size_ratio", PairFamilies::sizeRatio),
        Family.mirrored("circ_extreme_magnitude", PairFamilies::extremeMagnitude),
        Family.mirrored("circ_lattice", PairFamilies::lattice),
        Family.mirrored("circ_near_tie", NearTies::pair),
        Family.mirrored("wall_uniform", WallFamilies::uniform),
        Family.mirrored("wall_touching", WallFamilies::touching),
        Family.mirrored("wall_far", WallFamilies::far),
        Family.mirrored("wall_window_end", WallFamilies::windowEnd),
        Family.mirrored("wall_extreme", WallFamilies::extreme),
        Family.mirrored("wall_lattice", WallFamilies::lattice),
        Family.mirrored("wall_corner", WallFamilies::corner));
  }

  /** The kinds of queries about a line that moves. */
  public static List<Family<Query>> ofMovingLines() {
    return all().stream()
        .filter(family -> family.name().startsWith("seg_"))
        .map(MovingLineQuery::of)
        .toList();
  }
}
