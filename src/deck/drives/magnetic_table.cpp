#include "deck/drives/build_drives.hpp"
#include "deck/drives/place_field.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

struct MagneticTable : ActingTable {
    TableName on;
    CheckedLineVector moment;
    FieldVector field;
};

}  // namespace

const TableSpec& magnetic_table() {
    using T = MagneticTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[magnetic]]",
            "A rod that is magnetic along its length, in a field: couples μ × B and, where the field changes with the "
            "place, forces (∇B)ᵀ μ.")
        .key("on", &T::on, "The name of a rod.")
            .required().names_of({"rod"}).also("rod beam along")
        .key("moment", &T::moment,
             "Magnetic moment μ per reference length, in section axes; s is the arc length from the rod's start.")
            .unit("current·length").required().also("m magnetization magnetisation mu")
        .key("field", &T::field, "Flux density B, global components; x, y, z is where the section is then.")
            .unit("mass/(current·time²)").required().also("b flux_density")
        .key("factor", &T::factor, factor_sentence("field"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which the field acts.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
        .shown_by(
            "[[magnetic]]\n"
            "on     = \"tail\"\n"
            "moment = [0.5, 0, 0]\n"
            "field  = [0, \"0.01*sin(10*t)\", \"0.02*z\"]\n");
    // clang-format on
    return table;
}

namespace {

void add_magnetic(const MagneticTable& given, BuildContext& context) {
    const std::optional<Part> part = find_part(given, given.on, context);
    const Acting acting = find_acting(given, context);
    if (!part || acting.is_absent) return;
    DistributedLoad load{
        .key = given.path, .rod = part->rod, .force = {}, .moment = {}, .frame = Frame::body, .field = {}};
    for (std::size_t i = 0; i < 3; ++i) load.moment[i] = given.moment[i].expression.function;
    // The field grows and follows factors; the moment does not, or their product would grow twice.
    PlaceField field = make_field(given.field.components, acting);
    load.field = MagneticField{std::move(field.uniform), std::move(field.by_place)};
    context.model.distributed_loads.push_back(std::move(load));
}

}  // namespace

void build_magnets(BuildContext& context) {
    for (const MagneticTable& given : tables_of<MagneticTable>(context.deck, magnetic_table()))
        add_magnetic(given, context);
}

}  // namespace gxrod
