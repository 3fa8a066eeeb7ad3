#include "deck/drives/build_drives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/build/acting.hpp"
#include "deck/build/part.hpp"
#include "deck/drives/tendon_path.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

// The rod of a table; nullopt, with a fault, if there is none.
std::optional<int> find_rod(const CheckedTable& table, const TableSpec& spec, const BuildContext& context) {
    const std::optional<Part> part = find_part(table, *spec.find("on"), context);
    return part ? std::optional(part->rod) : std::nullopt;
}

const Rod& rod_of(int index, const BuildContext& context) {
    return context.model.rods[static_cast<std::size_t>(index)];
}

// What is wrong with a path where elements look at it.
void check_path(const CheckedTable& table, const Tendon& tendon, const BuildContext& context) {
    try {
        for (const double s : list_force_points(rod_of(tendon.rod, context))) {
            if (s > tendon.from && s < tendon.to) tendon.path(s);
        }
    } catch (const EvaluationError& error) {
        // Its text begins with the key, "tendon.pull.offset[1]".
        const std::string text = error.what();
        const std::size_t end = text.find(": ");
        context.faults.add(table.place_of("offset"), text.substr(0, end), text.substr(end + 2));
    }
}

void add_tendon(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, tendon_table(), context);
    const std::optional<TendonRange> range = find_tendon_range(table, context);
    if (!rod || !range) return;
    if (context.deck.tables("rod")[static_cast<std::size_t>(*rod)].gives("mesh"))
        return context.add_fault(table, "on", "a rod from a mesh has no tendons; expected one along a line");
    const double length = rod_of(*rod, context).length;
    Tendon tendon{
        .name = table.name,
        .rod = *rod,
        .from = range->from * length,
        .to = range->to * length,
        .tension = find_acting(table, context).apply(table.get<CheckedTimeFunction>("tension").function),
        .path = make_tendon_path(table.get<CheckedTendonPath>("offset"), *range, length)};
    if (context.stage == 0) check_path(table, tendon, context);
    context.model.tendons.push_back(std::move(tendon));
}

bool expands(const Section& section) { return section.expansion != 0.0; }

// Heat needs a section that expands.
void check_expansion(const CheckedTable& table, const Rod& rod, const BuildContext& context) {
    const char* key = table.gives("temperature") ? "temperature" : "temperature_gradient";
    if (!table.gives(key) || context.model.sections.empty()) return;
    const Section& section = context.model.sections[static_cast<std::size_t>(rod.section)];
    if (std::ranges::any_of(rod.varying.at_forces, expands) ||
        (!rod.has_varying_sections() && expands(section)))
        return;
    context.add_fault(
        table,
        key,
        fmt::format("the section of the rod {} has no expansion, so that heat does nothing; expected "
                    "a key expansion of its [section.NAME]",
                    rod.name));
}

// Components of a key that the deck gives.
template <std::size_t Count>
std::array<LineFunction, Count> functions_of(const CheckedTable& table,
                                             const char* key,
                                             const Acting& acting) {
    std::array<LineFunction, Count> functions;
    if (!table.gives(key)) return functions;
    const auto& components = table.get<std::array<CheckedLineFunction, Count>>(key);
    for (std::size_t i = 0; i < Count; ++i) functions[i] = acting.apply(components[i].expression);
    return functions;
}

LineFunction function_of(const CheckedTable& table, const char* key, const Acting& acting) {
    if (!table.gives(key)) return {};
    return acting.apply(table.get<CheckedLineFunction>(key).expression);
}

void add_actuation(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, actuation_table(), context);
    const Acting acting = find_acting(table, context);
    if (!rod || acting.is_absent) return;
    check_expansion(table, rod_of(*rod, context), context);
    const std::array<LineFunction, 2> shear = functions_of<2>(table, "shear", acting);
    const std::array<LineFunction, 3> curvature = functions_of<3>(table, "curvature", acting);
    context.model.actuations.push_back(
        {.key = table.path,
         .rod = *rod,
         .strain = {function_of(table, "stretch", acting),
                    shear[0],
                    shear[1],
                    curvature[0],
                    curvature[1],
                    curvature[2]},
         .temperature = function_of(table, "temperature", acting),
         .temperature_gradient = functions_of<2>(table, "temperature_gradient", acting)});
}

// The field grows and follows factors; the moment does not, or their product would grow twice.
MagneticField make_field(const CheckedMotionVector& components, const Acting& acting) {
    MagneticField field;
    std::array<MotionComponent, 3> by_place;
    for (std::size_t i = 0; i < 3; ++i) {
        const MotionExpression& component = components[i].expression;
        if (component.by_motion) {
            by_place[i] = acting.apply(component);
        } else {
            field.uniform[i] = acting.apply(component.by_time);
        }
    }
    if (!by_place[0] && !by_place[1] && !by_place[2]) return field;
    field.by_place = [by_place](double time, const Vec3& position) {
        Vec3 value = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            if (by_place[i]) value[static_cast<Eigen::Index>(i)] = by_place[i](time, position, Vec3::Zero());
        }
        return value;
    };
    return field;
}

void add_magnetic(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, magnetic_table(), context);
    const Acting acting = find_acting(table, context);
    if (!rod || acting.is_absent) return;
    DistributedLoad load{
        .key = table.path, .rod = *rod, .force = {}, .moment = {}, .frame = Frame::body, .field = {}};
    const auto& moment = table.get<CheckedLineVector>("moment");
    for (std::size_t i = 0; i < 3; ++i) load.moment[i] = moment[i].expression.function;
    load.field = make_field(table.get<CheckedMotionVector>("field"), acting);
    context.model.distributed_loads.push_back(std::move(load));
}

}  // namespace

void build_drives(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("tendon")) add_tendon(table, context);
    for (const CheckedTable& table : context.deck.tables("actuation")) add_actuation(table, context);
    for (const CheckedTable& table : context.deck.tables("magnetic")) add_magnetic(table, context);
}

}  // namespace gxrod
