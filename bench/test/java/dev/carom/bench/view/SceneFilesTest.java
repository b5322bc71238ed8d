// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.view;

import static org.assertj.core.api.Assertions.assertThat;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Scene;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneFilesTest {

  private static final Scene SCENE =
      Scene.builder()
          .bounds(0, 0, 100, 60)
          .line(20, 10, 60, 10)
          .restitution(0.5)
          .circle(50, 30, 10, 8, 0)
          .build();

  private final Player player = new Player(SCENE, 1);
  private final ViewPanel panel = new ViewPanel(player);
  private final Answers dialogs = new Answers();
  private final SceneFiles files = new SceneFiles(panel, dialogs);
  private final List<String> titles = new ArrayList<>();

  @TempDir private Path folder;

  /** A user who answers as the test says. */
  private static final class Answers implements Dialogs {

    private final List<String> errors = new ArrayList<>();
    private final List<String> questions = new ArrayList<>();
    private Optional<Path> file = Optional.empty();
    private boolean yes;

    @Override
    public Optional<Path> chooseToOpen() {
      return file;
    }

    @Override
    public Optional<Path> chooseToSave() {
      return file;
    }

    @Override
    public boolean replaces(String question) {
      questions.add(question);
      return yes;
    }

    @Override
    public void shows(String title, String error) {
      errors.add(title + ": " + error);
    }
  }

  @Test
  void savesWhatIsShownAndOpensIt() throws Exception {
    panel.onTitle(titles::add);
    player.nextImpact();
    player.nextImpact();
    player.seek(5);
    Path file = folder.resolve("now.csv");
    dialogs.file = Optional.of(file);
    files.save();
    Scene saved = Scene.read(file);
    assertThat(((Circle) saved.shape(Kind.CIRCLE, 0)).x()).isEqualTo(90);
    assertThat(saved.velocity(Kind.CIRCLE, 0).x()).isEqualTo(-8);
    assertThat(saved.traits(Kind.LINE, 0).restitution()).isEqualTo(0.5);
    player.restart();
    player.setRunning(true);
    files.open();
    assertThat(player.scene()).isEqualTo(saved);
    assertThat(player.isRunning()).isFalse();
    assertThat(panel.status()).endsWith("loaded " + file);
    assertThat(titles).containsExactly("now.csv", "now.csv");
    assertThat(dialogs.errors).isEmpty();
  }

  @Test
  void doesNothingWithoutAFile() {
    files.open();
    files.save();
    assertThat(player.scene()).isEqualTo(SCENE);
    assertThat(dialogs.errors).isEmpty();
  }

  @Test
  void asksBeforeAFileIsReplaced() throws Exception {
    Path file = folder.resolve("mine.csv");
    Files.writeString(file, "precious");
    files.save(file);
    assertThat(dialogs.questions).containsExactly("mine.csv is there already. Replace it?");
    assertThat(file).hasContent("precious");
    dialogs.yes = true;
    files.save(file);
    assertThat(Scene.read(file)).isEqualTo(SCENE);
  }

  @Test
  void tellsWhereABadFileIsWrongAndKeepsTheOldScene() throws Exception {
    Path file = folder.resolve("bad.csv");
    Files.writeString(file, "# a scene\ncircle,1,2,x,0,0\n");
    player.stepFrame();
    files.open(file);
    assertThat(dialogs.errors)
        .containsExactly(
            String.format(
                "This is no scene: %s%nline 2, column 12:%n%s",
                file, "radius is \"x\": expected a finite number"));
    assertThat(player.shown()).isEqualTo(1);
    assertThat(((Circle) player.scene().shape(Kind.CIRCLE, 0)).x()).isEqualTo(58);
  }

  @Test
  void tellsWhichFileCannotBeReadOrWritten() {
    Path none = folder.resolve("none.csv");
    files.open(none);
    assertThat(dialogs.errors)
        .containsExactly(String.format("Cannot be opened: %s%n%s", none, "NoSuchFileException"));
    Path nowhere = folder.resolve("no/such/folder.csv");
    files.save(nowhere);
    assertThat(dialogs.errors.get(1)).startsWith("Cannot be saved: " + nowhere);
    assertThat(player.scene()).isEqualTo(SCENE);
  }
}
