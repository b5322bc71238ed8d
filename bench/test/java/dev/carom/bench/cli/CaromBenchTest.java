// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class CaromBenchTest {

  static Stream<String> commands() {
    Stream<String> named = CaromBench.commandLine().getSubcommands().keySet().stream();
    Stream<String> series = MeasureCommand.SERIES.stream().map(name -> "measure " + name);
    return Stream.concat(Stream.of(""), Stream.concat(named, series).map(name -> name + " "));
  }

  @ParameterizedTest
  @MethodSource("commands")
  void everyCommandExplainsItself(String command) {
    Cli help = Cli.run(command + "--help");

    assertThat(help.exitCode()).isZero();
    assertThat(help.out()).startsWith("Usage: carom-bench " + command.strip());
    assertThat(help.err()).isEmpty();
  }

  /** The list takes the first string of a description: a sentence that goes on was cut there. */
  @Test
  void theListTellsOfEachCommandInWholeSentences() {
    String help = Cli.run("--help").out();
    String list = help.substring(help.indexOf("Try it:"), help.indexOf("Example:")).strip();
    List<String> entries =
        Pattern.compile("\\R\\R?[A-Z].*:(?=\\R)|\\R(?=  \\S)")
            .splitAsStream(list)
            .filter(entry -> entry.startsWith("  "))
            .toList();
    assertThat(entries)
        .hasSize(CaromBench.commandLine().getSubcommands().size())
        .allSatisfy(entry -> assertThat(entry).matches("(?s).*[.?]"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "nosuch                         | COMMAND is nosuch: expected one of [replay, report, measure,",
        "sweep extra                    | 'extra' is one word too many",
        "replay --frames x              | '--frames': 'x' is not an int",
        "replay --frames 0              | --frames is 0: expected at least 1",
        "replay --forks 0               | --forks is 0: expected at least 1",
        "--circles 0                    | --circles is 0: expected at least 1",
        "replay --radius NaN            | --radius is NaN: expected more than 0 and at most 300",
        "replay --speed 10..1           | highest speed is 1.0: expected a finite number",
        "replay --speed fast            | 'fast' is not a speed, or a range such as 1..10",
        "replay --scene a.csv --seed 2  | --scene and --seed exclude each other",
        "simulate --frames 3            | Missing required option: '--scene=FILE'",
        "simulate --scene a.csv --frames -1       | --frames is -1: expected at least 0",
        "simulate --scene a.csv --frames 1 --dt 0 | --dt is 0.0: expected a finite number",
        "rungs --queries 0              | --queries is 0: expected at least 1",
        "reference --scene a --digits 100000000 | --digits is 100000000: expected at most 39000",
        "view --png a.png --against box2d       | --png draws one side: --against and --record ex",
        "help nosuch                    | COMMAND is nosuch: expected one of [replay, report,",
        "help --circles 5               | Unknown option: '--circles'",
        "view --dt 0                    | --dt is 0.0: expected a finite number",
        "threads --threads 0            | --threads is 0: expected at least 1",
        "example nosuch                 | 'nosuch' is none of [breakout, billiards, pi, photon",
        "example --png a.png            | NAME is missing: expected one of [breakout, billiards,",
        "simulate --scene a --frames 1 --positions b.csv --impacts ./b.csv | --impacts is ./b.csv: exp",
        "simulate --scene a --frames 1 --positions ./a | --positions is ./a: expected another file",
        "simulate --scene a --frames 1 --impacts ./a   | --impacts is ./a: expected another file",
        "simulate --scene a --frames 9 --dt 1e308      | --dt is 1.0E308: expected a finite time",
        "replay --scene a --json ./a    | --json is ./a: expected another file than --scene",
        "rungs --csv a.b --json ./a.b   | --json is ./a.b: expected another file than --csv",
        "fuzz --impacts 10              | --impacts is 10: expected at least 100000",
        "fuzz --gas                     | --gas needs --impacts",
        "fuzz --impacts 100000 --circles 0 | --circles is 0: expected at least 1",
        "fuzz --impacts 100000 --scene heaps | 'heaps' is none of [trapped, pockets, masses, doors, heap, bumpers, fall, pile, plinko]",
        "measure                        | SERIES is missing: expected one of [sweep, scale, features, gas, threads, worlds]",
        "measure nosuch                 | SERIES is nosuch: expected one of [sweep, scale, features, gas, threads, worlds]",
        "gas --packing 2                | --packing is 2.0: expected more than 0 and less than 1",
        "gas --frame-time 0             | --frame-time is 0.0: expected a finite number",
        "gas --steady 0                 | --steady is 0: expected at least 1",
        "scale --max 99                 | --max is 99: expected at least 100",
        "scale --rounds 0               | --rounds is 0: expected at least 1",
        "scale --warm-up -1             | --warm-up is -1: expected at least 0",
        "features --heaps 9             | --heaps is 9: expected at least 10",
        "measure worlds --worlds 0      | --worlds is 0: expected at least 1",
        "fuzz --seconds 0               | --seconds is 0: expected at least 1",
        "fuzz --sessions 0              | --sessions is 0: expected at least 1",
        "fuzz --impacts 100000 --scene heap --gas | --scene and --gas exclude each other",
        "replay --speed NaN             | 'NaN' is not a speed, or a range such as 1..10",
        "replay --speed 1..Infinity     | '1..Infinity' is not a speed, or a range such as",
        "hash --frames 2 --long         | --frames and --long exclude each other",
        "fuzz --seconds 3 --sessions 9  | --seconds and --sessions exclude each other",
        "cast                           | Missing required parameter: 'FILE|-'"
      })
  void wrongCommandLinesAreOneLineAndExitCodeTwo(String words, String message) {
    Cli run = Cli.run(words);

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).contains(message).contains("--help)").hasLineCount(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "simulate --frames 1 --scene %; line 2 is bad;2:12: radius is \"x\"",
        "replay --scene %; line 2 is bad;2:12: radius is \"x\"",
        "cast nosuch.csv; ;nosuch.csv: no such file",
        "cast .; ;.: is a folder: expected a file",
        "rungs --csv .; before anything long;.: is a folder: expected a file",
        "sweep --csv .; before anything long;.: is a folder: expected a file",
        "scale --csv %/a.csv; before anything long;scene.csv: is a file: expected a folder",
        "replay --json .; before anything long;.: is a folder: expected a file",
        "simulate --frames 1 --scene nosuch.csv; ;nosuch.csv: no such file",
        "replay --crosses 1000; ;of 1000: none of 100,000 places fits",
        "gas --packing 0.9; ;no room for circle 1 of 1000"
      })
  void badDataIsOneLineAndExitCodeOne(
      String words, String why, String message, @TempDir Path folder) throws Exception {
    Path scene = folder.resolve("scene.csv");
    Files.writeString(scene, "wall,0,0,800,600\ncircle,1,2,x,0,0\n");

    Cli run = Cli.run(words.replace("%", scene.toString()));

    assertThat(run.exitCode()).as(why).isEqualTo(1);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).contains(message).hasLineCount(1);
  }

  @Test
  void helpIsACommandToo() {
    assertThat(Cli.run("help")).isEqualTo(Cli.run("--help"));
    assertThat(Cli.run("help fuzz")).isEqualTo(Cli.run("fuzz --help"));
    assertThat(Cli.run("fuzz --help").out()).contains("Usage: carom-bench fuzz");
  }

  @Test
  void aSeriesIsACommandByItsNameAlone() {
    assertThat(CaromBench.commandLine().getSubcommands().get("measure").getSubcommands().keySet())
        .isEqualTo(MeasureCommand.SERIES);
    for (String series : MeasureCommand.SERIES) {
      String help = Cli.run("measure", series, "--help").out();
      assertThat(help).startsWith("Usage: carom-bench measure " + series);
      assertThat(Cli.run(series, "--help").out()).isEqualTo(help);
      assertThat(Cli.run("help", series).out()).isEqualTo(help);
    }
  }

  @Test
  void theListHasEveryCommandOnceInAGroup() {
    String help = Cli.run("--help").out();
    assertThat(help).contains("Try it:", "Measure:", "Look for mistakes:");
    for (String name : CaromBench.commandLine().getSubcommands().keySet()) {
      assertThat(help).containsOnlyOnce(System.lineSeparator() + "  " + name + " ");
    }
  }

  /** The help of each command ends with one that can be typed; it is parsed here. */
  @Test
  void everyCommandHasAnExample() {
    CaromBench.commandLine()
        .getSubcommands()
        .forEach(
            (name, command) -> {
              String example = example(Cli.run(name, "--help").out());
              assertThat(example).startsWith("carom-bench " + name);
              String[] words = example.replace("carom-bench ", "").split(" ");
              assertThatCode(() -> CaromBench.commandLine().parseArgs(words))
                  .doesNotThrowAnyException();
            });
    assertThat(example(Cli.run("--help").out())).startsWith("carom-bench ");
  }

  private static String example(String help) {
    Matcher example = Pattern.compile("(?m)^Example: (.+)$").matcher(help);
    assertThat(example.find()).as(help).isTrue();
    return example.group(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "repla                      | hash, fuzz, jmh]; did you mean replay",
        "gas --circels 5            | '--circels', '5'; did you mean --circles",
        "sweep --replay 3           | '--replay', '3'; did you mean --replays",
        "xyzxyz                     | hash, fuzz, jmh] (see"
      })
  void aWordThatIsNearlyRightIsNamed(String words, String message) {
    Cli run = Cli.run(words);

    assertThat(run.exitCode()).isEqualTo(2);
    assertThat(run.err()).contains(message).hasLineCount(1);
  }

  @Test
  void everyCommandTellsTheVersion() {
    Set<String> commands = new TreeSet<>(CaromBench.commandLine().getSubcommands().keySet());
    commands.remove("jmh"); // its options are JMH's own
    for (String command : commands) {
      assertThat(Cli.run(command, "--version").out()).startsWith("carom-bench ");
    }
  }

  @Test
  void lostOutputIsAFailure() {
    PrintStream full =
        new PrintStream(
            new OutputStream() {
              @Override
              public void write(int b) throws IOException {
                throw new IOException("full");
              }
            });
    full.println("answer");
    ByteArrayOutputStream err = new ByteArrayOutputStream();

    assertThat(CaromBench.exitCode(0, full, new PrintStream(err))).isEqualTo(1);
    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualTo("carom-bench: standard output: cannot be written" + System.lineSeparator());
    assertThat(CaromBench.exitCode(2, full, System.err)).isEqualTo(2);
    assertThat(CaromBench.exitCode(0, new PrintStream(err), System.err)).isZero();
  }
}
