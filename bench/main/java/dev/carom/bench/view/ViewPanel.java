// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import dev.carom.Scene;
import dev.carom.bench.duel.Duel;
import dev.carom.bench.duel.Preset;
import dev.carom.bench.duel.Rival;
import dev.carom.bench.reference.Reference;
import dev.carom.bench.view.ScenePainter.Layer;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;

/**
 * A player with its buttons: what stands in the window. Space runs and pauses, the right arrow goes
 * on by one frame, I by one impact; all keys are told by {@link #keys}.
 */
public final class ViewPanel extends JPanel {

  private static final long serialVersionUID = 1;

  /** Positions of the slider of time. */
  private static final int SLIDER = 10_000;

  /** Steps of the slider of speed in a factor of ten. */
  private static final int DECADE = 100;

  private static final int DECADES = 3;

  private static final double CLOSER = 1.5;

  /** Earth's gravity, in heights of the view a frame squared: 2 / 120^2. */
  private static final double FALL = 2.0 / 14_400;

  /** Earth's gravity, as a multiple of the moon's. */
  private static final double MOON = 6;

  /** Frames a tick that slow engines still keep up with. */
  private static final double MOST_IN_DUEL = 10;

  /** Among the rivals: nobody. */
  private static final String ALONE = "nobody";

  /** The width of the sliders in the tool bar, in pixels. */
  private static final int SLIDER_WIDTH = 80;

  private final transient Player player;
  private final SceneCanvas canvas;
  private final transient Arena arena;
  private final JPanel panes = new JPanel(new GridLayout(1, 0, 1, 0));
  private final RivalPane rivalPane;
  private final ScorePane scorePane;
  private final JComboBox<Object> rivals = new JComboBox<>();
  private final transient List<KeyAction> keys = new ArrayList<>();
  private final JPanel bar = new JPanel(new WrapLayout(6, 4));
  private final JButton run = new JButton();
  private final JSlider time = new JSlider(0, SLIDER, 0);
  private final JSlider speed = new JSlider(-DECADES * DECADE, DECADES * DECADE, 0);
  private final JLabel factor = new JLabel();
  private final JSlider gravity = new JSlider(0, 100, 0);
  private final JPanel layers = new JPanel(new WrapLayout(6, 0));
  private final JPanel foot = new JPanel(new BorderLayout());
  private final JPanel duels = new JPanel(new WrapLayout(6, 4));
  private final JLabel status = new JLabel(" ");
  private transient Consumer<String> titled = title -> {};
  private boolean refreshing;
  private String message = "";

  /**
   * Makes the panel.
   *
   * @param player what it shows
   */
  public ViewPanel(Player player) {
    super(new BorderLayout());
    this.player = player;
    canvas = new SceneCanvas(player, this::told);
    arena = new Arena(player);
    rivalPane = new RivalPane(arena, canvas);
    scorePane = new ScorePane(arena, canvas);
    makeBar();
    panes.add(canvas);
    add(bar, BorderLayout.NORTH);
    add(panes, BorderLayout.CENTER);
    add(foot(), BorderLayout.SOUTH);
    refresh();
  }

