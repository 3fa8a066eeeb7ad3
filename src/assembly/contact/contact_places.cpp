#include "assembly/contact/contact_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "assembly/element_geometry.hpp"
#include "contact/meshes/mesh_surface.hpp"
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
        const double skin = model.contact.skin * radius;
        if (const TriangleMesh* mesh = obstacle.mesh())
            spacing = std::min(spacing, find_mesh_spacing(*mesh, radius, skin));
        const RoundShape* round = obstacle.round();
        if (round == nullptr || round->is_hollow) continue;
        spacing =
            std::min(spacing, 0.35 * std::sqrt(2.0 * (round->radius + radius) * model.contact.skin * radius));
    }
    return spacing;
}

// Whose chords stay within a quarter of the skin of the line: the sagitta is h²/8 over the radius of the
// bend. Elements of two nodes are chords themselves.
double find_chord(const Model& model, std::size_t rod) {
    if (model.rods[rod].order == 1) return std::numeric_limits<double>::infinity();
    return std::sqrt(2.0 * model.contact.skin * model.contact.radii[rod] * model.contact.bend_radii[rod]);
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
        std::copy_n(shapes.slope.begin(), nodes, place.slopes.begin());
        for (std::size_t j = 0; j < nodes; ++j)
            place.fraction += shapes.value[j] * rod.arc_length[first + j] / rod.length;
        all.places.push_back(place);
    }
    own.end_place = all.places.size();
    all.elements.push_back(own);
}

// A rod's section of the same radius would have a radius more at either end: so a sphere has a diameter.
void add_body(const Model& model, const ContactBody& shape, int pieces, ContactPlaces& all) {
    const Body& body = model.bodies[static_cast<std::size_t>(shape.body)];
    ContactElement own;
    own.rod = static_cast<int>(model.rods.size()) + shape.body;
    own.is_body = true;
    own.shape = static_cast<int>(&shape - model.contact.bodies.data());
    own.count = 1;
    own.nodes[0] = body.node;
    own.radius = shape.radius;
    own.law = {model.contact.skin * shape.radius, shape.force / shape.radius};
    own.first_place = all.places.size();
    const double length = (shape.ends[1] - shape.ends[0]).norm();
    for (int i = 0; i <= pieces; ++i) {
        ContactPlace place;
        place.element = static_cast<int>(all.elements.size());
        place.fraction = pieces == 0 ? 0.0 : static_cast<double>(i) / pieces;
        place.shapes[0] = 1.0;
        place.arm = body.attitude * (shape.ends[0] + place.fraction * (shape.ends[1] - shape.ends[0])).eval();
        const int sides = (i > 0 ? 1 : 0) + (i < pieces ? 1 : 0);
        place.weight = pieces == 0 ? 0.0 : 0.5 * sides * length / pieces;
        place.weight += (2 - sides) * shape.radius;
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
    return {position(place, state.trial) - position(place, state.previous),
            interpolate(place, state.trial, &NodeMotion::theta),
            element.radius};
}

Vec3 ContactPlaces::change(const ContactPlace& place,
                           const State& state,
                           const std::vector<Vec6>& increments) const {
    const ContactElement& element = elements[static_cast<std::size_t>(place.element)];
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < element.count; ++i)
        sum += place.shapes[static_cast<std::size_t>(i)] *
               increments[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])].head<3>();
    if (element.is_body)
        sum +=
            increments[static_cast<std::size_t>(element.nodes[0])].tail<3>().cross(arm(place, state.trial));
    return sum;
}

double ContactPlaces::reach(const ContactElement& element, const std::vector<Vec6>& increments) const {
    double furthest = 0.0;
    for (int i = 0; i < element.count; ++i)
        furthest = std::max(furthest,
                            increments[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])]
                                .head<3>()
                                .norm());
    if (!element.is_body) return largest_shape_sum * furthest;
    const double turn = increments[static_cast<std::size_t>(element.nodes[0])].tail<3>().norm();
    const double arm =
        std::max(places[element.first_place].arm.norm(), places[element.end_place - 1].arm.norm());
    return furthest + turn * arm;
}

ContactPlaces find_contact_places(const Model& model) {
    std::map<double, double> spacings;  // of radii
    const auto spacing_of = [&](double radius) {
        const auto [found, is_new] = spacings.emplace(radius, 0.0);
        if (is_new) found->second = find_spacing(model, radius);
        return found->second;
    };
    ContactPlaces all = find_places(
        model, [&](int rod) { return spacing_of(model.contact.radii[static_cast<std::size_t>(rod)]); });
    for (const ContactBody& body : model.contact.bodies) {
        constexpr double least_pieces = 8.0;
        const double length = (body.ends[1] - body.ends[0]).norm();
        const double pieces = std::max(least_pieces, length / spacing_of(body.radius));
        add_body(model, body, length == 0.0 ? 0 : static_cast<int>(std::ceil(pieces)), all);
    }
    return all;
}

ContactPlaces find_chord_places(const Model& model) {
    ContactPlaces all =
        find_places(model, [&](int rod) { return find_chord(model, static_cast<std::size_t>(rod)); });
    for (const ContactBody& body : model.contact.bodies) add_body(model, body, 1, all);
    return all;
}

}  // namespace gxrod
