import { Curve, Vector3 } from "three";

// The line of a cam through points [y, z] across x, from the first to the last one.
export class Profile extends Curve {
  constructor(points) {
    super();
    this.points = points;
  }

  getPoint(t, out = new Vector3()) {
    const last = this.points.length - 1;
    const piece = Math.min(Math.floor(t * last), last - 1);
    const part = t * last - piece;
    const [from, to] = [this.points[piece], this.points[piece + 1]];
    return out.set(0, from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]));
  }
}
