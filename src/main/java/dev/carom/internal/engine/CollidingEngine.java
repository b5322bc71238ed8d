// SPDX-License-Identifier: Apache-2.0
package dev.carom.internal.engine;

import dev.carom.internal.exact.ExactBudget;
import dev.carom.internal.response.ObstacleResponse;
import dev.carom.internal.response.PairResponse;
import dev.carom.internal.response.Shock;
import dev.carom.internal.state.CircleRegistry;
import dev.carom.internal.state.CircleTable;
import dev.carom.internal.state.Codes;
import dev.carom.internal.state.EngineDescription;
import dev.carom.internal.state.EngineOptions;
import dev.carom.internal.state.FlightRow;
import dev.carom.internal.state.FlightTable;
import dev.carom.internal.state.IgnoreList;
import dev.carom.internal.state.ImpactRows;
import dev.carom.internal.state.LiveCodes;
import dev.carom.internal.state.MovingCircle;
import dev.carom.internal.state.ObstacleTable;
import dev.carom.internal.state.SceneData;
import dev.carom.internal.util.Index;
import dev.carom.internal.util.IntList;
import dev.carom.internal.util.KindNumber;
import java.util.Arrays;
import java.util.Collection;

/**
 * The engine for circles that collide: it handles event after event, in order of time.
 *
 * <p>{@link EventScheduler} finds the next event of each circle, and the order of all. When a
 * circle's velocity changes, its change count goes up and its next event is predicted anew. Another
 * circle's predicted collision with it is then stale, which shows by the count.
 *
 * <p>The time at which two circles collide depends on their two flights alone. The search starts at
 * the start of the later flight, from the position of the other circle at that time. So neither the
 * cells through which they found each other nor the steps of the caller change a bit of it.
 */
public final class CollidingEngine extends Engine {

  /**
   * After so many collisions for each circle, the engine looks whether most have left the narrow
   * cells. As many collisions take several times as long as to make new cells.
   */
  private static final int COLLISIONS_BETWEEN_LOOKS = 8;

  /** The visits of contacts in a solve that count as one event: they take about as long. */
  private static final int VISITS_PER_EVENT = 64;

  private final EngineOptions options;

  private final PairResponse pairs;
  private final Shock shock;
  private final Contacts contacts;
  private EventScheduler scheduler;

  /**
   * The time of the last cell crossing. If it is also the time of the last event, the true crossing
   * may be slightly later by rounding. Then some circles are already in the cells of that later
   * moment.
   */
  private double crossed;

  /** The time of the last start of a flight or contact reported by a sensor, as head and tail. */
  private double lastEvent;

  private double lastEventTail;

  /** After so many more collisions, the engine looks where the circles are. */
  private int untilLook;

  /** The end of the current step. */
  private double end;

  /** No event comes before this time, ticks apart. */
  private double quietUntil;

  /** Whether this step ends at the first impact. */
  private boolean stopsAtImpact;

  /** Whether an edit needs more room or other cells than exist. */
  private boolean outgrown;

  private final MovingCircle other = new MovingCircle();

  public CollidingEngine(
      SceneData scene, CircleRegistry registry, EngineOptions options, ImpactRows log) {
    super(scene, registry, CircleTable.colliding(scene.circleCount()), options, log);
    this.options = options;
    pairs = new PairResponse(registry, response);
    contacts = new Contacts(this, log);
    shock = new Shock(registry, staticScene.obstacles, staticScene::addNear, contacts);
    response.ask(shock);
    int count = circles.count;
    for (int i = 0; i < count; i++) {
      circles.start(scene, i);
      release(circles.body);
      circles.put(i, circles.body);
    }
    contacts.reset();
    begin();
  }

  EventScheduler scheduler() {
    return scheduler;
  }

  /** Adds the circles near a place; all of them while they outgrow the cells. */
  void addNear(double x, double y, double distance, IntList into) {
    if (!outgrown) {
      scheduler.addNear(x, y, distance, into);
      return;
    }
    for (int slot : registry.slots()) {
      into.add(slot);
    }
  }

  /** Rebuilds the scheduler and all predictions from the flights. */
  private void begin() {
    crossed = Double.NaN;
    double diameters = options.pairCells();
    scheduler =
        new EventScheduler(circles, registry, staticScene, pairs, contacts, diameters, reached);
    contacts.makeRoom(reached);
    for (int i : registry.slots()) {
      scheduler.findNextObstacle(circles.state, circles.codes, i);
      scheduler.predict(i);
    }
  }

