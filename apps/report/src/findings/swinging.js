import { find, make } from "../elements.js";
import { Clock } from "../clock.js";
import { fromVector, multiply } from "../rotation.js";

const steps = 72; // of a period on the slider
const seconds = 2; // of a period at speed 1
const largestTurn = 2; // radians at amplitude 1: shapes that hardly displace anything would twist many times

// Where in its period a shape is: from 0 to 1, over and over.
class PhaseClock extends Clock {
  constructor() {
    super(Array.from({ length: steps + 1 }, (_, i) => i / steps), true);
    this.unitsPerSecond = 1 / seconds;
    this.isCyclic = true;
  }
}

// Lets the picture swing in a shape about the state in which it was found. One shape at a time is chosen, by the buttons that
// are bound to it.
export class Swinging {
  constructor(picture, clock) {
    Object.assign(this, { picture, clock });
    this.phase = new PhaseClock();
    this.amplitude = 1;
    this.chosen = null;
    this.listeners = [];
    this.text = make("span", {});
    const back = make("button", { type: "button", id: "back" }, "Back to the run");
    back.addEventListener("click", () => this.leave());
    this.note = make("div", { id: "swing-note", hidden: true }, this.text, back);
    find("scale-note").before(this.note);
    this.phase.listen(() => this.move());
    clock.listen(() => this.leave());
    find("scale").addEventListener("change", () => this.leave());
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  // A button that chooses a shape, or leaves it: { shapes, index, title, text, words }.
  bind(button, shape) {
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => (this.isAt(shape) ? this.leave() : this.choose(shape)));
    this.listen(() => button.setAttribute("aria-pressed", String(this.isAt(shape))));
  }

  isAt({ shapes, index }) {
    return this.chosen !== null && this.chosen.shapes === shapes && this.chosen.index === index;
  }

  choose(shape, { isPlaying = true } = {}) {
    const { shapes, index } = shape;
    const isOther = this.chosen?.shapes !== shapes || !shapes.hasOneState;
    const wasPlaying = this.phase.playing;
    this.clock.playing = false;
    this.chosen = shape;
    this.shape = shapes.at(index);
    this.scale = Math.min(1, largestTurn / largestSize(this.shape.turns, this.shape.turnsImaginary));
    this.note.hidden = false;
    this.hideColouring(true);
    this.text.replaceChildren(make("b", {}, shape.title), ` ${[shape.text, shape.words].filter(Boolean).join(", ")}`);
    if (isOther) this.picture.enterState(this.shape, Math.round(this.clock.positionAt(this.shape.time)), this.boundsOf(shapes, index));
    this.notify();
    if (!wasPlaying) this.phase.position = 0;
    if (isPlaying && !wasPlaying) this.phase.play();
    else this.phase.notify();
  }

  leave() {
    if (this.chosen === null) return;
    this.chosen = null;
    this.phase.playing = false;
    this.note.hidden = true;
    this.hideColouring(false);
    this.picture.leaveState();
    this.notify();
    this.clock.notify();
  }

  // Colours are those of the run.
  hideColouring(isHidden) {
    find("colouring").hidden = isHidden || !this.picture.hasColours;
  }

  notify() {
    for (const listener of this.listeners) listener();
  }

  setAmplitude(amplitude) {
    this.amplitude = amplitude;
    this.move();
  }

  // Places the nodes at the phase: real part times its cosine less imaginary part times its sine.
  move() {
    if (this.chosen === null) return;
    const angle = 2 * Math.PI * this.phase.time;
    const factor = this.amplitude * this.scale;
    const [c, s] = [factor * Math.cos(angle), factor * Math.sin(angle)];
    const { places, attitudes, moves, turns, movesImaginary, turnsImaginary } = this.shape;
    const { positions, rotations } = this.picture.motion;
    for (let i = 0; i < places.length; i++) positions[i] = places[i] + c * moves[i] - (movesImaginary ? s * movesImaginary[i] : 0);
    const turn = new Float32Array(3);
    const [before, added] = [new Float32Array(4), new Float32Array(4)];
    for (let node = 0; 3 * node < places.length; node++) {
      for (let k = 0; k < 3; k++) turn[k] = c * turns[3 * node + k] - (turnsImaginary ? s * turnsImaginary[3 * node + k] : 0);
      fromVector(attitudes, 3 * node, 1, before, 0);
      fromVector(turn, 0, 1, added, 0);
      multiply(added, 0, before, 0, rotations, 4 * node);
    }
    this.picture.showState();
  }

  // [least, largest] corners of what all shapes about the same state reach.
  boundsOf(shapes, index) {
    const least = [Infinity, Infinity, Infinity];
    const largest = [-Infinity, -Infinity, -Infinity];
    const [first, end] = shapes.hasOneState ? [0, shapes.count] : [index, index + 1];
    for (let shape = first; shape < end; shape++) {
      const { places, moves, movesImaginary } = shapes.at(shape);
      for (let i = 0; i < places.length; i++) {
        const reach = movesImaginary ? Math.hypot(moves[i], movesImaginary[i]) : Math.abs(moves[i]);
        least[i % 3] = Math.min(least[i % 3], places[i] - reach);
        largest[i % 3] = Math.max(largest[i % 3], places[i] + reach);
      }
    }
    return [least, largest];
  }
}

// Of vectors of three numbers each, complex ones with imaginary parts.
function largestSize(real, imaginary) {
  let largest = 0;
  for (let i = 0; i < real.length; i += 3) {
    const parts = [...real.subarray(i, i + 3), ...(imaginary?.subarray(i, i + 3) ?? [])];
    largest = Math.max(largest, Math.hypot(...parts));
  }
  return largest;
}
