// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which packages there are, and which of the others each of them may use. */
class ArchitectureTest {

  private static final String API = "dev.carom";

  private static final String INTERNAL = "dev.carom.internal.";

  private static final String GEOMETRY = "Vec2 Obstacle Circle Line Outline Bounds PublicRecords";

  private static final String DETECTOR = " SweptCircle SweptSphere Impact Outcome Kind Feature";

  private static final String RESOLVER =
      " Filter Resolver Nearest Contact Questions Casts Trajectory ImpactLog Flight";

  private static final String WORLD =
      " Scene SceneBuilder SceneFormatException Response Traits Warning World WorldQueries"
          + " UnfinishedException Snapshot Timeline RecordedEdits Uncertainty";

  private static final Class<?> REFUSAL = IllegalArgumentException.class;

  private static final JavaClasses CLASSES =
      new ClassFileImporter().importPath(Path.of("target/classes"));

  /** From below upwards; none may use what stands after it. */
  private static final List<String> PACKAGES =
      List.of(
          "util",
          "exact",
          "sweep",
          "state",
          "search",
          "response",
          "queue",
          "engine",
          "query",
          "io");

  @Test
  void thereAreNoOthers() {
    assertThat(CLASSES.stream().map(JavaClass::getPackageName).distinct())
        .containsExactlyInAnyOrderElementsOf(
            Stream.concat(PACKAGES.stream().map(INTERNAL::concat), Stream.of(API))
                .collect(Collectors.toList()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "util     |",
        "exact    | util",
        "sweep    | exact util",
        "state    | sweep exact util",
        "search   | state sweep exact util",
        "response | state sweep exact util",
        "queue    | state util",
        "engine   | queue response search state sweep exact util",
        "query    | response search state sweep exact util",
        "io       | state util",
      })
  void eachUsesThoseBelow(String name, String others) {
    String[] allowed =
        Stream.concat(
                Stream.of(name), Arrays.stream(others == null ? new String[0] : others.split(" ")))
            .map(INTERNAL::concat)
            .toArray(String[]::new);
    noClasses()
        .that()
        .resideInAPackage(INTERNAL + name)
        .should()
        .dependOnClassesThat(resideInAPackage(API + "..").and(not(resideInAnyPackage(allowed))))
        .check(CLASSES);
  }

  /** The layers of the exported package, each of use without those after it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "geometry | " + GEOMETRY,
        "detector | " + GEOMETRY + DETECTOR,
        "resolver | " + GEOMETRY + DETECTOR + RESOLVER,
        "world    | " + GEOMETRY + DETECTOR + RESOLVER + WORLD,
      })
  void eachLayerUsesThoseBefore(String layer, String names) {
    Set<String> allowed = Set.of(names.split(" "));
    DescribedPredicate<JavaClass> below =
        DescribedPredicate.describe(
            "the layers up to " + layer, type -> allowed.contains(outermost(type)));
    noClasses()
        .that(below)
        .should()
        .dependOnClassesThat(resideInAPackage(API).and(not(below)))
        .check(CLASSES);
  }

  @Test
  void eachPublicClassIsInALayer() {
    assertThat(
            CLASSES.stream()
                .filter(type -> type.getPackageName().equals(API))
                .map(ArchitectureTest::outermost)
                .filter(name -> !name.equals("package-info"))
                .distinct())
        .containsExactlyInAnyOrder((GEOMETRY + DETECTOR + RESOLVER + WORLD).split(" "));
  }

  private static String outermost(JavaClass any) {
    JavaClass type = any.getBaseComponentType();
    String name = type.getName().substring(type.getPackageName().length() + 1);
    int inner = name.indexOf('$');
    return inner < 0 ? name : name.substring(0, inner);
  }

  @Test
  void noneUseEachOther() {
    slices().matching("dev.carom.(**)").should().beFreeOfCycles().check(CLASSES);
  }

  /** An internal exception reaches users as one of Java, or as that of the API. */
  @Test
  void noInternalExceptionLeavesTheLibrary() {
    assertThat(
            CLASSES.stream()
                .filter(type -> type.isAssignableTo(Throwable.class))
                .map(JavaClass::getSimpleName))
        .containsExactlyInAnyOrder("SceneFormatException", "RowException", "UnfinishedException");
    assertThatThrownBy(() -> new Vec2(Double.NaN, 0)).isExactlyInstanceOf(REFUSAL);
    World world = new World(Scene.builder().circle(0, 0, 1, 1, 0).build());
    assertThatThrownBy(() -> world.setShape(Kind.CIRCLE, 0, new Circle(world.x(0), world.y(0), -1)))
        .isExactlyInstanceOf(REFUSAL);
    assertThatThrownBy(() -> Scene.builder().peg(0, 0, -1)).isExactlyInstanceOf(REFUSAL);
    assertThatThrownBy(() -> Scene.read(new StringReader("peg,0,0,-1"), "text"))
        .isExactlyInstanceOf(SceneFormatException.class)
        .hasMessage("text:1:9: radius is -1.0: expected a finite number, at least 0");
  }

  /** {@link Math#fma} is slow where the processor has no instruction for it. */
  @Test
  void onlyFmaCallsThatOfMath() {
    for (Class<?> type : List.of(double.class, float.class)) {
      noClasses()
          .that()
          .doNotHaveFullyQualifiedName(INTERNAL + "exact.Fma")
          .should()
          .callMethod(Math.class, "fma", type, type, type)
          .check(CLASSES);
    }
  }

  @Test
  void theLibraryNeedsNothingButJava() {
    classes()
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(API + "..", "java..")
        .check(CLASSES);
  }

  /** A public signature names public types only. */
  @Test
  void nothingInternalIsSeenFromOutside() {
    List<JavaClass> api =
        CLASSES.stream()
            .filter(c -> c.getPackageName().equals(API))
            .filter(c -> c.getModifiers().contains(JavaModifier.PUBLIC))
            .toList();
    assertThat(api).hasSizeGreaterThan(20);
    for (JavaClass type : api) {
      assertThat(seen(type)).as(type.getName()).noneMatch(name -> name.startsWith(INTERNAL));
    }
  }

  private static List<String> seen(JavaClass type) {
    Stream<JavaClass> ofMethods =
        type.getCodeUnits().stream()
            .filter(unit -> isSeen(unit.getModifiers()))
            .flatMap(ArchitectureTest::types);
    Stream<JavaClass> ofFields =
        type.getFields().stream()
            .filter(field -> isSeen(field.getModifiers()))
            .map(JavaField::getRawType);
    Stream<JavaClass> parents =
        Stream.concat(type.getRawSuperclass().stream(), type.getRawInterfaces().stream());
    return Stream.of(ofMethods, ofFields, parents)
        .flatMap(types -> types)
        .map(c -> c.getBaseComponentType().getName())
        .toList();
  }

  private static Stream<JavaClass> types(JavaCodeUnit unit) {
    Collection<JavaClass> thrown =
        unit.getThrowsClause().getTypes().stream().map(t -> t.toErasure()).toList();
    return Stream.of(
            Stream.of(unit.getRawReturnType()),
            unit.getRawParameterTypes().stream(),
            thrown.stream())
        .flatMap(types -> types);
  }

  private static boolean isSeen(Collection<JavaModifier> modifiers) {
    return modifiers.contains(JavaModifier.PUBLIC) || modifiers.contains(JavaModifier.PROTECTED);
  }
}
