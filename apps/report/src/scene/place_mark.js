import { Group, Mesh, MeshStandardMaterial, SphereGeometry } from "three";

// A translucent ball around the chosen place of a rod; visible while its section is.
export class PlaceMark {
  constructor(data, motion, { size, rods }) {
    Object.assign(this, { data, motion, size, rods });
    this.material = new MeshStandardMaterial({ transparent: true, opacity: 0.6, roughness: 0.6 });
    this.ball = new Mesh(new SphereGeometry(1, 24, 16), this.material);
    this.group = new Group().add(this.ball);
    this.group.visible = false;
    this.ends = null;
  }

  // Between the ends of the element in which s is.
  choose(rod, s) {
    const { offsets, cellRods, arcLengths, connectivity } = this.data;
    this.ends = null;
    for (let cell = 0; cell + 1 < offsets.length; cell++) {
      const [from, to] = [offsets[cell], offsets[cell] + 1];
      if (cellRods[cell] !== rod || arcLengths[to] < s) continue;
      const part = (s - arcLengths[from]) / (arcLengths[to] - arcLengths[from]);
      this.ends = { a: connectivity[from], b: connectivity[to], part: Math.max(0, Math.min(1, part)) };
      break;
    }
    this.move();
  }

  move() {
    if (!this.ends) return;
    const { a, b, part } = this.ends;
    const { positions } = this.motion;
    const at = (i) => (1 - part) * positions[3 * a + i] + part * positions[3 * b + i];
    this.ball.position.set(at(0), at(1), at(2));
    this.ball.scale.setScalar(Math.max(1.35 * this.rods.radiusAt(a) * this.rods.thickness, 0.008 * this.size));
  }
}
