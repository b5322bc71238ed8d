// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every way to get a row wrong, with the place and the words of its message. */
class SceneFormatExceptionTest {

  private static SceneFormatException refused(String text) {
    return catchThrowableOfType(
        SceneFormatException.class, () -> Scene.read(new StringReader(text), "scene.csv"));
  }

  private static void assertRefused(String row, int column, String reason) {
    SceneFormatException e = refused("# a scene\n\n" + row + "\nline,1,2,3,4\n");
    assertThat(e).hasMessage("scene.csv:3:" + column + ": " + reason);
    assertThat(e.file()).isEqualTo("scene.csv");
    assertThat(e.line()).isEqualTo(3);
    assertThat(e.column()).isEqualTo(column);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "lnie,1,2,3,4 | 1 | lnie",
        "Line,1,2,3,4 | 1 | Line",
        "circles,1,2,3,4,5 | 1 | circles",
        "circle 1,2,3,4,5 | 1 | circle 1",
        "7 | 1 | 7",
        "` ,1,2` | 2 | ``",
        "`  peg;1;2;3` | 3 | peg;1;2;3",
      })
  void unknownKind(String row, int column, String found) {
    assertRefused(
        row,
        column,
        "\""
            + found
            + "\" is unknown: expected wall, line, outline, peg, circle, collide or gravity");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "wall | 5 | xmin | wall,xmin,ymin,xmax,ymax",
        "wall,0,0,800 | 13 | ymax | wall,xmin,ymin,xmax,ymax",
        "line,1,2,3 | 11 | by | line,ax,ay,bx,by",
        "line,1,2,3 # the end | 11 | by | line,ax,ay,bx,by",
        "line,1,2,3,restitution=1 | 12 | by | line,ax,ay,bx,by",
        "peg,1,2 | 8 | radius | peg,x,y,radius",
        "circle,1,2,3,4 | 15 | vy | circle,x,y,radius,vx,vy[,mass]",
        "gravity | 8 | gx | gravity,gx,gy",
        "gravity,0 | 10 | gy | gravity,gx,gy",
      })
  void missingField(String row, int column, String name, String shape) {
    assertRefused(row, column, name + " is missing: expected " + shape);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "wall,0,0,8,6,7 | 14 | 7 | wall,xmin,ymin,xmax,ymax",
        "line,1,2,3,4, 5 | 15 | 5 | line,ax,ay,bx,by",
        "line,1,2,3,4, | 14 | `` | line,ax,ay,bx,by",
        "peg,1,2,3,0.5,restitution=1 | 11 | 0.5 | peg,x,y,radius",
        "circle,1,2,3,4,5,6,7 | 20 | 7 | circle,x,y,radius,vx,vy[,mass]",
        "gravity,0,-1,2 | 14 | 2 | gravity,gx,gy",
      })
  void excessField(String row, int column, String found, String shape) {
    assertRefused(row, column, "\"" + found + "\" is one field too many: expected " + shape);
  }

  @ParameterizedTest
  @ValueSource(strings = {"heavy", "", "-inf", "1e999", "INF"})
  void notAMass(String mass) {
    assertRefused(
        "circle,1,2,3,4,5," + mass,
        18,
        "mass is \"" + mass + "\": expected a number from 2^-500 to 2^500, or inf");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "wall,x,0,800,600 | 6 | xmin | x",
        "wall,0,x,800,600 | 8 | ymin | x",
        "wall,0,0,x,600 | 10 | xmax | x",
        "wall,0,0,800,x | 14 | ymax | x",
        "line,x,2,3,4 | 6 | ax | x",
        "line,1,x,3,4 | 8 | ay | x",
        "line,1,2,x,4 | 10 | bx | x",
        "line,1,2,3,x | 12 | by | x",
        "line,1,,3,4 | 8 | ay | ``",
        "line,1,2,3, | 12 | by | ``",
        "`  line,  1, x , 3,4` | 13 | ay | x",
        "peg,NaN,2,3 | 5 | x | NaN",
        "peg,1,Infinity,3 | 7 | y | Infinity",
        "peg,1,2,1e999 | 9 | radius | 1e999",
        "circle,1f,2,3,4,5 | 8 | x | 1f",
        "circle,1,2d,3,4,5 | 10 | y | 2d",
        "circle,100.25,200.5,abc,4,5 | 21 | radius | abc",
        "circle,1,2,3,0x4,5 | 14 | vx | 0x4",
        "circle,1,2,3,4,5 6 | 16 | vy | 5 6",
        "gravity,down,0 | 9 | gx | down",
        "gravity,0, -inf | 12 | gy | -inf",
        "gravity,0,1e999 | 11 | gy | 1e999",
        "line,1,2,3,4,restitution=high | 14 | restitution | high",
        "line,1,2,3,4,restitution= | 14 | restitution | ``",
        "line,1,2,3,4,restitution==1 | 14 | restitution | =1",
        "line,1,2,3,4,  restitution = NaN | 16 | restitution | NaN",
      })
  void notANumber(String row, int column, String name, String found) {
    assertRefused(row, column, name + " is \"" + found + "\": expected a finite number");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      quoteCharacter = '`',
      value = {
        "wall,5,0,5,1 ~ 10 ~ xmax is 5.0: expected more than xmin, 5.0",
        "wall,0,5,1,4 ~ 12 ~ ymax is 4.0: expected more than ymin, 5.0",
        "peg,1,2,-3 ~ 9 ~ radius is -3.0: expected a finite number, at least 0",
        "circle,1,2,-3,4,5 ~ 12 ~ radius is -3.0: expected a finite number, at least 0",
        "circle,1,2,3,4,5,0 ~ 18 ~ mass is 0.0: expected a number from 2^-500 to 2^500, or"
            + " infinity",
        "line,1,2,3,4,response=halt,restitution=-1 ~ 28"
            + " ~ restitution is -1.0: expected a finite number, at least 0",
        "line,1,2,3,4, restitution=-1 ~ 15"
            + " ~ restitution is -1.0: expected a finite number, at least 0",
        "line,1,2,3,4,response=Halt ~ 14 ~ response is \"Halt\": expected bounce, halt or sensor",
        "line,1,2,3,4,response=halt,response=halt ~ 28 ~ response is given twice: expected once",
        "line,1,2,3,4,restitution=1,restitution=1 ~ 28"
            + " ~ restitution is given twice: expected once",
        "line,1,2,3,4,oneway=yes ~ 14 ~ oneway is \"yes\": expected 0 or 1",
        "wall,0,0,9,9,response=sensor ~ 14"
            + " ~ response is sensor: expected bounce or halt: bounds keep circles inside",
        "line,1,2,3,4,restitution=1,5 ~ 28 ~ \"5\" is out of place: expected key=value",
        "line,1,2,3,4,restitution=1, ~ 28 ~ \"\" is out of place: expected key=value",
        "collide,0,restitution=1 ~ 11 ~ \"restitution=1\" is out of place: expected no more",
        "gravity,0,1,mask=1 ~ 13 ~ \"mask=1\" is out of place: expected no more",
        "collide ~ 8 ~ 0|1 is missing: expected collide,0|1",
        "collide,0,0 ~ 11 ~ \"0\" is one field too many: expected collide,0|1",
        "collide,2 ~ 9 ~ collide is \"2\": expected 0 or 1",
        "collide,yes ~ 9 ~ collide is \"yes\": expected 0 or 1",
        "collide,0.0 ~ 9 ~ collide is \"0.0\": expected 0 or 1",
      })
  void outOfRangeOrPlace(String row, int column, String reason) {
    assertRefused(row, column, reason);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "peg,1,2,3,oneway=1 | 11 | oneway",
        "line,1,2,3,4,sensor=1 | 14 | sensor",
        "line,1,2,3,4,restitution=1, Restitution=1 | 29 | Restitution",
        "line,1,2,3,4,=1 | 14 | ``",
      })
  void unknownKey(String row, int column, String key) {
    String keys = "restitution=NUMBER, response=WORD, category=INTEGER, mask=INTEGER, vx=NUMBER";
    keys += row.startsWith("line") ? ", vy=NUMBER or oneway=0|1" : " or vy=NUMBER";
    assertRefused(row, column, "key \"" + key + "\" is unknown: expected " + keys);
  }

  @Test
  void rowsThatStandOnce() {
    assertThat(refused("wall,0,0,1,1\n#\n wall,0,0,1,1"))
        .hasMessage("scene.csv:3:2: a second wall row, after line 1: expected one only");
    assertThat(refused("\ncollide,0\ncollide,0"))
        .hasMessage("scene.csv:3:1: a second collide row, after line 2: expected one only");
    assertThat(refused("gravity,0,0\nline,1,2,3,4\ngravity,0,0"))
        .hasMessage("scene.csv:3:1: a second gravity row, after line 1: expected one only");
  }

  /** Such a circle shows only at the end of the file, when the largest coordinate is known. */
  @Test
  void aRadiusTooSmallForTheScene() {
    String circles = "circle,0,0,1,0,0\r\n".repeat(50);
    assertThat(refused(circles + "circle, 0, 0, 1e-10,0,0\r\ncircle,0,0,1e-11,0,0\r\npeg,0,1024,1"))
        .hasMessage(
            "scene.csv:51:15: radius is 1.0E-10: expected at least 2.3283064365386963E-10,"
                + " 2^10 ulps of the largest coordinate, 1024.0");
  }

  @Test
  void columnsDoNotCountAByteOrderMark() {
    assertThat(refused("\ufeffline,x,2,3,4"))
        .hasMessage("scene.csv:1:6: ax is \"x\": expected a finite number");
  }

  @Test
  void aFileIsNamedByItsPath(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("bad.csv"), "wall,0,0,800,600\r\nline,1,2\r\n");
    SceneFormatException e =
        catchThrowableOfType(SceneFormatException.class, () -> Scene.read(file));
    assertThat(e).hasMessage(file + ":2:9: bx is missing: expected line,ax,ay,bx,by");
  }

  /** A mistaken argument: the first bytes of a compressed file. */
  @Test
  void aFileThatIsNotText(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("scene.csv.gz");
    Files.write(file, new byte[] {0x1f, (byte) 0x8b, 8, 0, 0, 0});
    SceneFormatException e =
        catchThrowableOfType(SceneFormatException.class, () -> Scene.read(file));
    assertThat(e).hasMessageContaining(":1:1: \"\\u001f\\ufffd\\u0008");
  }
}
