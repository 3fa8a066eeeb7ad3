"""How a model answers to forces that swing: amplitudes and phases over the frequency."""

from dataclasses import dataclass

import numpy as np

from .style import BLUE, GREEN, ORANGE, PURPLE, legend_above

COLOURS = (BLUE, ORANGE, GREEN, PURPLE)
HEIGHT = 4.6
LEAST = 1e-9  # of the largest amplitude: smaller components are left out
QUANTITIES = ("displacement", "rotation_vector", "reaction_force", "reaction_moment")


@dataclass
class Response:
    """The answers of one stage."""

    stage: str
    omegas: np.ndarray
    curves: dict  # {name: complex amplitudes over the frequencies}


def read_response(stage, quantity_names):
    """Components of the quantities that the deck's histories record, as far as they move at all."""
    curves = {}
    for point, answers in stage.histories.items():
        for quantity in QUANTITIES:
            if quantity not in quantity_names.get(point, QUANTITIES):
                continue
            amplitudes = answers[quantity]
            largest = np.nanmax(np.abs(amplitudes), initial=0.0)
            for letter, curve in zip("xyz", amplitudes.T):
                if np.nanmax(np.abs(curve), initial=0.0) > LEAST * largest:
                    curves[f"{point} {quantity.replace('_', ' ')} {letter}"] = curve
    return Response(stage.name, stage.angular_frequencies, curves)


def draw_response(figure, response):
    """Amplitudes above, phases below."""
    figure.suptitle(f"{response.stage}: answers to forces that swing", x=0.02, ha="left", fontsize=9.5,
                    fontweight="bold")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    for index, (name, curve) in enumerate(response.curves.items()):
        colour = COLOURS[index % len(COLOURS)]
        above.plot(response.omegas, np.abs(curve), color=colour, label=name)
        below.plot(response.omegas, np.degrees(np.unwrap(np.angle(curve))), color=colour)
    above.set_yscale("log")
    steps = np.diff(response.omegas)
    if len(steps) > 1 and response.omegas[0] > 0.0 and steps[-1] > 2.0 * steps[0]:
        above.set_xscale("log")
    above.set_ylabel("amplitude")
    below.set_ylabel("phase, degrees")
    below.set_xlabel("ω, rad per time")
    if len(response.curves) > 1:
        legend_above(above, min(len(response.curves), 3))
    elif response.curves:
        above.set_title(next(iter(response.curves)), fontsize=8, fontweight="normal")