  @Override
  public EngineDescription description() {
    return staticScene.model(true);
  }

  @Override
  double playToImpact(double end, long work) {
    stopsAtImpact = true;
    double time = play(end, work);
    stopsAtImpact = false;
    return time;
  }

  private void stopAt(double head, double tail) {
    end = Math.min(end, MovingCircle.firstNotBefore(head, tail));
  }

  @Override
  double play(double last, long work) {
    unfinished = false;
    if (last < quietUntil && last < contacts.nextTick()) {
      reached = last;
      return last;
    }
    end = last;
    prepare(last);
    if (outgrown || isRegionLeft()) {
      outgrown = false;
      begin();
    }
    scheduler.beginStep();
    spent += handleEvents(work);
    return reached;
  }

  /** Handles the events of the current step until the budget is spent; returns the work done. */
  private long handleEvents(long budget) {
    double[] s = circles.state;
    int[] c = circles.codes;
    ExactBudget work = ExactBudget.ofThread();
    long before = work.bits();
    long visits = contacts.work();
    for (long events = 0; ; events++) {
      double tick = contacts.nextTick();
      long solved = (contacts.work() - visits) / VISITS_PER_EVENT;
      long done = events + solved + work.impactsSince(before);
      if (done >= budget && (tick <= end || scheduler.firstTime() <= end)) {
        unfinished = true;
        return done;
      }
      // A tick comes before other events at its time.
      int i = scheduler.poll(tick <= end ? Math.nextDown(tick) : end);
      if (i == Index.NONE) {
        if (tick <= end) {
          advanceClock(tick);
          contacts.tick(reached);
          continue;
        }
        reached = end;
        quietUntil = scheduler.firstTime();
        return done;
      }
      advanceClock(scheduler.polledTime());
      int kind = EventScheduler.kind(c, i);
      if (kind >= EventKind.CROSSING) { // most events are crossings
        crossed = reached;
        scheduler.cross(s, c, i, kind - EventKind.CROSSING);
      } else {
        handle(s, c, i, kind);
      }
    }
  }

  /** Whether most circles are far from where the cells are narrow; it looks only now and then. */
  private boolean isRegionLeft() {
    if (untilLook > 0) {
      return false;
    }
    untilLook = COLLISIONS_BETWEEN_LOOKS * registry.count();
    return scheduler.isRegionLeft(registry.present());
  }

  /**
   * The circle with the most impacts in the log; if the log is empty, the circle with the next
   * event.
   */
  @Override
  public int spender() {
    if (log.size() == 0) {
      return scheduler.first();
    }
    int[] impacts = new int[circles.count];
    int most = log.circle(0);
    for (int row = 0; row < log.size(); row++) {
      impacts[log.circle(row)]++;
      if (log.kind(row) == KindNumber.CIRCLE) {
        impacts[log.obstacle(row)]++;
      }
    }
    for (int i = 0; i < impacts.length; i++) {
      most = impacts[i] > impacts[most] ? i : most;
    }
    return most;
  }

  /**
   * Advances the clock to a time. Rounding may delay the notice of a crossing; time does not go
   * back for it.
   */
  private void advanceClock(double time) {
    if (time > reached) {
      reached = time;
    }
  }

  private void handle(double[] s, int[] c, int i, int kind) {
    switch (kind) {
      case EventKind.STATIC -> meetObstacle(i);
      case EventKind.PAIR -> {
        if (CollisionPredictor.isValid(c, i)) {
          meetCircle(s, c, i);
        } else {
          scheduler.predict(i);
        }
      }
      default -> { // an edit
        scheduler.findNextObstacle(s, c, i);
        scheduler.predict(i);
      }
    }
  }

