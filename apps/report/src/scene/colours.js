// Two maps from numbers to colours, uniform to the eye: straight lines of lightness in OKLCH.

const steps = 256;

function toLinearRgb(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((value) => Math.max(0, Math.min(1, value)));
}

function makeMap(colourAt) {
  const map = new Float32Array(3 * steps);
  for (let i = 0; i < steps; i++) map.set(toLinearRgb(...colourAt(i / (steps - 1))), 3 * i);
  return map;
}

// From dark violet over blue and green to light yellow.
const sequential = makeMap((x) => [0.34 + 0.56 * x, 0.14 - 0.04 * Math.sin(Math.PI * x), 300 - 195 * x]);
// Blue below zero, grey at zero, orange above.
const diverging = makeMap((x) => {
  const side = Math.abs(2 * x - 1);
  return [0.88 - 0.36 * side, 0.14 * side, x < 0.5 ? 255 : 45];
});

// How numbers from least to largest become colours; those of both signs get zero in the middle, unless zero means nothing.
export class ColourScale {
  constructor([least, largest], isZeroNothing = false) {
    const hasBothSigns = least < 0 && largest > 0 && !isZeroNothing;
    const bound = Math.max(-least, largest);
    this.least = hasBothSigns ? -bound : least;
    this.largest = hasBothSigns ? bound : largest;
    this.map = hasBothSigns ? diverging : sequential;
  }

  // Writes linear red, green, blue.
  write(value, out, at) {
    const span = this.largest - this.least;
    const part = span > 0 ? (value - this.least) / span : 0;
    const i = 3 * Math.round(Math.max(0, Math.min(1, part)) * (steps - 1));
    out[at] = this.map[i];
    out[at + 1] = this.map[i + 1];
    out[at + 2] = this.map[i + 2];
  }

  // For a canvas.
  css(value) {
    const linear = [0, 0, 0];
    this.write(value, linear, 0);
    return cssColour(linear);
  }

  // All steps from least to largest as bytes of red, green, blue.
  bytes() {
    return Uint8ClampedArray.from(this.map, (linear) => 255 * toSrgb(linear));
  }

  // For a bar that shows the scale.
  gradient() {
    const stops = [];
    for (let i = 0; i < steps; i += 15) stops.push(cssColour(this.map.subarray(3 * i, 3 * i + 3)));
    return `linear-gradient(to right, ${stops.join(", ")})`;
  }
}

function cssColour(linear) {
  return `rgb(${Array.from(linear, (x) => Math.round(255 * toSrgb(x))).join(" ")})`;
}

function toSrgb(x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
}
