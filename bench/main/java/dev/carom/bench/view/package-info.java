// SPDX-License-Identifier: Apache-2.0

/**
 * A window on a scene: {@link dev.carom.bench.view.Player} holds the run and knows nothing of
 * windows, {@link dev.carom.bench.view.ViewPanel} shows it and hands on what the user does. In a
 * duel a second pane shows what another method makes of the same scene; {@link
 * dev.carom.bench.view.DuelMovie} draws both without a window.
 */
package dev.carom.bench.view;