  private void meetObstacle(int i) {
    circles.load(i);
    MovingCircle m = circles.body;
    if (m.next == MovingCircle.NOTHING) {
      staticScene.extend(m, m.cleared);
      circles.put(i, m);
      scheduler.schedule(i);
      return;
    }
    if (stopsAtImpact) {
      double head = m.after(m.cleared);
      stopAt(head, m.afterTail(m.cleared, head));
    }
    if (m.isMember() && !staticScene.obstacles.isSensor(m.next)) {
      contacts.meet(i, reached);
      return;
    }
    double vx = m.vx;
    double vy = m.vy;
    int result = response.resolve(m, log);
    boolean turned = m.vx != vx || m.vy != vy;
    switch (result) {
      case ObstacleResponse.SENSED -> {
        staticScene.extend(m, m.cleared);
        circles.put(i, m);
        scheduler.schedule(i);
      }
      case ObstacleResponse.STUCK -> {
        circles.put(i, m);
        leaveJamsOfInfinite(i, turned);
        resolveContacts(i);
      }
      case ObstacleResponse.JOIN -> {
        noteEvent(m.t, m.tl);
        circles.put(i, m);
        contacts.join(i, Index.NONE);
      }
      default -> {
        noteEvent(m.t, m.tl);
        startFlight(circles.state, circles.codes, i, m);
        leaveJamsOfInfinite(i, turned);
        reactivate(i);
        scheduler.predict(i);
      }
    }
  }

  /** Resolves the collision predicted of circle i, if it comes before all other events. */
  private void meetCircle(double[] s, int[] c, int i) {
    int j = CollisionPredictor.partner(c, i);
    if (CollisionPredictor.isOpen(s, i)) {
      if (!scheduler.confirm(s, c, i, j, end)) {
        return;
      }
      advanceClock(CollisionPredictor.time(s, i));
    }
    scheduler.cancel(j);
    int low = Math.min(i, j);
    int high = Math.max(i, j);
    circles.loadForMeeting(s, c, low, circles.body);
    circles.loadForMeeting(s, c, high, other);
    if (stopsAtImpact) {
      stopAt(CollisionPredictor.time(s, i), CollisionPredictor.tail(s, i));
    }
    if (meetMembers(circles.body, other)) {
      return;
    }
    switch (resolveMeeting(s, circles.body, other, i)) {
      case ObstacleResponse.SENSED -> {
        report(low, high, i);
        scheduler.predict(s, c, low, high);
      }
      case ObstacleResponse.STUCK -> {
        circles.put(low, circles.body);
        circles.put(high, other);
        resolveContacts(low, high);
      }
      case ObstacleResponse.JOIN -> {
        noteEvent(other.t, other.tl);
        boolean lowStays = circles.body.isMember();
        boolean highStays = other.isMember();
        storeFree(s, c, circles.body);
        storeFree(s, c, other);
        contacts.joinBoth(low, high);
        if (lowStays || highStays) {
          scheduler.predict(lowStays ? low : high); // on the same flight, past this collision
        }
      }
      default -> {
        noteEvent(other.t, other.tl); // for both
        startFlight(s, c, low, circles.body);
        startFlight(s, c, high, other);
        reactivate(low);
        reactivate(high);
        scheduler.predict(s, c, low, high);
      }
    }
  }

  /** A member at rest that meets something of another frame wakes. */
  private boolean meetMembers(MovingCircle a, MovingCircle b) {
    boolean are = (a.isMember() || isInfinite(a)) && (b.isMember() || isInfinite(b));
    if (!are || (!a.isMember() && !b.isMember()) || pairs.isSilent(a.id, b.id)) {
      return false;
    }
    int low = a.id;
    int high = b.id;
    boolean highMeets = b.isMember();
    if (a.isMember()) {
      contacts.meet(low, reached); // which may load others into both
    }
    if (highMeets) {
      contacts.meet(high, reached);
    }
    scheduler.predict(low);
    scheduler.predict(high);
    return true;
  }

  private boolean isInfinite(MovingCircle m) {
    return registry.mass(m.id) == Double.POSITIVE_INFINITY;
  }

  /** Stores a circle that joins, or an infinite mass that goes on, at the start of a new flight. */
  private void storeFree(double[] s, int[] c, MovingCircle m) {
    if (!m.isMember()) {
      circles.storeNewFlight(s, c, m.id, m);
      scheduler.comeBack(s, m.id);
      if (isInfinite(m)) {
        startFlight(s, c, m.id, m);
        scheduler.predict(m.id);
      }
    }
  }

