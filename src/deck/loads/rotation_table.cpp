#include "deck/loads/acting.hpp"
#include "deck/loads/loads.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

struct RotationTable : TableHead {
    Vec3 axis = Vec3::UnitZ();
    Vec3 through = Vec3::Zero();
    CheckedTimeFunction speed;
    TableNames spins;
};

}  // namespace

const TableSpec& rotation_table() {
    using T = RotationTable;
    // clang-format off
    static const TableSpec table = Table<T>("[rotation]",
            "A steady rotation, for stages of kind steady. A frame turns, and supports turn with it: loads must follow the "
            "structure or point along the axis, and ties to the ground be alike to all sides of it. Or parts that "
            "are alike to all sides spin about their own axes in a frame at rest.")
        .key("axis", &T::axis, "About which it turns; any length.")
            .unit("1")
        .key("through", &T::through, "A point of the axis.")
            .unit("length")
        .key("spins", &T::spins, "Rods and bodies that spin about their own axes, all along `axis` at t = 0, in a frame "
             "at rest: sections and bodies must be alike to all sides, supports, bearings and gravity need not.")
            .names_of({"rod", "body"}).otherwise("a frame turns with everything").also("spinning rotors rotor")
        .key("speed", &T::speed, "Angular velocity by the load factor t of a steady stage; without t it is multiplied "
             "by t in the first stage that takes steps, and stays.")
            .unit("angle/time").required();
    // clang-format on
    return table;
}

namespace {

std::vector<bool> list_spinning(const std::vector<Part>& parts, const Model& model) {
    std::vector<bool> spinning(model.nodes.size(), false);
    for (const Part& part : parts) {
        if (part.body >= 0)
            spinning[static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(part.body)].node)] = true;
        if (part.rod < 0) continue;
        for (const int node : model.rods[static_cast<std::size_t>(part.rod)].nodes)
            spinning[static_cast<std::size_t>(node)] = true;
    }
    return spinning;
}

}  // namespace

void build_rotation(BuildContext& context) {
    for (const RotationTable& given : tables_of<RotationTable>(context.deck, rotation_table())) {
        if (given.axis.norm() == 0.0)
            return context.add_fault(given, given.axis, "expected a vector that is not zero");
        context.model.rotation = TurningFrame{
            given.axis.normalized(), given.through, find_acting(context).apply(given.speed.function)};
        if (!given.spins.names.empty())
            context.model.rotation->spinning =
                list_spinning(find_parts(given, given.spins, context), context.model);
    }
}

}  // namespace gxrod
