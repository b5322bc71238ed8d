// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SoakCommandTest {

  @Test
  void tellsWhatMustNotHappenAndWhatMustStay() {
    Cli run = Cli.run("soak", "--impacts", 100_000, "--gas", "--circles", 60, "--seed", 2);

    assertThat(run.exitCode()).isZero();
    assertThat(run.out().lines())
        .satisfiesExactly(
            line -> assertThat(line).isEqualTo("soak       --gas --circles 60 --seed 2"),
            line -> assertThat(line).matches("impacts    100,\\d{3}, to time [\\d,]+"),
            line -> assertThat(line).isEqualTo("escapes    0 circles outside of the bounds"),
            line ->
                assertThat(line)
                    .isEqualTo("crossings  0 flights through a line, 0 pairs inside of each other"),
            line ->
                assertThat(line)
                    .matches(
                        "energy     changed by -?\\d\\.\\de-\\d+ of itself, at most 1e-11 expected"),
            line ->
                assertThat(line)
                    .matches("heap       [\\d,]+ KiB in use at the start, [\\d,]+ KiB at the end"),
            line ->
                assertThat(line).startsWith("CPU time   ").contains(" ns per impact at the start"));
    assertThat(run.err().lines()).hasSize(20).last().asString().isEqualTo("round 20 of 20");
  }

  @Test
  void refusesWhatIsNoSoak() {
    assertThat(Cli.run("soak", "--impacts", 10).err())
        .contains("--impacts is 10: expected at least 100000");
    assertThat(Cli.run("soak", "--circles", 0).err()).contains("circles is 0: expected at least 1");
    assertThat(Cli.run("soak", "--circles", 0).exitCode()).isEqualTo(2);
    assertThat(Cli.run("soak", "--scene", "heaps").err())
        .contains(
            "'heaps' is none of [trapped, pockets, masses, doors, heap, bumpers, fall, pile, plinko]");
    assertThat(Cli.run("soak", "--scene", "heap", "--gas").err())
        .contains("--scene and --gas exclude each other");
    assertThat(Cli.run("soak", "--scene", "heap", "--circles", 9).exitCode()).isEqualTo(2);
  }
}
