// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Outline;
import dev.carom.Scene;
import java.io.IOException;
import java.io.StringReader;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Runs the samples of the library's Javadoc; what they print stands behind each line in them. */
class JavadocTest {

  private static final Path SOURCES = Path.of("../src/main/java/dev/carom");
  private static final Path GUIDES = Path.of("../src/main/javadoc/dev.carom/dev/carom/doc-files");
  private static final Pattern SAMPLE =
      Pattern.compile("<pre>\\{@code\\n(.*?)\\n[ *]*\\}</pre>", Pattern.DOTALL);
  private static final Pattern RECIPE =
      Pattern.compile("<pre><code>(.*?)</code></pre>", Pattern.DOTALL);
  private static final Pattern LINK = Pattern.compile("href=\"([^\":]*)\"");
  private static final Pattern COMMENT =
      Pattern.compile("/\\*\\*(.*?)\\*/\\s*(?:@Override\\s*)?(.*)", Pattern.DOTALL);
  private static final Pattern PRINTED =
      Pattern.compile("System\\.out\\.println\\(.*\\); // (.*)$", Pattern.MULTILINE);
  private static final Pattern SCENE =
      Pattern.compile("<pre>\\n([ *]*# .*?)</pre>", Pattern.DOTALL);
  private static final Pattern PICTURE =
      Pattern.compile("<img src=\"([^\"]*)\"\\s+alt=\"[^\"]{20}");

  @TempDir private Path folder;

  @TestFactory
  Stream<DynamicTest> samplesPrintWhatTheySay() throws IOException {
    List<DynamicTest> tests =
        texts().flatMap(file -> samples(file).map(text -> test(file, text))).toList();
    assertThat(tests).hasSizeGreaterThan(7);
    return tests.stream();
  }

  @Test
  void eachRecipeIsAProgram() throws IOException {
    String[] recipes = read(GUIDES.resolve("recipes.html")).split("<h2 ", -1);
    assertThat(recipes).hasSizeGreaterThan(6);
    for (int i = 1; i < recipes.length; i++) {
      assertThat(recipes[i]).containsPattern(RECIPE);
    }
  }

  @Test
  void linksLeadSomewhere() throws IOException {
    for (Path file : texts().toList()) {
      boolean guide = file.startsWith(GUIDES);
      for (String link : find(LINK, read(file)).toList()) {
        String target = guide ? Path.of("doc-files", link).normalize().toString() : link;
        if (link.startsWith("#")) {
          target = (guide ? "doc-files/" + file.getFileName() : "package-summary.html") + link;
        }
        assertThat(leads(target)).as("%s: %s", file, link).isTrue();
      }
    }
  }

  /** Whether a page of the Javadoc, named from the folder of the package, has what is linked. */
  private static boolean leads(String target) {
    String page = target.replaceAll("#.*", "");
    String anchor = target.contains("#") ? target.substring(target.indexOf('#') + 1) : "";
    if (target.contains("stylesheet.css")) {
      return true; // which the tool writes
    }
    boolean guide = page.startsWith("doc-files/");
    String source = page.replace(".html", ".java").replace("package-summary", "package-info");
    Path file = guide ? GUIDES.resolve(page.substring(10)) : SOURCES.resolve(source);
    if (anchor.isEmpty()) {
      return Files.exists(file);
    }
    return (guide || source.equals("package-info.java"))
        ? read(file).contains("id=\"" + anchor + "\"")
        : isMember(page.replace(".html", ""), anchor);
  }

  private static boolean isMember(String type, String anchor) {
    try {
      Class<?> found = Class.forName("dev.carom." + type);
      return Stream.concat(
              Stream.of(found.getMethods()).map(JavadocTest::anchor),
              Stream.of(found.getFields()).map(Field::getName))
          .anyMatch(anchor::equals);
    } catch (ClassNotFoundException e) {
      return false;
    }
  }

  private static String anchor(Method method) {
    return method.getName()
        + Stream.of(method.getParameterTypes())
            .map(Class::getTypeName)
            .collect(Collectors.joining(",", "(", ")"));
  }

