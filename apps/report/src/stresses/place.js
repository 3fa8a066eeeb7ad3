// The place along a rod that the charts of stresses show, and the worst one that is held until another one is chosen or the
// clock goes on.
export class Place {
  constructor(data, clock, rods) {
    Object.assign(this, { data, clock, rods, rod: rods[0] ?? -1, s: 0, held: null });
    this.listeners = [];
    clock.listen(() => this.follow());
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  notify() {
    for (const listener of this.listeners) listener(this);
  }

  choose(rod, s) {
    if (!this.rods.includes(rod)) return;
    Object.assign(this, { rod, s, held: null });
    this.notify();
  }

  // A row of the envelopes; the clock goes to the frame nearest to its time.
  hold(worst) {
    Object.assign(this, { rod: worst.rod, s: worst.s, held: null });
    this.isMoving = true;
    this.clock.playing = false;
    this.clock.goToTime(worst.time);
    this.isMoving = false;
    this.held = worst;
    this.notify();
  }

  follow() {
    if (this.isMoving) return;
    this.held = null;
    this.notify();
  }
}
