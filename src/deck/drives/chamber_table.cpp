#include "deck/drives/chamber_table.hpp"

#include "deck/schema/schema_tables.hpp"

namespace gxrod {

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
            .unit("mass/(length·time²)").required().also("p")
        .key("from", &T::from, "Where it starts, as a fraction of the rod's length, where a node is placed.")
            .unit("1").between(0, 1)
        .key("to", &T::to, "Where it ends, likewise.")
            .unit("1").between(0, 1)
        .key("factor", &T::factor, factor_sentence("pressure"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it is under pressure; in others it has none.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
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

}  // namespace

void build_chambers(BuildContext& context) {
    for (const ChamberTable& given : tables_of<ChamberTable>(context.deck, chamber_table())) {
        std::optional<Tendon> chamber = lay_tendon(given, context);
        if (!chamber) continue;
        chamber->tension =
            find_tension(find_acting(given, context).apply(given.pressure.function), given.area);
        context.model.tendons.push_back(std::move(*chamber));
    }
}

}  // namespace gxrod