  /** First sentences of the public package are short and complete, and methods say what they do. */
  @Test
  void firstSentencesAreComplete() throws IOException {
    List<String> wrong = new ArrayList<>();
    try (Stream<Path> files = Files.list(SOURCES)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
        for (String part : read(file).split("(?=/\\*\\*)", -1)) {
          Matcher comment = COMMENT.matcher(part);
          if (comment.lookingAt()) {
            String sentence = firstSentence(comment.group(1));
            String declaration = comment.group(2).lines().findFirst().orElse("");
            if (!isComplete(sentence, declaration)) {
              wrong.add(file.getFileName() + ": " + sentence);
            }
          }
        }
      }
    }
    assertThat(wrong).isEmpty();
  }

  private static boolean isComplete(String sentence, String declaration) {
    int words = sentence.split(" ", -1).length;
    boolean method = declaration.matches(" *public (?!.*record |.*class |.*=).*\\(.*");
    return words >= 3
        && words <= 28
        && !sentence.matches("(What|Who|Whether|Of|When|Which|How|Where|Why|That|Those)\\b.*")
        && (!method || sentence.matches("[A-Z][a-z]+s\\b.*"));
  }

  private static String firstSentence(String comment) {
    String text =
        plain(comment)
            .replaceAll("\\{@\\w+ (\\S*?)( [^}]*)?\\}", "$1")
            .replaceAll("(?s)\n@.*|<p>.*|<pre>.*|<ul>.*", "")
            .replaceAll("\\s+", " ")
            .strip();
    return text.replaceAll("(?<=[.?!]) .*", "");
  }

  private DynamicTest test(Path file, String text) {
    String expected = find(PRINTED, text).collect(Collectors.joining("\n"));
    return DynamicTest.dynamicTest(
        file.getFileName().toString(),
        () -> {
          Path own = Files.createTempDirectory(folder, "sample");
          assertThat(JavaSample.run(text + "\n", own).strip()).isEqualTo(expected);
        });
  }

  @Test
  void theSceneFileCanBeRead() throws IOException {
    String javadoc = Files.readString(SOURCES.resolve("Scene.java"));
    List<String> files = find(SCENE, javadoc).map(JavadocTest::plain).toList();
    assertThat(files).hasSize(1);
    Scene scene = Scene.read(new StringReader(files.get(0)), "Javadoc");
    assertThat(scene.count(Kind.PEG) * scene.count(Kind.CIRCLE)).isEqualTo(1);
    assertThat(scene.shape(Kind.LINE, 0)).isInstanceOf(Line.class);
    assertThat(scene.shape(Kind.LINE, 1)).isInstanceOf(Outline.class);
  }

  @Test
  void picturesAreThereAndToldInWords() throws IOException {
    String all = texts().map(JavadocTest::read).collect(Collectors.joining());
    List<String> shown =
        find(PICTURE, all).map(name -> name.replace("doc-files/", "")).distinct().toList();
    assertThat(all.split("<img ", -1)).hasSize((int) find(PICTURE, all).count() + 1);
    try (Stream<Path> files = Files.list(GUIDES)) {
      assertThat(files.map(file -> file.getFileName().toString()).filter(n -> n.endsWith(".svg")))
          .containsExactlyInAnyOrderElementsOf(shown);
    }
  }

  private static Stream<Path> sources() throws IOException {
    try (Stream<Path> files = Files.walk(SOURCES)) {
      return files.filter(file -> file.toString().endsWith(".java")).sorted().toList().stream();
    }
  }

  /** The sources with their Javadoc, and the guides beside it. */
  private static Stream<Path> texts() throws IOException {
    try (Stream<Path> files = Files.list(GUIDES)) {
      List<Path> guides = files.filter(file -> file.toString().endsWith(".html")).sorted().toList();
      return Stream.concat(sources(), guides.stream());
    }
  }

  private static Stream<String> samples(Path file) {
    String text = read(file);
    return Stream.concat(
        find(SAMPLE, text).map(JavadocTest::plain), find(RECIPE, text).map(JavadocTest::unescaped));
  }

  private static String unescaped(String html) {
    return html.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
  }

  private static Stream<String> find(Pattern pattern, String text) {
    return pattern.matcher(text).results().map((MatchResult found) -> found.group(1));
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new AssertionError(file + " cannot be read", e);
    }
  }

  /** Without the stars at the margin. */
  private static String plain(String javadoc) {
    return Pattern.compile("^ *\\* ?", Pattern.MULTILINE).matcher(javadoc).replaceAll("");
  }
}
