import { Vector3 } from "three";
import { make } from "../elements.js";

const reach = 14; // pixels around a point

// Names what the pointer is at: joints, springs, bushings, bodies and supports.
export class Names {
  constructor(picture, canvas) {
    this.picture = picture;
    this.canvas = canvas;
    this.tag = make("p", { id: "name-tag", hidden: true });
    canvas.parentElement.append(this.tag);
    canvas.addEventListener("pointermove", (event) => this.show(event.buttons === 0 ? event : null));
    canvas.addEventListener("pointerdown", (event) => this.show(event.pointerType === "touch" ? event : null));
    canvas.addEventListener("pointerleave", () => this.show(null));
  }

  // [words, place] of all that is drawn and has a name; of two at one place the first is named.
  list() {
    const { joints, springs, bodies, supports, obstacles } = this.picture.parts;
    const shown = (part, list) => (part.group.visible ? list : []);
    return [
      ...shown(joints, joints.marks.flatMap((mark) => mark.spots.map((x) => [`${mark.name}: ${mark.type}`, spotOf(mark, x)]))),
      ...shown(springs, springs.marks.map(({ name, type, place }) => [`${name}: ${type}`, place])),
      ...shown(supports, supports.marks.map(({ name, position }) => [`${name}: support`, position])),
      ...shown(bodies, bodies.bodies.map(({ name, centre, group }) => [`${name}: body`, group.localToWorld(centre.clone())])),
      ...shown(obstacles, obstacles.marks.map(({ name, place, group }) => [`${name}: obstacle`, group.localToWorld(place.clone())])),
    ].filter(([words]) => !words.startsWith(":"));
  }

  show(event) {
    const found = event && this.find(event.offsetX, event.offsetY);
    this.tag.hidden = !found;
    if (!found) return;
    this.tag.textContent = found.words.join("\n");
    this.tag.style.transform = `translate(${found.x + 14}px, ${found.y - 12}px)`;
  }

  // The names nearest to a pixel within reach: several at one place.
  find(x, y) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const { camera } = this.picture.stage;
    const point = new Vector3();
    const near = this.list().map(([words, place]) => {
      point.copy(place).project(camera);
      const at = { words, x: 0.5 * (1 + point.x) * width, y: 0.5 * (1 - point.y) * height };
      return { ...at, distance: Math.hypot(at.x - x, at.y - y) };
    });
    const [first] = near.filter(({ distance }) => distance < reach).sort((a, b) => a.distance - b.distance);
    if (!first) return null;
    return { ...first, words: near.filter((other) => Math.hypot(other.x - first.x, other.y - first.y) < 1).map(({ words }) => words) };
  }
}

// Of a joint: where its symbol is, or one of its sleeves.
function spotOf({ place, body }, x) {
  return x === 0 ? place : body.localToWorld(new Vector3(x, 0, 0));
}
