import { Curve, Vector3 } from "three";

// A helix about z from z = 0 to `length`; its ends, a part `straight` of the length each, go along the axis.
export class Coil extends Curve {
  constructor(radius, length, turns, straight) {
    super();
    Object.assign(this, { radius, length, turns, straight });
  }

  getPoint(t, out = new Vector3()) {
    const part = Math.min(Math.max((t - this.straight) / (1 - 2 * this.straight), 0), 1);
    const rise = this.straight === 0 ? 1 : Math.min(1, 8 * Math.min(part, 1 - part)); // from the axis to the coil
    const angle = 2 * Math.PI * this.turns * part;
    return out.set(rise * this.radius * Math.cos(angle), rise * this.radius * Math.sin(angle), t * this.length);
  }
}
