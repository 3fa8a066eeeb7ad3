#include "deck/sections/rest_shape.hpp"

#include "deck/sections/rod_sections.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// The curvature, material, of axes along a line: by differences of fourth order; their step is so small
// that what is left is round-off.
Vec3 compute_curvature(const DrawnRod& drawn, std::size_t piece, double fraction, double step) {
    const auto turn = [&](double distance) {
        const Quat before = drawn.axes(piece, fraction - distance);
        return log(before.conjugate() * drawn.axes(piece, fraction + distance));
    };
    const Vec3 by_fraction = (8.0 * turn(step) - turn(2.0 * step)) / (12.0 * step);
    return by_fraction / drawn.line.length();
}

// Of the rest at a place of the reference, zero without components; nullopt with a fault.
std::optional<Vec3> find_rest_curvature(const CheckedPlaceVector* components,
                                        const Vec3& position,
                                        double s,
                                        const BuildContext& context) {
    Vec3 curvature = Vec3::Zero();
    if (components == nullptr) return curvature;
    for (int i = 0; i < 3; ++i) {
        const CheckedPlaceFunction& component = (*components)[static_cast<std::size_t>(i)];
        try {
            curvature[i] = component.expression.function(position, s);
        } catch (const EvaluationError& error) {
            context.add_evaluation_fault(component.place, component.path, error);
            return std::nullopt;
        }
    }
    return curvature;
}

}  // namespace

void set_rest(const CheckedTable& table,
              const DrawnRod& drawn,
              const std::vector<double>& element_fractions,
              Rod& rod,
              const BuildContext& context) {
    // A hung line is straight and without twist where it is free of stress.
    if (!table.gives("rest") && !table.gives("catenary")) return;
    const CheckedPlaceVector* components = nullptr;
    if (table.gives("rest")) components = &table.tables("rest").front().get<CheckedPlaceVector>("curvature");
    const std::vector<double> points = list_force_points(rod.order);
    std::vector<Vec6> strains;
    for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
        const double first = element_fractions[e];
        const double length = element_fractions[e + 1] - first;
        const std::size_t piece = drawn.line.piece_at(first + 0.5 * length);
        for (const double point : points) {
            const double fraction = first + point * length;
            const auto rest = find_rest_curvature(
                components, drawn.line.position(piece, fraction), fraction * drawn.line.length(), context);
            if (!rest) return;
            Vec6 strain = Vec6::Zero();
            strain.tail<3>() = compute_curvature(drawn, piece, fraction, 1e-3 * length) - *rest;
            strains.push_back(strain);
        }
    }
    rod.rest_strains = std::move(strains);
}

}  // namespace gxrod