  /**
   * Begins the flight of a member.
   *
   * @param alone whether there is no circle that it could meet
   */
  void beginMember(MovingCircle m, boolean alone) {
    noteEvent(m.t, m.tl);
    if (outgrown) {
      putFlight(circles.state, circles.codes, m.id, m); // all is predicted anew
      return;
    }
    scheduler.cancel(m.id);
    startFlight(circles.state, circles.codes, m.id, m);
    if (alone) {
      scheduler.predictAlone(m.id);
    } else {
      scheduler.predict(m.id);
    }
  }

  /** Stores the flight of a circle that left contact; its predictions follow. */
  void beginFreed(MovingCircle m) {
    scheduler.cancel(m.id);
    noteEvent(m.t, m.tl);
    putFlight(circles.state, circles.codes, m.id, m);
    scheduler.comeBack(circles.state, m.id);
  }

  /** Records the contact predicted of circle i, one of the two, which a sensor reported. */
  private void report(int low, int high, int i) {
    double head = CollisionPredictor.time(circles.state, i);
    double tail = CollisionPredictor.tail(circles.state, i);
    noteEvent(head, tail);
    circles.putSensed(low, head, tail, high);
    circles.putSensed(high, head, tail, low);
    noteChange(low, head);
    noteChange(high, head);
  }

  /** Advances two circles to the collision predicted of circle i, and resolves it. */
  private int resolveMeeting(double[] s, MovingCircle a, MovingCircle b, int i) {
    ObstacleTable obstacles = staticScene.obstacles;
    double tau = CollisionPredictor.tau(s, i);
    double head = CollisionPredictor.time(s, i);
    double tail = CollisionPredictor.tail(s, i);
    double later = (b.t - a.t) + (b.tl - a.tl);
    double ofA = CollisionPredictor.positive(later);
    double ofB = ofA - later;
    boolean standsStill = later > 0 ? b.isAt(head, tail) : a.isAt(head, tail);
    double flownA = a.advance(ofA, tau, head, tail, standsStill, obstacles);
    double flownB = b.advance(ofB, tau, head, tail, standsStill, obstacles);
    untilLook--;
    takeMomentum(a, ofA + tau);
    takeMomentum(b, ofB + tau);
    shock.forgetCrushersOf(a);
    shock.forgetCrushersOf(b);
    return pairs.resolve(a, flownA, b, flownB, tau, circles.allowsGravity(), log);
  }

  /** Gives an awake member its momentum, for the row of the impact. */
  private static void takeMomentum(MovingCircle m, double flown) {
    if (m.mode == MovingCircle.AWAKE) {
      m.vx = MovingCircle.velocity(m.px, m.ax, flown);
      m.vy = MovingCircle.velocity(m.py, m.ay, flown);
    }
  }

  /** Starts a new flight of a circle. */
  private void startFlight(double[] s, int[] c, int i, MovingCircle m) {
    putFlight(s, c, i, m);
    scheduler.comeBack(s, i);
    scheduler.findNextObstacle(s, c, i);
    if (registry.hasInfinite() && isInfinite(m)) {
      contacts.changed(Codes.circle(i), reached);
    }
  }

  private void putFlight(double[] s, int[] c, int i, MovingCircle m) {
    quietUntil = reached;
    circles.storeNewFlight(s, c, i, m);
    invalidate(c, i);
    if (recorder != null) {
      recorder.add(m, m.t);
    }
  }

  private void noteEvent(double head, double tail) {
    lastEventTail = head == lastEvent ? Math.max(lastEventTail, tail) : tail;
    lastEvent = head;
  }

  /** Resolves all contacts of stuck circles, and of all that touch them, at once. */
  private void resolveContacts(int... hit) {
    MovingCircle[] first =
        Arrays.stream(hit).mapToObj(contacts::copyOf).toArray(MovingCircle[]::new);
    begin(shock.resolve(log, first));
  }

  /** Begins new flights of circles. */
  private void begin(Collection<MovingCircle> members) {
    for (MovingCircle m : members) {
      scheduler.cancel(m.id);
      noteEvent(m.t, m.tl);
      startFlight(circles.state, circles.codes, m.id, m);
    }
    members.forEach(m -> reactivate(m.id));
    members.forEach(m -> scheduler.predict(m.id));
  }

  /**
   * Removes from a jammed circle's ignore list the circles that it now approaches or leaves by more
   * than rounding. Infinite masses that crushed it stay in the list until they have left it.
   */
  private void reactivate(int i) {
    IgnoreList jam = circles.jam(i);
    if (jam != null) {
      reactivate(i, jam);
    }
  }

