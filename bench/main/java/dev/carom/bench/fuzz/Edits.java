// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.fuzz;

import dev.carom.Circle;
import dev.carom.Kind;
import dev.carom.Line;
import dev.carom.Outline;
import dev.carom.Snapshot;
import dev.carom.Traits;
import dev.carom.Vec2;
import dev.carom.World;
import dev.carom.bench.charts.Sides;
import java.util.Random;

/** Random edits; one that is refused must leave the world as it was. */
final class Edits {

  private static final int MOST_CIRCLES = 10;

  private final Random random;
  private final Numbers numbers;
  private final Variation variation;
  private final SessionScene draws;
  private final World world;

  Edits(Random random, Numbers numbers, Variation variation, SessionScene draws, World world) {
    this.random = random;
    this.numbers = numbers;
    this.variation = variation;
    this.draws = draws;
    this.world = world;
  }

  void edit() throws FindingException {
    Snapshot before = world.snapshot();
    try {
      make(random.nextInt(14));
    } catch (IllegalArgumentException e) {
      if (!world.snapshot().equals(before)) {
        throw new FindingException("an edit that was refused changed the world: " + e, e);
      }
    }
  }

  private void make(int what) {
    switch (what) {
      case 0, 1 -> world.setVelocity(circle(), numbers.speed(), numbers.speed());
      case 2, 3 -> {
        int id = circle();
        Vec2 place = variation.place(numbers.x(), numbers.y());
        world.setPosition(id, place.x(), place.y());
      }
      case 4 -> {
        int id = circle();
        world.setShape(Kind.CIRCLE, id, new Circle(world.x(id), world.y(id), numbers.radius()));
      }
      case 5 -> {
        int id = circle();
        world.setTraits(Kind.CIRCLE, id, world.traits(Kind.CIRCLE, id).withMass(numbers.mass()));
      }
      case 6 -> addCircle();
      case 7 -> world.addLine(numbers.x(), numbers.y(), numbers.x(), numbers.y(), Traits.DEFAULT);
      case 8 -> world.addPeg(numbers.x(), numbers.y(), numbers.pegRadius(), Traits.DEFAULT);
      case 9, 10 -> moveObstacle();
      case 11 -> remove();
      case 12 -> setRestitution();
      default -> setTraits();
    }
  }

  /** The id of a circle, of those that are there; there is always one. */
  private int circle() {
    return some(Kind.CIRCLE);
  }

  private int some(Kind kind) {
    int end = world.idLimit(kind);
    int first = end == 0 ? 0 : random.nextInt(end);
    for (int i = 0; i < end; i++) {
      int id = (first + i) % end;
      if (world.contains(kind, id)) {
        return id;
      }
    }
    return -1;
  }

  private void addCircle() {
    if (world.count(Kind.CIRCLE) < MOST_CIRCLES) {
      Vec2 place = variation.place(numbers.x(), numbers.y());
      world.addCircle(
          place.x(), place.y(), numbers.radius(), numbers.speed(), numbers.speed(), Traits.DEFAULT);
    }
  }

  private void moveObstacle() {
    boolean line = random.nextBoolean();
    int id = some(line ? Kind.LINE : Kind.PEG);
    if (id >= 0 && line && world.shape(Kind.LINE, id) instanceof Outline outline) {
      Vec2 by = new Vec2(numbers.step(), numbers.step());
      world.setShape(Kind.LINE, id, Sides.moved(outline, by));
    } else if (id >= 0 && line) {
      world.setShape(Kind.LINE, id, new Line(numbers.x(), numbers.y(), numbers.x(), numbers.y()));
    } else if (id >= 0) {
      world.setShape(Kind.PEG, id, new Circle(numbers.x(), numbers.y(), numbers.pegRadius()));
    }
  }

  private void remove() {
    Kind kind = Kind.values()[1 + random.nextInt(3)];
    int id = some(kind);
    if (id >= 0 && (kind != Kind.CIRCLE || world.count(Kind.CIRCLE) > 1)) {
      world.remove(kind, id);
    }
  }

  private void setRestitution() {
    Kind kind = Kind.values()[random.nextInt(4)];
    int id = some(kind);
    if (id >= 0) {
      world.setTraits(kind, id, world.traits(kind, id).withRestitution(draws.restitution()));
    }
  }

  private boolean isSolid(int line) {
    return world.shape(Kind.LINE, line) instanceof Outline outline && outline.solid();
  }

  private void setTraits() {
    Kind kind = Kind.values()[random.nextInt(4)];
    int id = some(kind);
    if (id >= 0) {
      world.setTraits(kind, id, world.traits(kind, id).withResponse(draws.response(kind)));
    }
    if (id >= 0 && kind == Kind.LINE && draws.hasTraits() && !isSolid(id)) {
      world.setTraits(
          Kind.LINE, id, world.traits(Kind.LINE, id).withOneWay(random.nextInt(3) == 0));
    }
  }
}
