// The moment that the page shows: a position among the frames. It is a whole number unless the motion plays.
export class Clock {
  constructor(times, isStatic) {
    this.times = times;
    this.position = 0;
    this.playing = false;
    this.isOpening = false;
    this.isCyclic = false; // plays over and over
    this.rate = 1;
    this.unitsPerSecond = chooseSpeed(times, isStatic);
    this.listeners = [];
  }

  get last() {
    return this.times.length - 1;
  }

  // Time, or load factor, of the position.
  get time() {
    const frame = Math.min(Math.floor(this.position), this.last);
    const next = Math.min(frame + 1, this.last);
    return this.times[frame] + (this.position - frame) * (this.times[next] - this.times[frame]);
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  notify() {
    for (const listener of this.listeners) listener(this);
  }

  // Where a page opens; it still plays from the start.
  openAt(frame) {
    this.goToFrame(frame);
    this.isOpening = true;
  }

  goToFrame(frame) {
    this.isOpening = false;
    this.position = Math.max(0, Math.min(this.last, Math.round(frame)));
    this.notify();
  }

  // To the nearest frame.
  goToTime(time) {
    this.goToFrame(this.positionAt(time));
  }

  positionAt(time) {
    if (time <= this.times[0]) return 0;
    if (time >= this.times[this.last]) return this.last;
    let low = 0;
    let high = this.last;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) low = middle;
      else high = middle;
    }
    return low + (time - this.times[low]) / (this.times[high] - this.times[low]);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.last < 1) return;
    if (this.position >= this.last || this.isOpening) this.position = 0;
    this.isOpening = false;
    this.playing = true;
    let before = performance.now();
    const advance = (now) => {
      if (!this.playing) return;
      const time = this.time + ((now - before) / 1000) * this.unitsPerSecond * this.rate;
      before = now;
      this.position = this.positionAt(this.isCyclic ? time % this.times[this.last] : time);
      if (this.position >= this.last && !this.isCyclic) this.playing = false;
      this.notify();
      if (this.playing) requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
    this.notify();
  }

  pause() {
    this.playing = false;
    this.goToFrame(this.position);
  }
}

// True time if the whole then takes from four to thirty seconds, else eight seconds for the whole.
function chooseSpeed(times, isStatic) {
  const duration = times[times.length - 1] - times[0];
  const isWatchable = !isStatic && duration >= 4 && duration <= 30;
  return isWatchable ? 1 : Math.max(duration, 1e-30) / 8;
}
