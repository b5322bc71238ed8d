// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CastCommandTest {

  private static final String LINE = "ax,ay,bx,by,px,py,r,vx,vy,T";
  private static final String PAIR = "x1,y1,r1,vx1,vy1,x2,y2,r2,vx2,vy2,T";

  @TempDir private Path folder;

  private Path file;

  @BeforeEach
  void name() {
    file = folder.resolve("queries.csv");
  }

  private Cli cast(String... lines) throws IOException {
    Files.writeString(file, String.join("\n", lines) + "\n");
    return Cli.run("cast", file);
  }

  @Test
  void answersLinesInOrder() throws IOException {
    // A circle of radius 5 and the line from (0, 0) to (0, 10), four times: it meets the inside,
    // touches the start and rises, meets the end, flies away.
    Cli run =
        cast(
            LINE,
            "0,0,0,10,-15,4,5,20,0,1",
            "0,0,0,10,-4,-3,5,0,1,1",
            "0,0,0,10,-14,13,5,20,0,1",
            "0,0,0,10,-15,4,5,-20,0,1");

    assertThat(run.exitCode()).isZero();
    assertThat(run.out())
        .isEqualTo(
            """
            hit,feature,t,nx,ny
            1,SIDE,0.5,-1.0,0.0
            1,START,0.0,-0.8,-0.6
            1,END,0.5,-0.8,0.6
            0,NONE,NaN,NaN,NaN
            """);
  }

  @Test
  void answersPairsWithTheNormalToTheFirst() throws IOException {
    Cli run = cast(PAIR, "0,0,5,10,0,40,0,5,-20,0,2", "0,0,5,10,0,40,0,5,-20,0,0.5");

    assertThat(run.out())
        .isEqualTo("hit,feature,t,nx,ny\n1,CIRCLE,1.0,-1.0,0.0\n0,NONE,NaN,NaN,NaN\n");
  }

  /** Wherever they stand, and one of them alone. */
  @Test
  void theVelocityOfALineIsFoundByName() throws IOException {
    String query = "0,0,0,10,-15,4,5,20,0,1,";
    assertThat(cast(LINE + ",uy,note,ux", query + "0,,-20", query + "2,,20").out())
        .isEqualTo("hit,feature,t,nx,ny\n1,SIDE,0.25,-1.0,0.0\n0,NONE,NaN,NaN,NaN\n");
    assertThat(cast(LINE + ",ux", query + "-0x1.4p4").out()).contains("1,SIDE,0.25,");
    assertThat(cast(LINE + ",note,ux", query + ",fast").err())
        .contains(":2:26: ux is \"fast\": expected a finite number");
    assertThat(cast(LINE + ",note,uy", query).err())
        .contains(":2:25: uy is missing: expected a finite number");
  }

  /** A ball that falls from rest by 8 with an acceleration of 4: t = 2. */
  @Test
  void theAccelerationIsFoundByName() throws IOException {
    String query = "-10,0,10,0,0,9,1,0,0,9,";
    assertThat(cast(LINE + ",gx,gy", query + "0,-4", query + "0,4").out())
        .isEqualTo("hit,feature,t,nx,ny\n1,SIDE,2.0,0.0,1.0\n0,NONE,NaN,NaN,NaN\n");
    assertThat(cast(PAIR + ",gy", "0,0,5,10,0,40,0,5,-20,0,2,7").out())
        .contains("1,CIRCLE,1.0,-1.0,0.0");
    assertThat(cast(LINE + ",uy,gy", query + "2,-2").out())
        .as("the line comes to meet it")
        .contains("1,SIDE,2.0,0.0,1.0");
  }

  @Test
  void passesOverFurtherColumnsBlankLinesAndCarriageReturns() throws IOException {
    Cli run = cast(LINE + ",hit,note\r", "\r", "0,0,0,10,-15,4,5,20,0,Infinity,1,\"quoted\r");

    assertThat(run.out()).isEqualTo("hit,feature,t,nx,ny\n1,SIDE,0.5,-1.0,0.0\n");
  }

  @Test
  void readsHexFloats() throws IOException {
    assertThat(cast(LINE, "0,0,0,0x1.4p3,-15,4,5,20,0,1").out()).contains("1,SIDE,0.5,-1.0,0.0");
  }

  @Test
  void readsTheStandardInput() {
    InputStream before = System.in;
    String queries = LINE + "\n0,0,0,10,-15,4,5,20,0,1\n";
    System.setIn(new ByteArrayInputStream(queries.getBytes(StandardCharsets.UTF_8)));
    try {
      assertThat(Cli.run("cast -").out()).contains("1,SIDE,0.5,-1.0,0.0");
    } finally {
      System.setIn(before);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0,0,10,0,4,15,-1,0,1,1  | 3:15: r is \"-1\": expected a finite number, at least 0",
        "0,0,10,0,4,15,5,0,1,NaN | 3:21: T is \"NaN\": expected a number, at least 0",
        "0,0,10,0,4,15,5,0       | 3:18: vy is missing: expected a finite number",
        "0,0,10,0,4,15,5,4d,1,1  | 3:17: vx is \"4d\": expected a finite number",
        "0,zero,10,0,4,15,5,0,1,1| 3:3: ay is \"zero\": expected a finite number",
        "0,0,1e999,0,4,15,5,0,1,1| 3:5: bx is \"1e999\": expected a finite number"
      })
  void oneMalformedRowStopsAllAnswers(String row, String message) throws IOException {
    Cli run = cast(LINE, "0,0,0,10,-15,4,5,20,0,1", row);

    assertThat(run.exitCode()).isEqualTo(1);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).isEqualTo("carom-bench cast: " + file + ":" + message + "\n");
  }

  /** As spreadsheets write them. */
  @Test
  void aByteOrderMarkIsPassedOver() throws IOException {
    assertThat(cast("\uFEFF" + LINE, "0,0,0,10,-15,4,5,20,0,1").exitCode()).isZero();
  }

  @Test
  void tellsWhichHeadersThereAre() throws IOException {
    assertThat(cast("a,b,c").err())
        .contains(file + ":1:1: the header is \"a,b,c\": expected " + LINE + " or " + PAIR);
    Files.writeString(file, "");
    assertThat(Cli.run("cast", file).err()).contains(":1:1: the file is empty: expected " + LINE);
  }

  /** Characters of the file neither break the line nor reach the terminal unescaped. */
  @Test
  void quotesWhatATerminalMayNotShowByEscapes() throws IOException {
    Cli run = cast(LINE, "0,a\u001b[2J\"\\,10,0,4,15,-1,0,1,1");

    assertThat(run.err())
        .hasLineCount(1)
        .contains(": ay is \"a\\u001b[2J\\\"\\\\\": expected a finite number");
  }
}
