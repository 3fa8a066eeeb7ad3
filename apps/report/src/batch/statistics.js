// Of rising numbers, with a straight line between two neighbours.
export function quantile(sorted, part) {
  if (sorted.length === 0) return NaN;
  const place = part * (sorted.length - 1);
  const low = Math.floor(place);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}

// Count, mean, standard deviation of a sample (with n − 1), least, largest, and three quantiles.
export function summarise(numbers) {
  const sorted = Float64Array.from(numbers.filter(Number.isFinite)).sort();
  const count = sorted.length;
  let mean = 0;
  let squares = 0;
  sorted.forEach((number, i) => {
    const difference = number - mean;
    mean += difference / (i + 1);
    squares += difference * (number - mean);
  });
  return {
    count,
    mean: count > 0 ? mean : NaN,
    deviation: count > 1 ? Math.sqrt(squares / (count - 1)) : NaN,
    least: sorted[0] ?? NaN,
    largest: sorted.at(-1) ?? NaN,
    low: quantile(sorted, 0.05),
    median: quantile(sorted, 0.5),
    high: quantile(sorted, 0.95),
  };
}

// Of log y over log x, by least squares.
export function slopeOf(points) {
  const xs = points.map(({ x }) => Math.log(x));
  const ys = points.map(({ y }) => Math.log(y));
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [mx, my] = [mean(xs), mean(ys)];
  let [top, bottom] = [0, 0];
  xs.forEach((x, i) => {
    top += (x - mx) * (ys[i] - my);
    bottom += (x - mx) ** 2;
  });
  return top / bottom;
}
