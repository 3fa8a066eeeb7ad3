#include "deck/build_context.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

std::optional<PlacedPoint> BuildContext::place(const std::string& point) const {
    const auto found = names.find(point);
    const Point* named = std::get_if<Point>(&found);
    if (named == nullptr) return std::nullopt;
    if (const auto* of_body = std::get_if<BodyPoint>(named)) {
        const int node = body_nodes[of_body->body];
        if (node < 0) return std::nullopt;
        return PlacedPoint{.node = node, .body = of_body->body};
    }
    const auto& [rod, fraction] = std::get<RodPoint>(*named);
    const std::vector<double>& fractions = rod_fractions[rod];
    if (fractions.empty()) return std::nullopt;
    const auto nearest =
        std::min_element(fractions.begin(), fractions.end(), [at = fraction](double a, double b) {
            return std::abs(a - at) < std::abs(b - at);
        });
    const int position = static_cast<int>(nearest - fractions.begin());
    return PlacedPoint{.node = model.rods[rod].nodes[position], .rod = rod, .position_in_rod = position};
}

}  // namespace gxrod
