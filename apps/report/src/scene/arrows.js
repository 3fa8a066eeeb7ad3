import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshStandardMaterial } from "three";

const shaft = new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0).rotateX(Math.PI / 2);
const head = new ConeGeometry(1, 1, 16).translate(0, 0.5, 0).rotateX(Math.PI / 2);
const materials = new Map();

export function materialOf(colour) {
  if (!materials.has(colour)) materials.set(colour, new MeshStandardMaterial({ color: colour, roughness: 0.6 }));
  return materials.get(colour);
}

// An arrow from the origin along z; `heads` 2 for a moment.
export function makeArrow(colour, length, radius, heads = 1) {
  const arrow = new Group();
  arrow.parts = [new Mesh(shaft, materialOf(colour))];
  for (let i = 0; i < heads; i++) arrow.parts.push(new Mesh(head, materialOf(colour)));
  arrow.add(...arrow.parts);
  setLength(arrow, length, radius);
  return arrow;
}

export function setLength(arrow, length, radius) {
  const [body, ...heads] = arrow.parts;
  const headLength = Math.min(6 * radius, (0.6 * length) / heads.length);
  const start = Math.max(length - headLength * (heads.length === 1 ? 1 : 1.6), 1e-9);
  body.scale.set(radius, radius, start);
  heads.forEach((part, i) => {
    part.scale.set(2.4 * radius, 2.4 * radius, headLength);
    part.position.z = length - headLength - 0.6 * headLength * i;
  });
}
