"""Eigenvalues over a number of the deck: frequencies and growth of each mode, and where motions begin to grow."""

from dataclasses import dataclass

import numpy as np

from .style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, legend_above

COLOURS = (BLUE, ORANGE, GREEN, PURPLE)
HEIGHT = 5.6
ROUND_OFF = 1e-6  # of a growth, compared with |λ|
MOST_RAYS = 8  # multiples of the speed
MOST_LABELS = 8


@dataclass
class Sweep:
    """The modes of one stage, followed from value to value."""

    stage: str
    key: str
    values: np.ndarray  # [V]
    speeds: np.ndarray  # [V]; 0 where nothing turns
    omegas: np.ndarray  # [V, n]
    growths: np.ndarray  # [V, n]
    words: list
    onsets: list  # (value, omega, text)


def read_sweep(stage):
    onsets = [(row["value"], row["omega"], f"{row['kind']} {'begins' if row['begins'] else 'ends'} at {row['value']:.6g}")
              for row in stage.onsets]
    return Sweep(stage.name, stage.key, stage.values, stage.speeds, stage.angular_frequencies, stage.growth_rates,
                 list(stage.words), onsets)


def draw_sweep(figure, sweep):
    """Frequencies above, with multiples of the speed; growth below, unless there is none."""
    figure.suptitle(f"{sweep.stage}: modes over {sweep.key}", x=0.02, ha="left", fontsize=9.5, fontweight="bold")
    growths = np.where(np.abs(sweep.growths) > ROUND_OFF * np.hypot(sweep.omegas, sweep.growths), sweep.growths, 0.0)
    if np.nanmax(np.abs(growths), initial=0.0) > 0.0:
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
        below.axhline(0.0, color=GREY, linewidth=0.8)
        below.set_ylabel("growth, per time")
    else:
        above, below = figure.subplots(1, 1), None
    for mode, words in enumerate(sweep.words):
        colour = COLOURS[mode % len(COLOURS)]
        style = "-" if mode < len(COLOURS) else "--"
        above.plot(sweep.values, sweep.omegas[:, mode], style, color=colour,
                   label=f"{mode + 1} {words}" if mode < MOST_LABELS else None)
        if below:
            below.plot(sweep.values, growths[:, mode], style, color=colour)
    top = 1.05 * np.nanmax(sweep.omegas, initial=0.0)
    draw_rays(above, sweep, top)
    for value, omega, text in sweep.onsets:
        for axes in filter(None, (above, below)):
            axes.axvline(value, color=RED, linewidth=0.8, linestyle=":")
        above.plot([value], [omega], "o", color=RED, markersize=4)
        above.annotate(text, (value, omega), xytext=(5, 6), textcoords="offset points", fontsize=8, color=RED)
    above.set_ylim(0.0, top or 1.0)
    above.set_ylabel("ω, rad per time")
    (below or above).set_xlabel(sweep.key)
    legend_above(above, 3)


def draw_rays(axes, sweep, top):
    """Multiples of the speed, which excites once, twice … in a revolution."""
    if not np.any(sweep.speeds):
        return
    order = np.argsort(sweep.values)
    values, speeds = sweep.values[order], np.abs(sweep.speeds[order])
    for multiple in range(1, MOST_RAYS + 1):
        ray = multiple * speeds
        axes.plot(values, ray, color=GREY, linewidth=0.7, linestyle=(0, (4, 3)), zorder=0)
        inside = np.flatnonzero(ray <= top)
        if len(inside):
            last = inside[-1]
            axes.annotate(f"{multiple}×", (values[last], ray[last]), fontsize=7, color=GREY, ha="right", va="bottom")
