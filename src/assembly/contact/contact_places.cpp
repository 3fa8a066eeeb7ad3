#include "assembly/contact/contact_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "assembly/element_geometry.hpp"
#include "contact/mesh_surface.hpp"
#include "loads/shape_functions.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"

namespace gxrod {

namespace {

// The nodes of an element on [−1, 1], and the weights of the rule at them.
struct Rule {
    std::vector<double> at, weights;
};

Rule find_rule(int order) {
    Rule rule;
    visit_node_count(order, [&](auto count) {
        const auto at = compute_node_positions<count>();
        rule.at.assign(at.begin(), at.end());
    });
    rule.weights.assign(rule.at.size(), 0.0);
    const ShapeFunctions shapes_at = find_shape_functions(order);
    for (const QuadraturePoint& point : list_gauss_rule(order + 1)) {
        const ShapeValues shapes = shapes_at(point.xi);
        for (std::size_t i = 0; i < rule.weights.size(); ++i)
            rule.weights[i] += point.weight * shapes.value[i];
    }
    return rule;
}

// The force of a crossing at half the skin is a thousandth of EA, over a length of two radii.
ContactLaw find_law(const Model& model, const Rod& rod, double radius) {
    const double EA = model.sections[static_cast<std::size_t>(rod.section)].stiffness(0, 0);
    return {model.contact.skin * radius, EA / (1000.0 * radius)};
}

// So close together that several of them are within the skin of a bulging obstacle where the rod touches it,
// and that no edge of a mesh gets between them.
double find_spacing(const Model& model, double radius) {
    double spacing = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : model.contact.obstacles) {
        if (obstacle.mesh) {
            spacing =
                std::min(spacing, find_mesh_spacing(*obstacle.mesh, radius, model.contact.skin * radius));
            continue;
        }
        if (obstacle.shape == Obstacle::Shape::plane || obstacle.is_hollow) continue;
        spacing = std::min(spacing,
                           0.35 * std::sqrt(2.0 * (obstacle.radius + radius) * model.contact.skin * radius));
    }
    return spacing;
}

// The nodes of the element, or equal pieces and the trapezoidal rule, which sums up a bump without steps.
Rule refine(const Rule& of_nodes, double pieces) {
    if (pieces <= static_cast<double>(of_nodes.at.size() - 1)) return of_nodes;
    const int count = static_cast<int>(std::ceil(pieces));
    Rule rule;
    for (int i = 0; i <= count; ++i) {
        rule.at.push_back(-1.0 + 2.0 * i / count);
        rule.weights.push_back((i == 0 || i == count ? 1.0 : 2.0) / count);
    }
    return rule;
}

void add_element(
    const Model& model, int index, int element, const Rule& rule, double spacing, ContactPlaces& all) {
    const Rod& rod = model.rods[static_cast<std::size_t>(index)];
    const std::size_t nodes = rule.at.size();
    const std::size_t first = static_cast<std::size_t>(element) * nodes;
    const ShapeFunctions shapes_at = find_shape_functions(rod.order);
    ContactElement own;
    own.rod = index;
    own.element = element;
    own.count = static_cast<int>(nodes);
    own.radius = model.contact.radii[static_cast<std::size_t>(index)];
    own.law = find_law(model, rod, own.radius);
    own.first_place = all.places.size();
    double length = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) own.nodes[i] = rod.element_nodes[first + i];
    const auto jacobian = [&](const ShapeValues& shapes) {
        Vec3 tangent = Vec3::Zero();
        for (std::size_t i = 0; i < nodes; ++i)
            tangent += shapes.slope[i] * model.nodes[static_cast<std::size_t>(own.nodes[i])].position;
        return tangent.norm();
    };
    for (std::size_t i = 0; i < nodes; ++i) length += rule.weights[i] * jacobian(shapes_at(rule.at[i]));
    const Rule places = refine(rule, length / spacing);
    for (std::size_t i = 0; i < places.at.size(); ++i) {
        const ShapeValues shapes = shapes_at(places.at[i]);
        ContactPlace place;
        place.element = static_cast<int>(all.elements.size());
        place.weight = places.weights[i] * jacobian(shapes);
        std::copy_n(shapes.value.begin(), nodes, place.shapes.begin());
        for (std::size_t j = 0; j < nodes; ++j)
            place.fraction += shapes.value[j] * rod.arc_length[first + j] / rod.length;
        all.places.push_back(place);
    }
    own.end_place = all.places.size();
    all.elements.push_back(own);
}

template <class FindSpacing>
ContactPlaces find_places(const Model& model, const FindSpacing& find) {
    ContactPlaces all;
    for (int index = 0; index < static_cast<int>(model.rods.size()); ++index) {
        const double radius = model.contact.radii[static_cast<std::size_t>(index)];
        if (radius == 0.0) continue;
        const Rod& rod = model.rods[static_cast<std::size_t>(index)];
        const Rule rule = find_rule(rod.order);
        const double spacing = find(index);
        for (int element = 0; element < rod.element_count(); ++element)
            add_element(model, index, element, rule, spacing, all);
    }
    return all;
}

}  // namespace

int ContactPlaces::nearest_node(const ContactPlace& from, const ContactPlace& to, double t) const {
    const ContactElement& element = elements[static_cast<std::size_t>(from.element)];
    // Of nodes at equal distances of ξ, the nearest one has the largest shape function.
    const auto shape = [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        return (1.0 - t) * from.shapes[at] + t * to.shapes[at];
    };
    int nearest = 0;
    for (int i = 1; i < element.count; ++i) {
        if (shape(i) > shape(nearest)) nearest = i;
    }
    return element.nodes[static_cast<std::size_t>(nearest)];
}

PlaceMotion ContactPlaces::motion_of(const ContactPlace& place, const State& state) const {
    const ContactElement& element = elements[static_cast<std::size_t>(place.element)];
    return {
        interpolate(place, state.trial, &NodeMotion::r) - interpolate(place, state.previous, &NodeMotion::r),
        interpolate(place, state.trial, &NodeMotion::theta),
        element.radius};
}

ContactPlaces find_contact_places(const Model& model) {
    std::map<double, double> spacings;  // of radii
    return find_places(model, [&](int rod) {
        const double radius = model.contact.radii[static_cast<std::size_t>(rod)];
        const auto [found, is_new] = spacings.emplace(radius, 0.0);
        if (is_new) found->second = find_spacing(model, radius);
        return found->second;
    });
}

ContactPlaces find_chord_places(const Model& model) {
    return find_places(model, [&](int rod) {
        const auto index = static_cast<std::size_t>(rod);
        // Elements of two nodes are chords themselves.
        if (model.rods[index].order == 1) return std::numeric_limits<double>::infinity();
        // The sagitta of a chord is h²/8 over the radius of the bend.
        return std::sqrt(2.0 * model.contact.skin * model.contact.radii[index] *
                         model.contact.bend_radii[index]);
    });
}

}  // namespace gxrod
