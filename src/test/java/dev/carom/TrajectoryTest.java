// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TrajectoryTest {

  /** A point between two posts at x = 0 and x = 10: right, left, right. */
  private static final Trajectory BETWEEN_POSTS =
      new Trajectory(
          List.of(
              new Flight(0, 5, 1, 5, 0, 0, 0),
              new Flight(1, 10, 1, -5, 0, 0, 0),
              new Flight(3, 0, 1, 5, 0, 0, 0)),
          List.of(post(1, 10, -1), post(3, 0, 1)),
          4,
          true);

  private static Impact post(double time, double x, double normal) {
    return new Impact(
        time, -1, Kind.PEG, 0, 0, Feature.CIRCLE, x, 1, normal, 0, 5, 10, Outcome.BOUNCED);
  }

  @Test
  void placesBetweenImpacts() {
    assertThat(BETWEEN_POSTS.at(0)).isEqualTo(new Vec2(5, 1));
    assertThat(BETWEEN_POSTS.at(0.5)).isEqualTo(new Vec2(7.5, 1));
    assertThat(BETWEEN_POSTS.at(2)).isEqualTo(new Vec2(5, 1));
    assertThat(BETWEEN_POSTS.at(3.5)).isEqualTo(new Vec2(2.5, 1));
    assertThat(BETWEEN_POSTS.end()).isEqualTo(new Vec2(5, 1));
  }

  @Test
  void theVelocityAtAnImpactIsTheOneAfterIt() {
    assertThat(BETWEEN_POSTS.velocityAt(Math.nextDown(1.0))).isEqualTo(new Vec2(5, 0));
    assertThat(BETWEEN_POSTS.velocityAt(1)).isEqualTo(new Vec2(-5, 0));
    assertThat(BETWEEN_POSTS.velocityAt(3)).isEqualTo(new Vec2(5, 0));
    assertThat(BETWEEN_POSTS.velocityAt(4)).isEqualTo(new Vec2(5, 0));
  }

  /** In a corner two impacts share one moment; the flight between them lasts no time. */
  @Test
  void ofFlightsThatStartTogetherTheLastCounts() {
    Trajectory corner =
        new Trajectory(
            List.of(
                new Flight(0, 1, 1, -1, -1, 0, 0),
                new Flight(1, 0, 0, 1, -1, 0, 0),
                new Flight(1, 0, 0, 1, 1, 0, 0)),
            List.of(post(1, 0, 1), post(1, 0, 1)),
            2,
            true);
    assertThat(corner.velocityAt(1)).isEqualTo(new Vec2(1, 1));
    assertThat(corner.velocityAt(0.5)).isEqualTo(new Vec2(-1, -1));
    assertThat(corner.end()).isEqualTo(new Vec2(1, 1));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 7, 64, 100})
  void findsEachOfManyFlights(int count) {
    List<Flight> flights = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      flights.add(new Flight(i, i, 0, 1, i, 0, 0));
    }
    Trajectory trajectory = new Trajectory(flights, List.of(), count, true);
    for (int i = 0; i < count; i++) {
      assertThat(trajectory.velocityAt(i)).isEqualTo(new Vec2(1, i));
      assertThat(trajectory.velocityAt(i + 0.5)).isEqualTo(new Vec2(1, i));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, -Double.MIN_VALUE, 4.000001, Double.POSITIVE_INFINITY})
  void refusesTimesOutsideOfIt(double t) {
    String message = "t is " + t + ": expected a time from 0 to the trajectory's duration, 4.0";
    assertThatIllegalArgumentException().isThrownBy(() -> BETWEEN_POSTS.at(t)).withMessage(message);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> BETWEEN_POSTS.velocityAt(t))
        .withMessage(message);
  }

  @Test
  void keepsItsOwnCopies() {
    List<Flight> flights = new ArrayList<>(List.of(new Flight(0, 0, 0, 1, 0, 0, 0)));
    List<Impact> impacts = new ArrayList<>();
    Trajectory trajectory = new Trajectory(flights, impacts, 1, false);
    flights.clear();
    impacts.add(post(1, 0, 1));
    assertThat(trajectory.points()).containsExactly(new Vec2(0, 0), new Vec2(1, 0));
    assertThat(trajectory.impacts()).isEmpty();
    assertThatThrownBy(() -> trajectory.impacts().clear())
        .isInstanceOf(UnsupportedOperationException.class);
  }

  @Test
  void equalsWhatHoldsTheSame() {
    List<Flight> flights = List.of(new Flight(0, 0, 0, 1, 0, 0, 0));
    Trajectory path = new Trajectory(flights, List.of(), 2, true);
    assertThat(path.duration()).isEqualTo(2);
    assertThat(path.complete()).isTrue();
    Trajectory same = new Trajectory(flights, List.of(), 2, true);
    assertThat(path).isEqualTo(same).hasSameHashCodeAs(same).isNotEqualTo("path");
    List<Flight> others = List.of(new Flight(0, 1, 0, 1, 0, 0, 0));
    assertThat(path)
        .isNotEqualTo(new Trajectory(others, List.of(), 2, true))
        .isNotEqualTo(new Trajectory(flights, List.of(post(1, 0, 1)), 2, true))
        .isNotEqualTo(new Trajectory(flights, List.of(), 3, true))
        .isNotEqualTo(new Trajectory(flights, List.of(), 2, false))
        .doesNotHaveSameHashCodeAs(new Trajectory(flights, List.of(), 3, true));
  }

  @Test
  void saysWhatItIsInOneLine() {
    Trajectory way =
        Resolver.of(List.of(new Line(5, -9, 5, 9)))
            .trace(new SweptCircle(new Circle(0, 0, 1), new Vec2(1, 0)), 1, 8, Integer.MAX_VALUE);
    assertThat(way).hasToString("Trajectory[duration=8.0, impacts=1, complete=true]");
  }
}
