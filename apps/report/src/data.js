// The data of the page: one JSON text and blocks of numbers in base64.

// The numbers of the block of this name, which is then gone; none if there is no such block.
export function decode(name, Type) {
  const element = document.getElementById(`data-${name}`);
  if (!element) return new Type(0);
  const text = atob(element.textContent);
  element.remove();
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

// NaN becomes null, which charts draw as a gap: a resumed run may not have recorded all of a history.
function withGaps(column) {
  return column.every(Number.isFinite) ? column : Array.from(column, (value) => (Number.isFinite(value) ? value : null));
}

function readSteps(charts) {
  const times = decode("step-times", Float64Array);
  const numbers = decode("steps", Float32Array);
  let column = 0;
  for (const chart of charts) {
    chart.columns = chart.labels.map(() => {
      const first = times.length * column++;
      return withGaps(numbers.subarray(first, first + times.length));
    });
  }
  return times;
}

// { info, times, reference, connectivity, offsets, axes, radii, cellRods, middles, arcLengths, arrows,
//   contacts, contactOffsets, obstacles,
//   quantities: {name: {of, values, isScalar}}, stepTimes }: vectors are three numbers each, frame after frame; `of` is "node" or "cell".
// contacts has seven numbers of what touches: point, force, and 1 where it slides plus 2 between rods; contactOffsets is where
// each frame starts in it. obstacles has displacement and quaternion of those that move, frame after frame.
// Axes, radii and arcLengths are those of the entries of connectivity.
export function readData() {
  const info = JSON.parse(document.getElementById("report").textContent);
  const quantities = {};
  for (const name of info.node_data) quantities[name] = { of: "node", values: decode(name, Float32Array) };
  for (const name of info.cell_data) quantities[name] = { of: "cell", values: decode(name, Float32Array) };
  for (const name of info.cell_scalars ?? []) quantities[name] = { of: "cell", values: decode(name, Float32Array), isScalar: true };
  return {
    info,
    quantities,
    times: decode("frame-times", Float64Array),
    reference: decode("reference", Float32Array),
    connectivity: decode("connectivity", Int32Array),
    offsets: decode("offsets", Int32Array),
    axes: decode("axes", Float32Array),
    radii: decode("radii", Float32Array),
    cellRods: decode("cell-rods", Int32Array),
    middles: decode("middles", Float32Array),
    arcLengths: decode("arc-lengths", Float32Array),
    arrows: decode("arrows", Float32Array),
    contacts: decode("contacts", Float32Array),
    contactOffsets: decode("contact-offsets", Int32Array),
    obstacles: decode("obstacles", Float32Array),
    stepTimes: readSteps(info.charts),
  };
}
