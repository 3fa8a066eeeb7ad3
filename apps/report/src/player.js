import { find, make } from "./elements.js";
import { formatNumber, timeSymbol } from "./format.js";

const rates = [0.1, 0.25, 0.5, 1, 2, 4];

// Play, slider and speed under the picture, and the keys space, left and right.
export function bindPlayer(clock, timeName) {
  const slider = find("time-slider");
  slider.max = String(clock.last);
  slider.disabled = clock.last < 1;
  find("play").disabled = clock.last < 1;
  const speed = find("speed");
  for (const rate of rates) {
    speed.append(make("option", { value: String(rate), selected: rate === 1 }, `${rate}×`));
  }
  speed.title = `1× shows ${formatNumber(clock.unitsPerSecond, 3)} of ${timeName} a second`;
  speed.addEventListener("change", () => (clock.rate = Number(speed.value)));
  slider.addEventListener("input", () => {
    clock.playing = false;
    clock.goToFrame(Number(slider.value));
  });
  find("play").addEventListener("click", () => clock.toggle());
  document.addEventListener("keydown", (event) => {
    if (event.target.closest?.("input, select, textarea, button, summary, [role=tab]")) return;
    const actions = {
      " ": () => clock.toggle(),
      ArrowLeft: () => clock.goToFrame(clock.position - 1),
      ArrowRight: () => clock.goToFrame(clock.position + 1),
      Home: () => clock.goToFrame(0),
      End: () => clock.goToFrame(clock.last),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  });
  const symbol = timeSymbol(timeName);
  clock.listen(() => {
    slider.value = String(Math.round(clock.position));
    const text = `${symbol} = ${formatNumber(clock.time, 5)}`;
    slider.setAttribute("aria-valuetext", text);
    find("time-text").textContent = text;
    find("frame-text").textContent = `frame ${Math.round(clock.position) + 1} of ${clock.last + 1}`;
    find("play").dataset.playing = String(clock.playing);
    find("play").setAttribute("aria-label", clock.playing ? "Pause" : "Play");
  });
}
