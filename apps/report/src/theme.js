// Colours that do not come from the style sheet: those of marks mean the same in light and dark.
export const axisColours = ["#d8493e", "#2f9e58", "#3b7de0"];
export const symbolColours = {
  support: "#7b8494",
  moved: "#8e5bd0",
  joint: "#1d8a99",
  spring: "#b08418",
  force: "#e0722a",
  moment: "#c2407f",
  failure: "#e02d2d",
  shear: "#d1495b",
  tension: "#2a78c8",
  mass: "#2f9e5b",
  principal: "#8a6fd1",
};

// Blue and amber: their lightness tells them apart without colours, too.
export const contactColours = { sticks: "#1f5fbf", slides: "#f0b000", force: "#1f5fbf" };

// The names of the style sheet's colours that canvases need.
export function readTheme() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    paper: colour("paper"),
    ink: colour("ink"),
    muted: colour("muted"),
    line: colour("line"),
    rod: colour("rod"),
    body: colour("body"),
    obstacle: colour("obstacle"),
    path: colour("path"),
    bad: colour("bad"),
    series: [1, 2, 3, 4].map((i) => colour(`series-${i}`)),
    branches: [1, 2, 3, 4, 5, 6].map((i) => colour(`branch-${i}`)),
    // From blue over violet and red to orange, for more lines in an order than there are series.
    ranks: (part) => `oklch(${colour("rank-lightness")} 0.16 ${265 + 155 * part})`,
  };
}

// The button that goes through automatic, light and dark.
export function bindThemeButton(button, onChange) {
  const names = ["auto", "light", "dark"];
  const root = document.documentElement;
  const show = () => {
    button.title = `Colours: ${root.dataset.theme}`;
    button.setAttribute("aria-label", button.title);
    onChange();
  };
  button.addEventListener("click", () => {
    root.dataset.theme = names[(names.indexOf(root.dataset.theme) + 1) % names.length];
    show();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", show);
}