  /** Nothing takes the focus, so that the keys always reach the panel. */
  private void makeBar() {
    addButton(run, ToolIcon.RUN, key("SPACE", "Space", "Run", "Run or pause", this::toggleRunning));
    addButton(
        new JButton(),
        ToolIcon.FRAME,
        key("RIGHT", "Right", "Frame", "Go on by one frame", player::stepFrame));
    addButton(
        new JButton(),
        ToolIcon.IMPACT,
        key("I", "I", "Impact", "Go on to the next impact", this::nextImpact));
    addButton(
        new JButton(),
        ToolIcon.RESTART,
        key("R", "R", "Restart", "Begin again with the scene as it was loaded", player::restart));
    key("LEFT", "Left", "Back", "Go back by one frame", this::stepBack);
    addSpeed();
    addGravity();
    addRivals();
    addTools();
    addLayers();
    JButton fit = new JButton();
    addButton(fit, ToolIcon.FIT, key("0", "0", "Fit", "Show the whole scene", this::fit));
    fit.setText("");
    fit.setName("Fit");
    key("PLUS", "+", "Closer", "Enlarge; so does the wheel", () -> canvas.zoom(CLOSER));
    alias("EQUALS", "ADD", "shift EQUALS");
    key("MINUS", "-", "Farther", "Make smaller; so does the wheel", () -> canvas.zoom(1 / CLOSER));
    alias("SUBTRACT");
    key("W", "W", "Weight", "Change gravity: none, as on the moon, as on Earth", this::weigh);
    key("DELETE", "Delete", "Delete", "Delete what is under the mouse", canvas::deleteUnderMouse);
    alias("BACK_SPACE");
    bar.addComponentListener(new Rewrap(this));
  }

  private KeyAction key(String key, String label, String name, String tip, Runnable action) {
    KeyAction made = KeyAction.of(key, label, name, tip, () -> act(action));
    keys.add(made);
    bind(key, made.action());
    return made;
  }

  /** Further keys for the last action. */
  private void alias(String... more) {
    for (String key : more) {
      bind(key, keys.get(keys.size() - 1).action());
    }
  }

