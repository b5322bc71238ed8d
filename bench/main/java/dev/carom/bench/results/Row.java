// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

/**
 * One measured number.
 *
 * @param scene what it was measured on: a scene ({@code base-1}), or a class of queries ({@code
 *     query:near-graze})
 * @param method the label of the method or peer
 * @param knob the setting, {@code name=value}; empty if the method has none
 * @param metric what was measured ({@code frame_time})
 * @param stat which number of it ({@code median}, {@code p95}; in series {@code median@120}, of
 *     frame 120)
 * @param value the number; NaN where the method failed to give one
 * @param unit its unit ({@code ns}, {@code radii}, {@code ulps}, {@code 1} for counts and ratios)
 * @param n how many values it stands for
 * @param fork the virtual machine it was measured in, from 0; -1 where it does not depend on that
 */
public record Row(
    String scene,
    String method,
    String knob,
    String metric,
    String stat,
    double value,
    String unit,
    long n,
    int fork) {}
