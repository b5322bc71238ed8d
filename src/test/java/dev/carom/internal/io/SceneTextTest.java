// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.io;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SceneTextTest {

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0, -0.0",
    "+1, 1",
    "007, 7",
    "12., 12",
    ".5, 0.5",
    "-.5e1, -5",
    "1e3, 1000",
    "1E+3, 1000",
    "25e-2, 0.25",
    "0x1p4, 16",
    "-0X1.8P-1, -0.75",
    "0x.8p0, 0.5",
    "4.9e-324, 4.9e-324",
    "1e-400, 0",
    "1.7976931348623157e308, 1.7976931348623157e308",
    "0x0.0000000000001p-1022, 4.9e-324",
    "0x1.fffffffffffffp1023, 1.7976931348623157e308",
  })
  void decimalAndHexNumbers(String text, double number) {
    assertThat(Double.doubleToRawLongBits(SceneText.finite(text)))
        .isEqualTo(Double.doubleToRawLongBits(number));
  }

  /** Among them all that Double.parseDouble takes and a scene file must not. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "abc",
        "NaN",
        "+NaN",
        "Infinity",
        "-Infinity",
        "inf",
        "1e309",
        "-1e309",
        "0x1p1024",
        "1.5f",
        "1.5d",
        "1.5F",
        "1.5D",
        "0x1p3d",
        "0x1p3f",
        " 1",
        "1 ",
        "\u00011",
        "1\u0001",
        "1\u00a0",
        "1 2",
        "1,5",
        "1_000",
        "--1",
        "+-1",
        "1e",
        "1e+",
        "e5",
        ".",
        "+",
        "-",
        "0x",
        "0x1",
        "0x1.8",
        "0xp1",
        "1.2.3",
        "\u0661",
        "1e5.0"
      })
  void everythingElse(String text) {
    assertThat(SceneText.finite(text)).isNaN();
  }

  @Test
  void quotationsAreShortAndVisible() {
    assertThat(SceneText.quoted("abc")).isEqualTo("\"abc\"");
    assertThat(SceneText.quoted("a ~\u007f")).isEqualTo("\"a ~\\u007f\"");
    assertThat(SceneText.quoted("")).isEqualTo("\"\"");
    assertThat(SceneText.quoted("a\"b\\c")).isEqualTo("\"a\\\"b\\\\c\"");
    assertThat(SceneText.quoted("a\u001b\u00e9")).isEqualTo("\"a\\u001b\\u00e9\"");
    assertThat(SceneText.quoted("x".repeat(40))).isEqualTo("\"" + "x".repeat(40) + "\"");
    assertThat(SceneText.quoted("x".repeat(41))).isEqualTo("\"" + "x".repeat(40) + "...\"");
  }

  @Test
  void countsTheCharsBeforeAPlace() {
    assertThat(SceneText.count(',', ",a,b,c", 4)).isEqualTo(2);
    assertThat(SceneText.count(',', ",a,b,c", 6)).isEqualTo(3);
    assertThat(SceneText.count(',', "abc", 3)).isZero();
  }
}
