"""Panels of the ledger: energies, their error, and momenta."""

from .style import AXIS_COLOURS, BLACK, BLUE, GREEN, ORANGE, PURPLE, draw_curves

PANELS = 4


def draw_ledger(figure, results):
    """Fills a figure or subfigure with four panels, one below the other."""
    ledger = results.ledger()
    panels = figure.subplots(PANELS, 1, sharex=True)
    draw_energies(panels[0], results.times, ledger)
    error = {"energy error": (ledger["energy_error"].values, BLACK)}
    draw_curves(panels[1], results.times, error, "Energy error", ledger["energy_error"].dimension)
    for axes, name in zip(panels[2:], ("linear_momentum", "angular_momentum")):
        series = ledger[name]
        curves = {letter: (series.values[:, i], AXIS_COLOURS[letter]) for i, letter in enumerate("xyz")}
        draw_curves(axes, results.times, curves, name.replace("_", " ").capitalize(), series.dimension)
    panels[-1].set_xlabel("time")


def draw_energies(axes, times, ledger):
    curves = {
        "kinetic": (ledger["kinetic_energy"].values, BLUE),
        "strain": (ledger["strain_energy"].values, ORANGE),
        "work": (ledger["external_work"].values, GREEN),
        "dissipated": (ledger["dissipated_energy"].values, PURPLE),
    }
    shown = {name: curve for name, curve in curves.items() if name == "kinetic" or curve[0].any()}
    draw_curves(axes, times, shown, "Energies", ledger["kinetic_energy"].dimension)
