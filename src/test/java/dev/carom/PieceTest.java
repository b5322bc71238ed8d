// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What circles that are jammed together do as one. */
class PieceTest {

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** A time at which one ulp is 2: heads of times agree while tails differ. */
  private static final double LATE = 0x1p53;

  private final ImpactLog log = new ImpactLog(4);
  private final Mover[] circles = new Mover[3];

  /** A row of circles that touch, none of them jammed to another. */
  private Piece row(double... masses) {
    SceneBuilder scene = Scene.builder().collide(true);
    for (int i = 0; i < masses.length; i++) {
      scene.circle(2 * i, 0, 1, 0, 0).mass(masses[i]);
      circles[i] = new Mover();
      circles[i].start(i, 2 * i, 0, 1, 0, 0, 0);
    }
    Roster roster = new Roster(scene.build(), 1);
    return new Piece(
        roster, new PairResponse(roster, new ObstacleResponse(Obstacles.of(scene.build()), 1_000)));
  }

  private void jam(int i, int j) {
    circles[i].jam = Jam.with(circles[i].jam, Obstacles.CIRCLES + j);
    circles[j].jam = Jam.with(circles[j].jam, Obstacles.CIRCLES + i);
  }

  private void velocity(int i, double vx, double vy) {
    circles[i].vx = vx;
    circles[i].vy = vy;
  }

  private List<Mover> seize(Piece piece, int... hit) {
    Mover[] first = new Mover[hit.length];
    for (int i = 0; i < hit.length; i++) {
      first[i] = circles[hit[i]];
    }
    return piece.seize(id -> circles[id], log, first);
  }

  private void assertVelocities(double vx, double vy) {
    for (Mover m : circles) {
      assertThat(m.vx).isCloseTo(vx, within(1e-14));
      assertThat(m.vy).isCloseTo(vy, within(1e-14));
    }
  }

  @Test
  void theyGoOnWithTheirCommonMomentum() {
    Piece piece = row(1, 2, 3);
    jam(0, 1);
    jam(1, 2);
    velocity(0, 1, 2);
    velocity(1, 0, 4);
    velocity(2, 5, -6);
    assertThat(seize(piece, 0, 1)).containsExactly(circles);
    assertVelocities(16 / 6.0, -8 / 6.0);
    assertThat(circles[1].last).isEqualTo(Mover.NOTHING);
  }

  @Test
  void infiniteMassesTakeTheOthersAlong() {
    Piece piece = row(INFINITE, 2, INFINITE);
    jam(0, 1);
    jam(1, 2);
    velocity(0, 1, 0);
    velocity(1, 100, 100);
    velocity(2, 3, 4);
    seize(piece, 0, 1);
    assertVelocities(2, 2);
  }

  @Test
  void oneThatStopsStopsThemAll() {
    Piece piece = row(1, 2, INFINITE);
    jam(0, 1);
    jam(1, 2);
    circles[0].jam = Jam.with(circles[0].jam, Obstacles.LEFT);
    velocity(0, 1, 2);
    velocity(2, 5, -6);
    assertThat(seize(piece, 0)).containsExactly(circles);
    assertVelocities(0, 0);
    assertThat(circles[0].jam).isEqualTo(Jam.with(null, Obstacles.CIRCLES + 1));
  }

  /** Those that just hit each other stand in the log already. */
  @Test
  void theLogSaysThroughWhomEachCameToIt() {
    Piece piece = row(1, 1, 1);
    jam(0, 1);
    jam(1, 2);
    velocity(2, -5, 0);
    seize(piece, 0, 1);
    assertThat(log.size()).isOne();
    assertRow(1, 2, 5);
    log.clear();
    velocity(0, 3, 0);
    seize(piece, 1, 2);
    assertThat(log.size()).isOne();
    assertRow(0, 1, 3 + 5 / 3.0);
  }

  private void assertRow(int circle, int other, double speed) {
    assertThat(log.circle(0)).isEqualTo(circle);
    assertThat(log.kind(0)).isEqualTo(ObstacleKind.CIRCLE);
    assertThat(log.id(0)).isEqualTo(other);
    assertThat(log.approachSpeed(0)).isCloseTo(speed, within(1e-14));
    assertThat(log.jammed(0)).isTrue();
  }

  @Test
  void whoIsNotJammedInReturnIsNoPartOfIt() {
    Piece piece = row(1, 1, 1);
    jam(0, 1);
    circles[1].jam = Jam.with(circles[1].jam, Obstacles.CIRCLES + 2);
    assertThat(seize(piece, 0, 1)).containsExactly(circles[0], circles[1]);
    circles[2].jam = Jam.with(null, Obstacles.CIRCLES);
    assertThat(seize(piece, 0, 1)).containsExactly(circles[0], circles[1]);
    assertThat(log.size()).isZero();
  }

  /** Its flight began earlier; it moved since, by less than counts. */
  @Test
  void whoHardlyMovedIsBroughtToTheSameTime() {
    Piece piece = row(1, 1, 1);
    jam(0, 1);
    jam(1, 2);
    for (int i = 0; i < 3; i++) {
      circles[i].t = LATE;
      circles[i].tl = i < 2 ? 0.5 : -0.5;
    }
    double way = 2 * Math.ulp(4.0);
    velocity(2, way, 0);
    assertThat(seize(piece, 0, 1)).hasSize(3);
    assertThat(circles[2].x).isEqualTo(4 + way);
    assertThat(circles[2].t).isEqualTo(LATE);
    assertThat(circles[2].tl).isEqualTo(0.5);
  }

  @Test
  void whoLeftItsPlaceIsNoPartOfIt() {
    Piece piece = row(1, 1, 1);
    jam(0, 1);
    jam(1, 2);
    circles[2].t = -1;
    velocity(2, 1, 0);
    assertThat(seize(piece, 0, 1)).hasSize(2);
    assertThat(circles[2].vx).isOne();
  }

  /** In no time it cannot leave it, wherever its impacts began to count. */
  @Test
  void whoseClockStandsStillIsPartOfIt() {
    Piece piece = row(1, 1, 1);
    jam(0, 1);
    jam(1, 2);
    circles[2].anchorX = 7;
    assertThat(seize(piece, 0, 1)).hasSize(3);
  }
}
