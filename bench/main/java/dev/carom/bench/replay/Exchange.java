// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.replay;

import dev.carom.Scene;
import dev.carom.bench.methods.Contender;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** The temporary folder through which a run and its forks exchange scenes and samples. */
record Exchange(Path folder) {

  static Exchange create(Scene measured, List<Scene> others) throws IOException {
    Exchange exchange = new Exchange(Files.createTempDirectory("carom-replay"));
    measured.write(exchange.measured());
    for (int i = 0; i < others.size(); i++) {
      others.get(i).write(exchange.other(i));
    }
    return exchange;
  }

  Scene readMeasured() throws IOException {
    return Scene.read(measured());
  }

  List<Scene> readOthers() throws IOException {
    List<Scene> scenes = new ArrayList<>();
    for (int i = 0; Files.exists(other(i)); i++) {
      scenes.add(Scene.read(other(i)));
    }
    return scenes;
  }

  Path samples(Contender contender, int fork) {
    return folder.resolve(contender.id() + "-" + fork + ".samples");
  }

  /** The output of JMH, kept off the terminal. */
  Path log(Contender contender, int fork) {
    return folder.resolve(contender.id() + "-" + fork + ".log");
  }

  void delete() throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  private Path measured() {
    return folder.resolve("measured.csv");
  }

  private Path other(int i) {
    return folder.resolve("other-" + i + ".csv");
  }
}
