import { Vector3 } from "three";

const reach = 12; // pixels around a rod
const still = 4; // pixels by which a click may move

// Finds the place along a rod that is clicked in the picture: calls `choose(rod, s)`.
export class RodPicking {
  constructor(picture, canvas, choose) {
    Object.assign(this, { picture, canvas });
    let from = null;
    canvas.addEventListener("pointerdown", (event) => (from = [event.offsetX, event.offsetY]));
    canvas.addEventListener("pointerup", (event) => {
      if (!from || Math.hypot(event.offsetX - from[0], event.offsetY - from[1]) > still) return;
      const found = this.find(event.offsetX, event.offsetY);
      if (found) choose(found.rod, found.s);
    });
  }

  // On the straight lines between the ends of elements, the one nearest to a pixel.
  find(x, y) {
    const { data } = this.picture;
    let nearest = null;
    for (let cell = 0; cell + 1 < data.offsets.length; cell++) {
      if (data.cellRods[cell] < 0) continue;
      const first = data.offsets[cell];
      const [a, b] = [first, first + 1].map((entry) => this.project(data.connectivity[entry]));
      const square = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;
      const part = square > 0 ? Math.max(0, Math.min(1, ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / square)) : 0;
      const distance = Math.hypot(a.x + part * (b.x - a.x) - x, a.y + part * (b.y - a.y) - y);
      if (distance > (nearest?.distance ?? reach)) continue;
      const [from, to] = [data.arcLengths[first], data.arcLengths[first + 1]];
      nearest = { rod: data.cellRods[cell], s: (1 - part) * from + part * to, distance };
    }
    return nearest;
  }

  project(node) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const point = new Vector3().fromArray(this.picture.motion.positions, 3 * node).project(this.picture.stage.camera);
    return { x: 0.5 * (1 + point.x) * width, y: 0.5 * (1 - point.y) * height };
  }
}
