"""Eigenvalues over a number of the deck: frequencies and growth of each mode, and where motions begin to grow."""

from dataclasses import dataclass

import numpy as np

from .style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, legend_above
from .units import read_units

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
    words: list  # of each mode at the first value and, if others fit it there, at the last one
    onsets: list  # (value, omega, text)
    has_seconds: bool = False  # whether the deck's unit of time is known to be the second

    @property
    def turns(self):
        """Whether the speed of a rotation rises or falls all along: then it is the axis of a Campbell diagram."""
        steps = np.diff(self.speeds)
        return len(steps) > 0 and bool((steps > 0.0).all() or (steps < 0.0).all())


def read_sweep(stage, units=""):
    onsets = [(row["value"], row["omega"], f"{row['kind']} {'begins' if row['begins'] else 'ends'} at {row['value']:.6g}")
              for row in stage.onsets]
    return Sweep(stage.name, stage.key, stage.values, stage.speeds, stage.angular_frequencies, stage.growth_rates,
                 name_branches(stage), onsets, read_units(units).get("time") == {"s": 1})


def name_branches(stage):
    if "words_at_values" not in stage:  # of an earlier version
        return list(stage.words)
    names = []
    for first, words in zip(stage.words, stage.mode_words.T):
        known = [text for text in words if text]
        names.append(first if not known or known[-1] == first else f"{first}, in the end {known[-1]}")
    return names


class Scales:
    """What a sweep is drawn over: revolutions a minute and Hz if it turns and time is in seconds, revolutions and cycles per
    time if time has another unit, else the number and ω."""

    def __init__(self, sweep):
        self.sweep = sweep
        self.revolution = (60.0 if sweep.has_seconds else 1.0) / (2.0 * np.pi)
        self.across = sweep.speeds * self.revolution if sweep.turns else sweep.values
        self.frequency = 1.0 / (2.0 * np.pi) if sweep.turns else 1.0
        self.up_label = "ω, rad per time"
        self.across_label = sweep.key
        if sweep.turns:
            self.up_label = "frequency, Hz" if sweep.has_seconds else "frequency, cycles per time"
            self.across_label = "speed, rpm" if sweep.has_seconds else "speed, revolutions per time"

    def place(self, value):
        """Where a value of the number is."""
        order = np.argsort(self.sweep.values)
        return float(np.interp(value, self.sweep.values[order], self.across[order]))


def draw_sweep(figure, sweep):
    """Frequencies above, with multiples of the speed; growth below, unless there is none."""
    scales = Scales(sweep)
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
        above.plot(scales.across, scales.frequency * sweep.omegas[:, mode], style, color=colour,
                   label=f"{mode + 1} {words}" if mode < MOST_LABELS else None)
        if below:
            below.plot(scales.across, growths[:, mode], style, color=colour)
    top = 1.05 * scales.frequency * np.nanmax(sweep.omegas, initial=0.0)
    draw_rays(above, scales, top)
    for value, omega, text in sweep.onsets:
        for axes in filter(None, (above, below)):
            axes.axvline(scales.place(value), color=RED, linewidth=0.8, linestyle=":")
        point = (scales.place(value), scales.frequency * omega)
        above.plot(*zip(point), "o", color=RED, markersize=4)
        above.annotate(text, point, xytext=(5, 6), textcoords="offset points", fontsize=8, color=RED)
    above.set_ylim(0.0, top or 1.0)
    if len(scales.across) > 1:
        above.set_xlim(scales.across.min(), scales.across.max())
    above.set_ylabel(scales.up_label)
    (below or above).set_xlabel(scales.across_label)
    legend_above(above, 3)


def draw_rays(axes, scales, top):
    """Multiples of the speed, which excites once, twice … in a revolution; each as far as it is within the axes, with its name
    where it leaves them."""
    sweep = scales.sweep
    if not np.any(sweep.speeds):
        return
    order = np.argsort(scales.across)
    across, speeds = scales.across[order], scales.frequency * np.abs(sweep.speeds[order])
    for multiple in range(1, MOST_RAYS + 1):
        ray = multiple * speeds
        if ray.min() >= top:
            break
        end = across[-1] if ray[-1] <= top else float(np.interp(top, ray, across))
        inside = across < end
        places, heights = np.append(across[inside], end), np.append(ray[inside], min(ray[-1], top))
        axes.plot(places, heights, color=GREY, linewidth=0.7, linestyle=(0, (4, 3)), zorder=0)
        draw_meetings(axes, across, ray, scales.frequency * sweep.omegas[order])
        axes.annotate(f"{multiple}P", (end, heights[-1]), xytext=(-3, 0), textcoords="offset points", fontsize=7, color=GREY, ha="right", va="top" if ray[-1] > top else "bottom")


def draw_meetings(axes, across, ray, frequencies):
    """Small rings where a ray meets a curve, linear between values."""
    for mode, curve in enumerate(frequencies.T):
        off = curve - ray
        for i in np.flatnonzero(off[:-1] * off[1:] < 0.0):
            part = off[i] / (off[i] - off[i + 1])
            place = across[i] + part * (across[i + 1] - across[i])
            axes.plot(place, ray[i] + part * (ray[i + 1] - ray[i]), "o", markersize=3.5, markerfacecolor="white",
                      markeredgecolor=COLOURS[mode % len(COLOURS)], markeredgewidth=0.9)
