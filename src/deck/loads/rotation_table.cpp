#include "deck/loads/acting.hpp"
#include "deck/loads/loads.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

struct RotationTable : TableHead {
    Vec3 axis = Vec3::UnitZ();
    Vec3 through = Vec3::Zero();
    CheckedTimeFunction speed;
};

}  // namespace

const TableSpec& rotation_table() {
    using T = RotationTable;
    // clang-format off
    static const TableSpec table = Table<T>("[rotation]",
            "A frame that turns steadily, for stages of kind steady: supports turn with it. Loads must follow the "
            "structure or point along the axis.")
        .key("axis", &T::axis, "About which it turns; any length.")
            .unit("1")
        .key("through", &T::through, "A point of the axis.")
            .unit("length")
        .key("speed", &T::speed, "Angular velocity by the load factor t of a steady stage; without t it is multiplied "
             "by t in the first stage that takes steps, and stays.")
            .unit("angle/time").required();
    // clang-format on
    return table;
}

void build_rotation(BuildContext& context) {
    for (const RotationTable& given : tables_of<RotationTable>(context.deck, rotation_table())) {
        if (given.axis.norm() == 0.0)
            return context.add_fault(given, given.axis, "expected a vector that is not zero");
        context.model.rotation = TurningFrame{
            given.axis.normalized(), given.through, find_acting(context).apply(given.speed.function)};
    }
}

}  // namespace gxrod
