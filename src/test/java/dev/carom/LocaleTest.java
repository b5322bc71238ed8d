// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** No text of the library depends on the language of the machine. */
class LocaleTest {

  /** Its digits are not those of ASCII. */
  private static final Locale ARABIC = Locale.forLanguageTag("ar-EG-u-nu-arab");

  private static final Pattern LITERAL = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"");

  /** All but %s, %n, %x and %%: these alone are written without regard to the locale. */
  private static final Pattern LOCALIZED = Pattern.compile("%[-#+ 0,(.\\d$]*[a-zA-Z&&[^snx]]");

  private final Locale usual = Locale.getDefault();

  @BeforeEach
  void speakArabic() {
    Locale.setDefault(ARABIC);
    assertThat("%d".formatted(12)).isEqualTo("١٢");
  }

  @AfterEach
  void speakAsBefore() {
    Locale.setDefault(usual);
  }

  @Test
  void stringsHaveLatinDigits() {
    Scene scene = Scene.builder().bounds(0, 0, 10, 10).peg(5, 5, 1).circle(2, 5, 1, 1, 0).build();
    World world = new World(scene);
    world.step(3);
    List<Object> all =
        List.of(
            scene,
            world,
            world.snapshot(),
            world.impacts(),
            Resolver.of(List.of(new Circle(5, 5, 1)))
                .trace(
                    new SweptCircle(new Circle(2, 5, 1), new Vec2(1, 0)), 1, 3, Integer.MAX_VALUE));
    assertThat(all).extracting(Object::toString).allMatch(LocaleTest::isLatin);
    assertThat(scene.toString()).startsWith("Scene[circles=1, lines=0, pegs=1, bounds=");
  }

  @Test
  void messagesHaveLatinDigits() {
    assertThatThrownBy(() -> Scene.read(new StringReader("circle,1,2,3,\u0660,5"), "text"))
        .hasMessageContaining("\\u0660")
        .matches(e -> isLatin(e.getMessage()));
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).build());
    assertThatThrownBy(() -> world.x(12)).matches(e -> isLatin(e.getMessage()));
  }

  /** No other text is made by a format either that writes digits as the locale does. */
  @Test
  void noFormatIsLocalized() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of("main/java"))) {
      for (Path file : files.filter(path -> path.toString().endsWith(".java")).toList()) {
        assertThat(LITERAL.matcher(Files.readString(file)).results())
            .as(file.toString())
            .noneMatch(literal -> LOCALIZED.matcher(literal.group()).find());
      }
    }
  }

  private static boolean isLatin(String text) {
    return text.chars().allMatch(c -> c < 128);
  }
}
