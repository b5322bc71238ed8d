// SPDX-License-Identifier: Apache-2.0
/**
 * The detector: when a moving disk first touches a line, a wall or a disk, and where. Plain doubles
 * with proven bounds answer nearly always. What their bounds leave open climbs to numbers without
 * rounding.
 *
 * <table>
 *   <caption>Where to find</caption>
 *   <tr><td>the equation of the gap of a line's side
 *       <td>{@link dev.carom.internal.exact.Gaps}; of a straight flight {@link
 *       dev.carom.internal.sweep.SideSweep}
 *   <tr><td>the bound of its error
 *       <td>{@link dev.carom.internal.exact.GapPolynomial}; of a straight flight {@code stepError}
 *       of {@link dev.carom.internal.sweep.SideSweep}
 *   <tr><td>where a window of time is halved
 *       <td>{@code search} of {@link dev.carom.internal.sweep.GapSearch}
 *   <tr><td>where numbers without rounding begin
 *       <td>{@code searched} of {@link dev.carom.internal.sweep.FallSweep}; of a straight flight
 *       {@code exactly} of {@link dev.carom.internal.exact.Predicates} for a decision, {@code
 *       settled} of {@code FallSweep} for a time
 *   <tr><td>where algebraic numbers begin, the last rung
 *       <td>{@code exact} of {@link dev.carom.internal.sweep.FallSweep}; of a straight flight {@link
 *       dev.carom.internal.exact.ExactSigns}, and {@link dev.carom.internal.exact.RealRoot} for a
 *       time
 *   <tr><td>the one-way rule, the rule of ties, the test of moving obstacles
 *       <td>the package {@link dev.carom.internal.search}
 * </table>
 */
package dev.carom.internal.sweep;