  private void bind(String key, Runnable action) {
    getInputMap(WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
    getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1;

              @Override
              public void actionPerformed(ActionEvent e) {
                action.run();
              }
            });
  }

  private void addButton(AbstractButton button, ToolIcon icon, KeyAction action) {
    button.setText(action.name());
    button.setIcon(icon);
    button.setToolTipText(action.hint());
    button.setFocusable(false);
    button.addActionListener(event -> action.action().run());
    bar.add(button);
  }

  private void addSpeed() {
    speed.setFocusable(false);
    speed.setName("Speed");
    speed.setPreferredSize(new Dimension(SLIDER_WIDTH, speed.getPreferredSize().height));
    speed.setToolTipText("How fast it runs, from 1/1000 to 1000 times (Up and Down)");
    speed.addChangeListener(event -> setSpeed());
    bar.add(new JLabel("Speed"));
    bar.add(speed);
    bar.add(factor);
    setSpeed();
    factor.setPreferredSize(new JLabel("1/1000 ").getPreferredSize());
    key("UP", "Up", "Faster", "Run faster", () -> speed.setValue(speed.getValue() + DECADE / 4));
    key(
        "DOWN",
        "Down",
        "Slower",
        "Run slower",
        () -> speed.setValue(speed.getValue() - DECADE / 4));
  }

  private void addGravity() {
    gravity.setFocusable(false);
    gravity.setName("Gravity");
    gravity.setPreferredSize(new Dimension(SLIDER_WIDTH, gravity.getPreferredSize().height));
    gravity.setToolTipText("How strongly circles fall, from not at all to as on Earth (W)");
    gravity.addChangeListener(
        event -> {
          if (!refreshing) {
            act(() -> player.setGravity(0, -full() * gravity.getValue() / gravity.getMaximum()));
          }
        });
    bar.add(new JLabel("Gravity"));
    bar.add(gravity);
  }

  private void setSpeed() {
    double chosen = Math.pow(10, speed.getValue() / (double) DECADE);
    double value = arena.isOpen() ? Math.min(MOST_IN_DUEL, chosen) : chosen;
    player.setSpeed(value);
    factor.setText(value < 1 ? "1/" + rounded(1 / value) : rounded(value));
  }

  private static String rounded(double x) {
    return String.format(Locale.ROOT, x < 10 && Math.rint(x) != x ? "%.1f" : "%.0f", x);
  }

  private void addRivals() {
    rivals.addItem(ALONE);
    for (Rival rival : Rival.values()) {
      rivals.addItem(rival);
    }
    rivals.setFocusable(false);
    rivals.setToolTipText("Choose a method that plays the same scene, from the moment shown (B)");
    rivals.addActionListener(event -> act(this::begin));
    // A frame of the engines is one unit of time.
    rivals.setEnabled(player.frame() == 1);
    bar.add(new JLabel("Against"));
    bar.add(rivals);
    key("B", "B", "Against", "Play beside the next method", this::nextRival);
  }

  private void nextRival() {
    if (rivals.isEnabled()) {
      rivals.setSelectedIndex((rivals.getSelectedIndex() + 1) % rivals.getItemCount());
    }
  }

  private void begin() {
    Rival rival = rivals.getSelectedItem() instanceof Rival chosen ? chosen : null;
    if (rival != null) {
      Duel.warmUp(player.scene(), rival);
    }
    arena.challenge(rival);
    setSpeed();
    panes.remove(rivalPane);
    foot.remove(scorePane);
    foot.remove(duels);
    if (rival != null) {
      panes.add(rivalPane);
    }
    foot.add(rival == null ? duels : scorePane, BorderLayout.NORTH);
    revalidate();
  }

  /** Offers scenes in which methods fail. */
  private void addDuels() {
    if (!rivals.isEnabled()) {
      return;
    }
    duels.add(new JLabel("Where others fail"));
    for (Preset preset : Preset.values()) {
      String number = String.valueOf(preset.ordinal() + 1);
      String tip = preset.about() + ", beside " + Rival.BOX2D.title();
      KeyAction action =
          key("shift " + number, "Shift+" + number, preset.toString(), tip, () -> duel(preset));
      JButton button = new JButton();
      addButton(button, null, action);
      duels.add(button);
    }
    duels.addComponentListener(new Rewrap(this));
    foot.add(duels, BorderLayout.NORTH);
  }

  /** Plays a scene in which methods fail, beside one of them. */
  void duel(Preset preset) {
    play(preset.about(), preset.scene(), preset.truth());
    if (!arena.isOpen()) {
      challenge(Rival.BOX2D);
    }
    player.setRunning(true);
    told("");
  }

  /**
   * Lets another method play the same scene beside this library, from the moment shown.
   *
   * @param rival the method; null for none
   */
  public void challenge(Rival rival) {
    rivals.setSelectedItem(rival == null ? ALONE : rival);
  }

  private void addTools() {
    ButtonGroup group = new ButtonGroup();
    for (Tool tool : Tool.values()) {
      JToggleButton button = new JToggleButton("", tool == Tool.HAND);
      String number = String.valueOf(tool.ordinal() + 1);
      group.add(button);
      Runnable choose =
          () -> {
            button.setSelected(true);
            canvas.setTool(tool);
          };
      addButton(
          button,
          ToolIcon.valueOf(tool.name()),
          key(number, number, tool.label(), tool.tip(), choose));
      button.setText("");
      button.setName(tool.name());
    }
  }

  private void addLayers() {
    for (Layer layer : Layer.values()) {
      JCheckBox box = new JCheckBox("", canvas.painter().shows(layer));
      String letter = layer.label().substring(0, 1);
      Runnable toggle = () -> show(layer, !canvas.painter().shows(layer), box);
      KeyAction action = key(letter, letter, layer.label(), layer.tip(), toggle);
      box.setText(action.name());
      box.setToolTipText(action.hint());
      box.setFocusable(false);
      box.addActionListener(event -> action.action().run());
      layers.add(box);
    }
  }

  private void show(Layer layer, boolean visible, JCheckBox box) {
    canvas.painter().set(layer, visible);
    box.setSelected(visible);
  }

  private JComponent foot() {
    JPanel controls = new JPanel(new BorderLayout());
    controls.setBorder(BorderFactory.createEmptyBorder(2, 8, 4, 8));
    time.setFocusable(false);
    time.setName("Time");
    time.setToolTipText("Which moment is shown: drag it into the past");
    time.addChangeListener(event -> scrub());
    controls.add(time, BorderLayout.NORTH);
    controls.add(status, BorderLayout.CENTER);
    controls.add(layers, BorderLayout.EAST);
    foot.add(controls, BorderLayout.SOUTH);
    addDuels();
    return foot;
  }

  private void act(Runnable action) {
    message = "";
    action.run();
    refresh();
  }

  private void toggleRunning() {
    player.setRunning(!player.isRunning());
  }

  private void stepBack() {
    player.seek(player.shown() - player.frame());
  }

  private void nextImpact() {
    if (!player.nextImpact()) {
      message = "no impact ahead";
    }
  }

  /** Circles fall through what is shown in about two seconds; on the moon, in about five. */
  private void weigh() {
    double full = full();
    double now = player.look().gravity().length();
    player.setGravity(0, now == 0 ? -full / MOON : now < full / 2 ? -full : 0);
  }

  /** Earth's gravity, if what is shown is a room. */
  private double full() {
    return FALL * canvas.planeHeight() / (player.frame() * player.frame());
  }

  private void fit() {
    canvas.fit();
  }

  private void scrub() {
    if (!refreshing) {
      double share = time.getValue() / (double) SLIDER;
      player.seek(player.start() + share * (player.end() - player.start()));
      refresh();
    }
  }

  /** Shows a message in the status line, after something changed. */
  void told(String text) {
    message = text;
    refresh();
  }

  /** Goes on by one tick of the timer. */
  public void tick() {
    if (player.isRunning()) {
      canvas.hold();
      player.tick();
      refresh();
    }
  }

  /**
   * Starts another scene, at rest.
   *
   * @param title of the window
   * @param truth its true course; null if that is not known
   * @throws IllegalArgumentException if no world can be made of it; then nothing changes
   */
  public void play(String title, Scene scene, Reference truth) {
    player.load(scene);
    player.setRunning(false);
    arena.setTruth(scene, truth);
    canvas.fit();
    titled.accept(title);
    told("");
  }

  /**
   * Sets the listener for the title of the scene.
   *
   * @param listener takes the title
   */
  public void onTitle(Consumer<String> listener) {
    titled = listener;
  }

  /** Tells the title of what is shown. */
  void setTitle(String title) {
    titled.accept(title);
  }

  /** Draws light on dark, or dark on light. */
  void setDark(boolean dark) {
    canvas.painter().setScheme(Look.scheme(dark));
    refresh();
  }

  private void refresh() {
    refreshing = true;
    run.setText(player.isRunning() ? "Pause" : "Run");
    run.setIcon(player.isRunning() ? ToolIcon.PAUSE : ToolIcon.RUN);
    double length = player.end() - player.start();
    double share = length > 0 ? (player.shown() - player.start()) / length : 1;
    time.setValue((int) Math.round(SLIDER * share));
    String moment =
        player.shown() < player.end()
            ? String.format(Locale.ROOT, " of %.3f (past)", player.end())
            : "";
    status.setText(
        String.format(
            Locale.ROOT,
            "time %.3f%s, %s%s",
            player.shown(),
            moment,
            Plural.of(player.impacts(), "impact"),
            message.isEmpty() ? "" : "; " + message));
    gravity.setValue(
        (int) Math.round(gravity.getMaximum() * player.look().gravity().length() / full()));
    refreshing = false;
    canvas.repaint();
    if (arena.isOpen()) {
      rivalPane.repaint();
      scorePane.repaint();
    }
  }

  /** The text of the status line. */
  String status() {
    return status.getText();
  }

  /** Where the scene is drawn. */
  SceneCanvas canvas() {
    return canvas;
  }

  /** The duel beside the player. */
  Arena arena() {
    return arena;
  }

  /** The scores of the duel. */
  ScorePane scores() {
    return scorePane;
  }

  /** The player. */
  Player player() {
    return player;
  }

  /** The actions of the keys. */
  List<KeyAction> keys() {
    return List.copyOf(keys);
  }
}
