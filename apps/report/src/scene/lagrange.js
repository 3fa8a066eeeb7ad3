// Shape functions of rod elements on their Gauss-Lobatto points, the two ends first, as cells list their nodes.
const inner = [
  [],
  [],
  [0],
  [-Math.sqrt(1 / 5), Math.sqrt(1 / 5)],
  [-Math.sqrt(3 / 7), 0, Math.sqrt(3 / 7)],
];

// Values at xi, from −1 at the start to 1 at the end, of an element of so many nodes.
export function shapeFunctions(nodes, xi) {
  const points = [-1, 1, ...inner[nodes - 1]];
  return points.map((point, i) =>
    points.reduce((value, other, j) => (i === j ? value : (value * (xi - other)) / (point - other)), 1),
  );
}
