import { decode } from "../data.js";

// What the stages of a run have found, as far as there is any: { stages, paths, rows, modes, responses, sweeps }.
export function readFindings(info) {
  return {
    stages: info.stages ?? [],
    paths: (info.paths ?? []).map((path) => ({ ...path, shapes: readShapes(path.swing) })),
    rows: info.paths ? readPathRows(info) : null,
    modes: (info.modes ?? []).map((modes) => ({ ...modes, shapes: readShapes(modes.swing) })),
    responses: (info.responses ?? []).map(readResponse),
    sweeps: (info.sweeps ?? []).map((sweep) => ({ ...sweep, shapes: readShapes(sweep.swing) })),
  };
}

// Of the points of paths: { times, loads, branches, pivots, charts }, a chart for each history with its columns.
function readPathRows({ charts }) {
  const times = decode("path-times", Float64Array);
  const values = decode("path-values", Float32Array);
  let column = 0;
  const columnsOf = (chart) =>
    chart.labels.map(() => {
      const first = times.length * column++;
      return values.subarray(first, first + times.length);
    });
  return {
    times,
    loads: decode("path-loads", Float64Array),
    branches: decode("path-branches", Int32Array),
    pivots: decode("path-pivots", Int32Array),
    charts: charts.filter(({ group }) => group === "history").map((chart) => ({ ...chart, columns: columnsOf(chart) })),
  };
}

// Functions that give the numbers of a shape; null where there are none to draw.
function readShapes(swing) {
  if (!swing || swing.kept === 0) return null;
  const read = (part) => decode(`shape-${part}-${swing.block}`, Float32Array);
  const places = read("places");
  const size = places.length / swing.times.length;
  const whole = { places, attitudes: read("attitudes"), moves: read("moves"), turns: read("turns") };
  if (swing.is_complex) Object.assign(whole, { movesImaginary: read("moves-imaginary"), turnsImaginary: read("turns-imaginary") });
  const pick = (name, i) => whole[name]?.subarray(i * size, (i + 1) * size) ?? null;
  return {
    count: swing.kept,
    hasOneState: swing.times.length === 1,
    at(i) {
      const state = swing.times.length === 1 ? 0 : i;
      return {
        time: swing.times[state],
        places: pick("places", state),
        attitudes: pick("attitudes", state),
        moves: pick("moves", i),
        turns: pick("turns", i),
        movesImaginary: pick("movesImaginary", i),
        turnsImaginary: pick("turnsImaginary", i),
      };
    },
  };
}

function readResponse(response) {
  const omegas = decode(`response-omegas-${response.block}`, Float64Array);
  const values = decode(`response-values-${response.block}`, Float32Array);
  const part = (i) => values.subarray(i * omegas.length, (i + 1) * omegas.length);
  const curves = response.curves.map((curve, i) => ({ ...curve, real: part(2 * i), imaginary: part(2 * i + 1) }));
  return { ...response, omegas, curves };
}
