import { find, make } from "./elements.js";
import { formatNumber, timeSymbol } from "./format.js";

const rates = [0.1, 0.25, 0.5, 1, 2, 4];

// Play, slider and speed under the picture, and the keys space, left and right. While a shape swings they are those of its
// phase. `describe` gives words to add to a time, and the load factor on a path.
export function bindPlayer(clock, timeName, { swinging, describe }) {
  const slider = find("time-slider");
  const active = () => (swinging?.chosen ? swinging.phase : clock);
  const adopt = () => {
    const { last } = active();
    slider.max = String(last);
    slider.disabled = last < 1;
    find("play").disabled = last < 1;
  };
  adopt();
  const speed = find("speed");
  for (const rate of rates) {
    speed.append(make("option", { value: String(rate), selected: rate === 1 }, `${rate}×`));
  }
  speed.title = `1× shows ${formatNumber(clock.unitsPerSecond, 3)} of ${timeName} a second`;
  speed.addEventListener("change", () => {
    for (const each of [clock, swinging?.phase]) if (each) each.rate = Number(speed.value);
  });
  slider.addEventListener("input", () => {
    active().playing = false;
    active().goToFrame(Number(slider.value));
  });
  find("play").addEventListener("click", () => active().toggle());
  document.addEventListener("keydown", (event) => {
    if (event.target.closest?.("input, select, textarea, button, summary, [role=tab]")) return;
    const actions = {
      " ": () => active().toggle(),
      ArrowLeft: () => active().goToFrame(active().position - 1),
      ArrowRight: () => active().goToFrame(active().position + 1),
      Home: () => active().goToFrame(0),
      End: () => active().goToFrame(active().last),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  });
  const symbol = timeSymbol(timeName);
  const show = (text, others) => {
    const { position, playing } = active();
    slider.value = String(Math.round(position));
    slider.setAttribute("aria-valuetext", text);
    find("time-text").textContent = text;
    find("frame-text").textContent = others.join(" · ");
    find("play").dataset.playing = String(playing);
    find("play").setAttribute("aria-label", playing ? "Pause" : "Play");
  };
  clock.listen(() => {
    if (active() !== clock) return;
    const { words, load } = describe(clock.time);
    const factor = load === null ? [] : [`λ = ${formatNumber(load, 4)}`];
    show(`${symbol} = ${formatNumber(clock.time, 5)}`, [...factor, ...words, `frame ${Math.round(clock.position) + 1} of ${clock.last + 1}`]);
  });
  swinging?.listen(adopt);
  swinging?.phase.listen(() => {
    if (swinging.chosen) show(swinging.chosen.title, [swinging.chosen.text]);
  });
}
