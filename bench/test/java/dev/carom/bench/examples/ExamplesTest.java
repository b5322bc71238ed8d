// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import dev.carom.Circle;
import dev.carom.Impact;
import dev.carom.ImpactLog;
import dev.carom.Kind;
import dev.carom.Vec2;
import dev.carom.World;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExamplesTest {

  @ParameterizedTest
  @EnumSource
  void goesOnAndCanBeSeen(Examples which) {
    Example example = which.start();
    int[] first = pixels(example);
    assertThat(Arrays.stream(first).distinct().count()).isGreaterThan(10);
    example.point(new Vec2(0.5, 0.5));
    example.press();
    example.point(new Vec2(0.2, 0.45));
    example.release();
    for (int i = 0; i < 40; i++) {
      example.frame();
    }
    assertThat(pixels(example)).isNotEqualTo(first);
    assertThat(example.size()).isEqualTo(new Dimension(840, 640));
    assertThat(example.hint()).hasSizeBetween(30, 100).endsWith(".").doesNotContain("\n");
  }

  @ParameterizedTest
  @EnumSource
  void eachHasAPicture(Examples which) {
    assertThat(Path.of("results/examples/" + which + ".png")).isNotEmptyFile();
  }

  private static int[] pixels(Example example) {
    Dimension size = example.size();
    BufferedImage image = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setColor(Color.WHITE);
    g.fillRect(0, 0, size.width, size.height);
    example.draw(g, new Rectangle(size));
    g.dispose();
    return image.getRGB(0, 0, size.width, size.height, null, 0, size.width);
  }

  /** With the files that the harness page names, this library and Swing, and nothing else. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "Breakout",
        "Billiards",
        "PiCollisions",
        "Photon",
        "GameLoop",
        "SplitWorld",
        "Paddle",
        "WhatIf",
        "Plinko",
        "Pinball"
      })
  void eachCanBeCopied(String name, @TempDir Path out) throws IOException {
    List<String> args = new ArrayList<>(List.of("-proc:none", "-d", out.toString()));
    args.addAll(List.of("-cp", library()));
    args.add("main/java/dev/carom/bench/examples/" + name + ".java");
    args.add("main/java/dev/carom/bench/examples/Example.java");
    List<String> parts = name.equals("Pinball") ? List.of("Flipper", "Plunger") : List.of();
    parts.forEach(part -> args.add("main/java/dev/carom/bench/examples/" + part + ".java"));
    Path charts = Path.of("main/java/dev/carom/bench/charts");
    String readme = Files.readString(Path.of("README.md"));
    String named = readme.substring(readme.indexOf("the classes that draw examples: "));
    Matcher file = Pattern.compile("`(\\w+)`").matcher(named);
    file.region(0, named.indexOf(" in [charts]"));
    while (file.find()) {
      args.add(charts.resolve(file.group(1) + ".java").toString());
    }
    assertThat(args).hasSize(5 + 2 + parts.size() + 6);
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int exit =
        ToolProvider.getSystemJavaCompiler().run(null, null, errors, args.toArray(String[]::new));
    assertThat(exit).as(errors.toString(StandardCharsets.UTF_8)).isZero();
  }

  private static String library() {
    return Path.of(World.class.getProtectionDomain().getCodeSource().getLocation().getPath())
        .toString();
  }

  /** A bounded call returns false if it is not done: whoever copies an example must see that. */
  @Test
  void noneIgnoresAnUnfinishedCall() throws IOException {
    List<Path> pages = new ArrayList<>();
    for (String folder :
        List.of(
            "main/java/dev/carom/bench/examples",
            "../src/main/javadoc/dev.carom/dev/carom/doc-files",
            "../src/main/java/dev/carom")) {
      try (Stream<Path> files = Files.list(Path.of(folder))) {
        files.filter(file -> file.toString().matches(".*(java|html)")).forEach(pages::add);
      }
    }
    pages.add(Path.of("../README.md"));
    Pattern ignored =
        Pattern.compile("^[ *]*\\w+(\\.\\w+\\([^()]*\\))*\\.advanceTo\\([^;]*, \\w+\\);.*$");
    assertThat(ignored.matcher("  world.advanceTo(1, WORK); // so").matches()).isTrue();
    assertThat(pages).hasSizeGreaterThan(40);
    for (Path page : pages) {
      assertThat(Files.readAllLines(page)).as("%s", page).noneMatch(ignored.asMatchPredicate());
    }
  }

  /** Up to the fork both are the same; then each goes its own way, with the wall elsewhere. */
  @Test
  void twoFuturesHaveOnePast() {
    WhatIf example = new WhatIf();
    for (double fork : new double[] {60, 110}) {
      assertThat(example.fork).isEqualTo(fork);
      int apart = 0;
      for (double t = example.shown; t < WhatIf.END; t = example.shown) {
        boolean same = example.scene(true).equals(example.scene(false));
        assertThat(same).as("at %s", t).isEqualTo(t < fork);
        apart +=
            ((Circle) example.scene(true).shape(Kind.CIRCLE, 0))
                    .equals((Circle) example.scene(false).shape(Kind.CIRCLE, 0))
                ? 0
                : 1;
        example.frame();
      }
      assertThat(apart).isPositive();
      for (int i = 0; i < 25; i++) {
        example.key(KeyEvent.VK_LEFT, true);
      }
      assertThat(example.shown).isEqualTo(WhatIf.END - 250);
      example.point(new Vec2(0.6, 0.3));
      example.press();
    }
  }

  @Test
  void eachIsOneShortFile() throws IOException {
    Path folder = Path.of("main/java/dev/carom/bench/examples");
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files)
          .hasSizeGreaterThan(6)
          .allSatisfy(file -> assertThat(Files.readAllLines(file)).hasSizeLessThan(150));
    }
  }

  @Test
  void breakoutClearsTheBoardAndLosesNoBall() {
    Breakout game = new Breakout();
    int frames = 0;
    for (int bricks = game.bricks; bricks > 0; frames++) {
      game.frame();
      assertThat(game.bricks).isBetween(0, bricks);
      bricks = game.bricks;
      assertThat(frames).as("%d bricks are left", bricks).isLessThan(20 * 60 * Example.FRAMES);
    }
    assertThat(game.lost()).isZero();
  }

  @Test
  void aPaddleInTheCornerLosesTheBall() {
    Breakout game = new Breakout();
    for (int i = 0; i < 3_000; i++) {
      game.point(new Vec2(0, 0));
      game.frame();
    }
    assertThat(game.lost()).isPositive();
  }

  @Test
  void thePaddleObeysTheKeys() {
    Breakout game = new Breakout();
    game.key(KeyEvent.VK_RIGHT, true);
    for (int i = 0; i < 60; i++) {
      game.frame();
    }
    double right = game.paddle;
    game.key(KeyEvent.VK_RIGHT, false);
    game.key(KeyEvent.VK_LEFT, true);
    for (int i = 0; i < 10; i++) {
      game.frame();
    }
    game.key(KeyEvent.VK_LEFT, false);
    game.frame();
    assertThat(right).as("at the wall").isEqualTo(192);
    assertThat(game.paddle).isBetween(140.0, 160.0);
    double left = game.paddle;
    game.frame();
    assertThat(game.paddle).isEqualTo(left);
  }

  @Test
  void billiardBallsLoseEnergyAndComeToRestWithoutOverlap() {
    Billiards table = new Billiards();
    shoot(table, new Vec2(0.5, 0.5), new Vec2(0.15, 0.503));
    double energy = energy(table.world);
    assertThat(energy).isPositive();
    int frames = 0;
    while (energy > 0) {
      table.frame();
      assertThat(energy(table.world)).as("frame %d", frames).isLessThan(energy);
      energy = energy(table.world);
      assertThat(frames++).isLessThan(120 * Example.FRAMES);
    }
    World world = table.world;
    assertThat(world.count(Kind.CIRCLE)).isBetween(1, 16);
    assertThat(gap(world)).isGreaterThan(-1e-12);
  }

  private static void shoot(Billiards table, Vec2 from, Vec2 to) {
    table.point(from);
    table.press();
    table.point(to);
    table.release();
  }

  /**
   * The ball that the line points at is the first that moves, and it takes the way that it shows.
   */
  @Test
  void theAimingLineSeesTheBallsOfTheTable() {
    Billiards table = new Billiards();
    World world = table.world;
    table.point(new Vec2(0.5, 0.5));
    table.press();
    table.point(new Vec2(0.4, 0.4995));
    Impact first = table.target().orElseThrow();
    assertThat(first.kind()).isEqualTo(Kind.CIRCLE);
    assertThat(first.id()).isEqualTo(1);
    table.release();
    assertThat(table.target()).as("while the cue ball rolls").isEmpty();
    ImpactLog impacts = world.impacts();
    do {
      table.frame();
    } while (impacts.size() == 0);
    assertThat(impacts.kind(0)).isEqualTo(Kind.CIRCLE);
    assertThat(List.of(impacts.circle(0), impacts.id(0))).containsExactlyInAnyOrder(0, 1);
    double side = impacts.circle(0) == 0 ? 1 : -1;
    assertThat(side * impacts.nx(0)).isCloseTo(first.normal().x(), offset(1e-13));
    assertThat(side * impacts.ny(0)).isCloseTo(first.normal().y(), offset(1e-13));
  }

  @Test
  void aCueBallInAPocketComesBack() {
    Billiards table = new Billiards();
    World world = table.world;
    shoot(table, new Vec2(0.25, 0.5), new Vec2(0.37, 0.6575)); // into the corner below, left
    int frames = 0;
    while (world.impacts().size() == 0) {
      table.frame();
      assertThat(frames++).isLessThan(600);
    }
    assertThat(world.impacts().kind(0)).isEqualTo(Kind.PEG);
    assertThat(world.impacts().circle(0)).isZero();
    assertThat(world.x(0)).isEqualTo(2.54 / 4);
    assertThat(world.vx(0)).isZero();
  }

  /** The published digits: F. Bornemann et al., The SIAM 100-Digit Challenge, 2004. */
  @Test
  void thePhotonShowsTheDigitsThatAreSure() {
    String published = "0.9952629194433541608903118";
    Photon photon = new Photon();
    for (int i = 0; i < Photon.END; i++) {
      photon.frame();
    }
    System.out.println(
        "photon: " + photon.sureDistance() + " of " + photon.distance() + " are sure");
    assertThat(photon.reflections()).isEqualTo(14);
    assertThat(published).startsWith(photon.sureDistance());
    assertThat(photon.sureDistance()).hasSizeBetween(4, 8);
  }

  @Test
  void sureDigitsAreThoseThatAllNumbersShare() {
    assertThat(Photon.sureDigits(0.125, 0.0001)).isEqualTo("0.12");
    assertThat(Photon.sureDigits(0.125, 0)).isEqualTo("0.12500000000000000");
    assertThat(Photon.sureDigits(3.7, 0.5)).isEqualTo("?");
    assertThat(Photon.sureDigits(3.7, Double.POSITIVE_INFINITY)).isEqualTo("?");
  }

  @Test
  void collisionsCountTheDigitsOfPi() {
    PiCollisions pi = new PiCollisions();
    for (int i = 0; i < 2_000; i++) {
      pi.frame();
    }
    for (int k = 0; k < PiCollisions.LANES; k++) {
      assertThat(pi.count(k)).isEqualTo((int) (Math.PI * Math.pow(10, k)));
    }
    pi.press();
    assertThat(pi.count(4)).isZero();
  }

  private static double energy(World world) {
    double sum = 0;
    for (int id = 0; id < world.idLimit(Kind.CIRCLE); id++) {
      if (world.contains(Kind.CIRCLE, id)) {
        sum += world.vx(id) * world.vx(id) + world.vy(id) * world.vy(id);
      }
    }
    return sum;
  }

  private static double gap(World world) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < world.idLimit(Kind.CIRCLE); i++) {
      for (int j = 0; j < i; j++) {
        if (world.contains(Kind.CIRCLE, i) && world.contains(Kind.CIRCLE, j)) {
          double distance = Math.hypot(world.x(i) - world.x(j), world.y(i) - world.y(j));
          least = Math.min(least, distance - world.radius(i) - world.radius(j));
        }
      }
    }
    return least;
  }

  @Test
  void theLoopDoesNotDependOnItsTimer() {
    GameLoop even = new GameLoop();
    GameLoop uneven = new GameLoop();
    for (int i = 0; i < 100; i++) {
      even.elapse(3 * GameLoop.STEP);
      uneven.elapse(GameLoop.STEP / 3);
      uneven.elapse(3 * GameLoop.STEP - GameLoop.STEP / 3);
      assertThat(uneven.world().now()).isEqualTo(even.world().now());
      assertThat(uneven.world().x(1)).isEqualTo(even.world().x(1));
      assertThat(uneven.world().y(1)).isEqualTo(even.world().y(1));
    }
  }

  @Test
  void theLoopShowsWhatLiesBetweenTwoSteps() {
    GameLoop loop = new GameLoop();
    loop.elapse(5 * GameLoop.STEP);
    double before = loop.shown();
    long quarter = GameLoop.STEP / 4;
    loop.elapse(quarter);
    assertThat(loop.shown() - before).isCloseTo(quarter / 1e9, offset(1e-15));
    assertThat(loop.shown()).isLessThan(loop.world().now());
    loop.elapse(3_600_000_000_000L);
    assertThat(loop.world().now())
        .as("no run after the clock")
        .isLessThan(26.0 * GameLoop.STEP / 1e9);
  }

  /** By itself it plays for ever; each ball that comes with v leaves with -v + 2 u. */
  @Test
  void thePaddleBringsTheBallBack() {
    Paddle game = new Paddle();
    World world = game.world();
    ImpactLog log = world.impacts();
    int swings = 0;
    for (int i = 0; i < 6_000; i++) {
      double before = world.vx(0);
      double from = world.line(0).ax();
      game.frame();
      if (log.size() == 1 && log.kind(0) == Kind.LINE && log.id(0) == 0) {
        double u = world.line(0).ax() - from; // a frame takes a unit of time
        assertThat(world.vx(0)).as("frame %d", i).isCloseTo(-before + 2 * u, offset(1e-12));
        swings += u > 0.1 ? 1 : 0;
      }
    }
    assertThat(swings).isGreaterThan(30);
    assertThat(game.returned()).isGreaterThanOrEqualTo(swings);
    assertThat(game.lost()).isZero();
  }

  @Test
  void aPaddleThatIsElsewhereLosesTheBall() {
    Paddle game = new Paddle();
    game.point(new Vec2(0.1, 0.9));
    for (int i = 0; i < 600; i++) {
      game.frame();
    }
    assertThat(game.lost()).isPositive();
    assertThat(game.world().line(0).by()).isCloseTo(160, offset(1e-12));
  }

  /** Each ball arrives once; where they were let go in the middle, they arrive around it. */
  @Test
  void thePlinkoBoardCountsEveryBallOnce() {
    Plinko board = new Plinko();
    for (int i = 0; i < 4_000; i++) {
      board.frame();
      int arrived = Arrays.stream(board.counts()).sum();
      assertThat(arrived + board.world().count(Kind.CIRCLE)).isEqualTo(board.dropped());
    }
    assertThat(board.world().count(Kind.CIRCLE)).as("none is stuck").isLessThan(200);
    double mean = 0;
    int arrived = Arrays.stream(board.counts()).sum();
    for (int slot = 0; slot < Plinko.SLOTS; slot++) {
      mean += slot * (double) board.counts()[slot] / arrived;
    }
    assertThat(arrived).isGreaterThan(800);
    assertThat(mean).isCloseTo((Plinko.SLOTS - 1) / 2.0, offset(0.6));
    board.press();
    assertThat(board.counts()).containsOnly(0);
    board.point(new Vec2(0, 1));
    for (int i = 0; i < 4_000; i++) {
      board.frame();
    }
    assertThat(board.counts()[1]).isGreaterThan(board.counts()[Plinko.SLOTS - 2]);
  }

  /** The plunger throws a ball out of its lane, and it comes back only when it was lost. */
  @Test
  void thePinballTableGoesOnByItself() {
    Pinball game = new Pinball();
    World world = game.world;
    int onTable = 0;
    int balls = 1;
    for (int i = 0; i < 20_000; i++) {
      boolean before = world.x(0) < 180;
      game.frame();
      onTable += before ? 1 : 0;
      boolean back = before && world.x(0) > 182;
      assertThat(back).as("frame %d", i).isEqualTo(game.balls > balls);
      balls = game.balls;
    }
    assertThat(onTable).isGreaterThan(5_000);
    assertThat(balls).isGreaterThan(5);
    assertThat(game.score).isGreaterThan(200);
  }

  /** The ball rests on the plunger, also while that goes down. */
  @Test
  void thePlungerCarriesTheBall() {
    Pinball game = new Pinball();
    World world = game.world;
    game.press();
    for (int i = 0; i < 300; i++) {
      game.frame();
      double gap = world.y(0) - world.radius(0) - world.line(0).ay();
      assertThat(gap).as("frame %d", i).isBetween(-1e-12, 1.5);
    }
    assertThat(world.line(0).ay()).isCloseTo(6, offset(1e-9));
    assertThat(world.y(0)).isCloseTo(11, offset(1e-9));
    assertThat(world.vy(0)).isZero();
    game.release();
    for (int i = 0; i < 30; i++) {
      game.frame();
    }
    assertThat(world.y(0)).isGreaterThan(100);
    assertThat(world.line(0).ay()).isCloseTo(30, offset(1e-9));
  }
}