  private void reactivate(int i, IgnoreList ignored) {
    IgnoreList jam = ignored;
    circles.load(i);
    for (int code : ignored.entries()) {
      if (Codes.isCircle(code)) {
        circles.load(Codes.slot(code), other);
        if (PairResponse.part(circles.body, other)) {
          jam = jam.without(code);
        }
      }
    }
    circles.jams[i] = jam;
    noteChange(i, circles.body.t);
  }

  /** Marks a circle as changed: predictions of collisions with it are stale. */
  private void invalidate(int[] c, int i) {
    c[CircleTable.collidingCodesAt(i) + CircleTable.COUNT]++;
  }

  // Edits.

  @Override
  void beginGravity() {
    outgrown = true; // the scheduler and the cells are those of straight flights
  }

  @Override
  void changeGravity() {
    contacts.reset();
  }

  @Override
  void leaveContact(MovingCircle m, double now) {
    contacts.leave(m, now);
  }

  @Override
  void noteContact(int code, double now) {
    contacts.changed(code, now);
  }

  @Override
  void saveContact(MovingCircle m) {
    contacts.save(m);
  }

  @Override
  void beginFlight(MovingCircle m) {
    // The new flight begins now, so all cells must be those of now.
    outgrown |= crossed == reached;
    int i = m.id;
    if (i == circles.count) {
      outgrown |= i == circles.capacity();
      circles.add();
    } else if (!outgrown) {
      scheduler.remove(i);
    }
    staticScene.setRadius(i, m.radius);
    circles.put(i, m);
    invalidate(circles.codes, i);
    if (recorder != null) {
      recorder.add(m, m.t);
    }
    outgrown = outgrown || !scheduler.enter(i, reached);
    repredict(i);
    if (registry.mass(i) == Double.POSITIVE_INFINITY) {
      leaveJamsOf(i);
      contacts.changed(Codes.circle(i), reached);
    }
  }

  /** Schedules a new prediction of a circle for the next step, when all edits are done. */
  private void repredict(int i) {
    quietUntil = reached;
    if (!outgrown) {
      scheduler.edit(i, reached);
    }
  }

  @Override
  double tailOfEdit(MovingCircle m, double now) {
    return lastTail(now);
  }

  /** The tail of the last event if that was now, even if its circle was removed since. */
  @Override
  public double lastTail(double now) {
    return lastEvent == now ? Math.max(0, lastEventTail) : 0;
  }

  @Override
  void remove(int i) {
    if (!outgrown) {
      scheduler.remove(i);
    }
    invalidate(circles.codes, i);
    leaveJamsOf(i);
  }

  @Override
  void leaveJamsOf(int i) {
    if (circles.jams != null) {
      leaveJams(Codes.circle(i), reached);
    }
  }

  /**
   * Lets circles that an infinite mass crushed collide with it again, if its velocity changed. An
   * impact that is all rounding may leave the velocity as it was; then nothing is new for them.
   */
  private void leaveJamsOfInfinite(int i, boolean turned) {
    if (turned && registry.mass(i) == Double.POSITIVE_INFINITY) {
      collideAgain(i, circles.state[circles.at(i) + FlightRow.T]);
    }
  }

  /** Lets circles that ignore circle i collide with it again, as it moves otherwise. */
  private void collideAgain(int i, double time) {
    if (circles.jams != null) {
      leaveJams(Codes.circle(i), time);
    }
  }

  /** Removes the code of a circle from all ignore lists, at a given time. */
  private void leaveJams(int code, double time) {
    LiveCodes present = registry.present();
    for (int k = 0; k < present.size(); k++) {
      int i = present.get(k);
      IgnoreList jam = circles.jam(i);
      if (registry.contains(i) && jam != null && jam.concerns(code)) {
        circles.load(i);
        circles.body.forget(code, 0);
        store(i, circles.body);
        noteChange(i, time);
      }
    }
  }

  @Override
  void store(int i, MovingCircle m) {
    circles.put(i, m);
    repredict(i);
  }

  // Time.

  @Override
  public void restore(FlightTable flights, double now, double tailOfEdit) {
    outgrown = true;
    super.restore(flights, now, tailOfEdit);
    contacts.restore(flights, now);
    lastEvent = now;
    lastEventTail = tailOfEdit;
  }
}
