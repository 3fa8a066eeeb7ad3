"""Panels of the ledger: energies, their error, and momenta."""

from .style import AXIS_COLOURS, BLACK, BLUE, GREEN, ORANGE, PURPLE, draw_curves

MOMENTA = ("linear_momentum", "angular_momentum")


def panel_count(results):
    return 2 if results.is_static else 2 + len(MOMENTA)


def draw_ledger(figure, results, columns=1):
    """Fills a figure or subfigure with panels, one below the other: no momenta in statics."""
    ledger = results.ledger()
    grid = figure.subplots(panel_count(results) // columns, columns, sharex=True, squeeze=False)
    panels = list(grid.flat)
    draw_energies(panels[0], results, ledger)
    error = {"energy error": (ledger["energy_error"].values, BLACK)}
    draw_curves(panels[1], results.times, error, "Energy error", ledger["energy_error"].unit)
    for axes, name in zip(panels[2:], MOMENTA):
        series = ledger[name]
        curves = {letter: (series.values[:, i], AXIS_COLOURS[letter]) for i, letter in enumerate("xyz")}
        draw_curves(axes, results.times, curves, name.replace("_", " ").capitalize(), series.unit)
    for axes in grid[-1]:
        axes.set_xlabel(results.time_label)


def draw_energies(axes, results, ledger):
    curves = {
        "kinetic": (ledger["kinetic_energy"].values, BLUE),
        "strain": (ledger["strain_energy"].values, ORANGE),
        "work": (ledger["external_work"].values, GREEN),
        "dissipated": (ledger["dissipated_energy"].values, PURPLE),
    }
    if "numerical_dissipation" in ledger:  # not in files of older versions
        curves["dissipated by the scheme"] = (ledger["numerical_dissipation"].values, AXIS_COLOURS["x"])
    always = "strain" if results.is_static else "kinetic"
    shown = {name: curve for name, curve in curves.items() if name == always or curve[0].any()}
    draw_curves(axes, results.times, shown, "Energies", ledger["kinetic_energy"].unit)
