// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import dev.carom.Impact;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Answers queries from a file, one row each, in order. */
@Command(
    name = "cast",
    description = {
      "Answers single questions: does this circle hit, when, with which normal?",
      "The file is CSV with one of these headers:",
      "  ax,ay,bx,by,px,py,r,vx,vy,T             a circle and a line",
      "  x1,y1,r1,vx1,vy1,x2,y2,r2,vx2,vy2,T     two circles",
      "Further columns are found by name; an absent one counts as 0, others are ignored:",
      "  ux,uy                                   the velocity of the line",
      "  gx,gy                                   the acceleration of the circle, or of both",
      "Answers go to the standard output: hit,feature,t,nx,ny; of a miss 0,NONE,NaN,NaN,NaN."
    },
    footer = {"", "Example: carom-bench cast queries.csv"})
final class CastCommand extends BenchCommand {

  private static final String STANDARD_INPUT = "-";

  @Parameters(paramLabel = "FILE|-", description = "The queries; - is the standard input.")
  private String file;

  @Override
  void run() throws IOException {
    CastReader reader = new CastReader(file.equals(STANDARD_INPUT) ? "standard input" : file);
    try (Reader in = open()) {
      reader.read(in);
    }
    PrintWriter out = spec.commandLine().getOut();
    out.print("hit,feature,t,nx,ny\n");
    for (double[] query : reader.queries()) {
      out.print(answer(reader.kind().cast(query)));
    }
    out.flush();
  }

  private Reader open() throws IOException {
    return new InputStreamReader(
        file.equals(STANDARD_INPUT) ? System.in : stream(Path.of(file)), StandardCharsets.UTF_8);
  }

  private static InputStream stream(Path path) throws IOException {
    if (Files.isDirectory(path)) {
      throw new IOException(path + ": is a folder: expected a file");
    }
    return Files.newInputStream(path);
  }

  private static String answer(Optional<Impact> found) {
    if (found.isEmpty()) {
      return "0,NONE,NaN,NaN,NaN\n";
    }
    Impact impact = found.get();
    return "1,%s,%s,%s,%s\n"
        .formatted(
            impact.feature(),
            Decimals.shortest(impact.time()),
            Decimals.shortest(impact.normal().x()),
            Decimals.shortest(impact.normal().y()));
  }
}
