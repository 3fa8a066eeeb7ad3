#include "deck/drives/chamber_table.hpp"

#include <fmt/format.h>

#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

const TableSpec& gas_table() {
    using T = GasTable;
    // clang-format off
    static const TableSpec table = Table<T>("chamber.NAME.gas", "")
        .key("pressure", &T::pressure, "Above `ambient`, of this gas in `volume`. What changes it pumps gas in or lets "
             "it out.")
            .unit("mass/(length·time²)").otherwise("0").also("p p0 initial_pressure gauge_pressure")
        .key("ambient", &T::ambient, "The absolute pressure around the rod: that of the air is 101325 Pa.")
            .unit("mass/(length·time²)").required().at_least(0).also("p_ambient atmosphere atmospheric ambient_pressure patm")
        .key("exponent", &T::exponent, "n of p Vⁿ, p absolute: 1 at constant temperature, 1.4 for air that keeps its heat.")
            .unit("1").between(1, 2).also("n gamma kappa polytropic adiabatic_index")
        .key("volume", &T::volume, "The volume in which it has this pressure.")
            .unit("length³").above(0).otherwise("that at t = 0").also("v v0 initial_volume");
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& chamber_table() {
    using T = ChamberTable;
    // clang-format off
    static const TableSpec table = Table<T>("[chamber.NAME]",
            "A chamber that runs along a path within a rod, closed at both ends, whose pressure does the work p dV of "
            "its volume: area times length of the path. [Tendons and muscles](guide/tendons.md#chambers) explains it.")
        .key("on", &T::on, "The name of a rod.")
            .required().names_of({"rod"}).also("rod beam along")
        .key("offset", &T::offset, "Where its middle passes through the section: y and z, from the line of the rod. "
             "Functions of s, the arc length from the rod's start; or at fractions of the rod's length, straight "
             "between them, with a node at each.")
            .unit("length").required().also("at path position route centre")
        .key("area", &T::area, "Its area across, which the pressure does not change.")
            .unit("length²").required().above(0).also("cross_section a")
        .key("pressure", &T::pressure, "The pressure in it above that around the rod. Below 0 it sucks.")
            .unit("mass/(length·time²)").also("p")
        .key("volume", &T::volume, "Its volume, in place of a pressure: that of a liquid which a pump moves. The "
             "pressure follows. A value without t is reached from the volume at t = 0 in the first static stage.")
            .unit("length³").also("v")
        .key("gas", &T::gas, gas_table(), "A closed amount of gas, in place of a pressure: its pressure follows the "
             "volume, and its energy is strain energy.")
            .also("air closed sealed")
        .key("from", &T::from, "Where it starts, as a fraction of the rod's length, where a node is placed.")
            .unit("1").between(0, 1)
        .key("to", &T::to, "Where it ends, likewise.")
            .unit("1").between(0, 1)
        .key("factor", &T::factor, factor_sentence("pressure, or that of gas,"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it is under pressure; in others it has none.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
        .exactly_one_of({"pressure", "volume", "gas"})
        .shown_by(
            "[chamber.bellows]\n"
            "on       = \"flyer\"\n"
            "offset   = [0, 0.05]\n"
            "area     = 2e-4\n"
            "pressure = \"3*pulse(t)\"\n");
    // clang-format on
    return table;
}

namespace {

// −p A, of the same form in time.
TimeFunction find_tension(const TimeFunction& pressure, double area) {
    if (pressure.is_constant()) return TimeFunction(-area * pressure(0.0));
    return TimeFunction([pressure, area](double time) { return -area * pressure(time); },
                        pressure.switches(),
                        pressure.has_time());
}

// A volume is the length of a tendon that does not stretch and can push.
TendonWinch hold_volume(const ChamberTable& given, const Acting& acting, const BuildContext& context) {
    constexpr const char* no_meaning = "of a volume has no meaning; it goes with a pressure or gas";
    if (given.factor) context.add_fault(given, given.factor, no_meaning);
    if (given.load_case) context.add_fault(given, given.load_case, no_meaning);
    const TimeFunction& volume = given.volume->function;
    TendonWinch pump{.pulls_only = false, .is_released = acting.is_absent};
    pump.length = TimeFunction([volume, area = given.area](double time) { return volume(time) / area; },
                               volume.switches(),
                               volume.has_time());
    pump.share = find_share(volume, acting);
    return pump;
}

TendonWinch hold_gas(const GasTable& gas, const Acting& acting, const BuildContext& context) {
    TendonWinch law{.pulls_only = false, .is_released = acting.is_absent};
    const double first = gas.pressure.function(0.0);
    if (!(first + gas.ambient > 0.0)) {
        context.add_fault(
            gas,
            gas.ambient,
            fmt::format("pressure + ambient is {:.6g}, which is no gas; expected an absolute pressure "
                        "in ambient",
                        first + gas.ambient));
    }
    law.gas = ClosedGas{acting.apply(gas.pressure.function), gas.ambient, gas.exponent, gas.volume};
    return law;
}

}  // namespace

void build_chambers(BuildContext& context) {
    for (const ChamberTable& given : tables_of<ChamberTable>(context.deck, chamber_table())) {
        std::optional<Tendon> chamber = lay_tendon(given, context);
        if (!chamber) continue;
        const Acting acting = find_acting(given, context);
        chamber->area = given.area;
        if (given.pressure)
            chamber->tension = find_tension(acting.apply(given.pressure->function), given.area);
        else if (given.volume)
            chamber->winch = hold_volume(given, acting, context);
        else if (given.gas)
            chamber->winch = hold_gas(*given.gas, acting, context);
        context.model.tendons.push_back(std::move(*chamber));
    }
}

}  // namespace gxrod
