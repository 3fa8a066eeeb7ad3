#include "face/variation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "contact/obstacle_distance.hpp"
#include "deck/text/override_key.hpp"
#include "deck/text/overrides.hpp"
#include "face/deck.hpp"
#include "face/unknown_name_error.hpp"
#include "model/contact.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

// Relative to the number. Errors of differences along derivatives that are carried along are its fourth
// power.
constexpr double relative_step = 5e-4;
// Where things rub: places that stick in one model and slide in another, unlike the analysed one, are as rare
// as the step is small.
constexpr double relative_step_of_friction = 1e-5;

const DeckNode* find(const DeckNode& deck, const std::vector<KeyStep>& steps) {
    const DeckNode* node = &deck;
    for (const KeyStep& step : steps) {
        if (const auto* name = std::get_if<std::string>(&step)) {
            const DeckEntry* entry = node->table() != nullptr ? node->find(*name) : nullptr;
            if (entry == nullptr) return nullptr;
            node = &entry->node;
        } else {
            const DeckNode::Array* array = node->array();
            const std::size_t index = std::get<std::size_t>(step);
            if (array == nullptr || index >= array->size()) return nullptr;
            node = &(*array)[index];
        }
    }
    return node;
}

std::optional<double> number_of(const DeckNode& node) {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&node.value)) return *number;
    return std::nullopt;
}

// Finds the key of a parameter, or any other key, and its number in the deck with its overrides.
std::pair<std::string, double> find_number(const Deck& deck, const std::string& name) {
    DeckNode tree = deck.source()->tree();
    FaultList faults(deck.file(), deck.overrides());
    apply_overrides(deck.overrides(), tree, faults);
    faults.throw_if_any();
    for (const std::string& key : {"parameters." + name, name}) {
        const auto steps = split_key(key);
        if (!steps) continue;
        const DeckNode* node = find(tree, *steps);
        if (node == nullptr) continue;
        if (const std::optional<double> number = number_of(*node)) return {key, *number};
        throw std::invalid_argument(name + " is not a number; take derivatives by the parameters in it");
    }
    std::vector<std::string> parameters;
    const DeckEntry* table = tree.find("parameters");
    if (table != nullptr && table->node.table() != nullptr) {
        for (const DeckEntry& entry : *table->node.table()) parameters.push_back(entry.key);
    }
    find_name("number of the deck", name, parameters);
    return {};
}

// Of the skin, by which a step of a number moves surfaces that touch: forces of contact are smooth on the
// scale of the gap alone, and impacts leave a small part of the skin.
constexpr double part_of_skin = 3e-5;
// And by which it moves nodes, which equilibria then move back.
constexpr double part_of_skin_of_nodes = 5e-2;

double find_skin(const Model& model) {
    double radius = std::numeric_limits<double>::infinity();
    for (const double own : model.contact.radii) {
        if (own > 0.0) radius = std::min(radius, own);
    }
    for (const ContactBody& body : model.contact.bodies) radius = std::min(radius, body.radius);
    return model.contact.skin * radius;
}

// Bounds by how much the surfaces of an obstacle differ, as seen from within `extent` of the origin.
double find_shift(const Obstacle& a, const Obstacle& b, double extent, double end_time) {
    double shift = 0.0;
    std::visit(
        [&](const auto& shape) {
            const auto& other = std::get<std::decay_t<decltype(shape)>>(b.shape);
            const std::vector<Vec3> points = shape.points(), others = other.points();
            for (std::size_t i = 0; i < std::min(points.size(), others.size()); ++i)
                shift = std::max(shift, (points[i] - others[i]).norm());
        },
        a.shape);
    if (a.plane() != nullptr) shift += extent * (a.plane()->normal - b.plane()->normal).norm();
    if (a.round() != nullptr) shift += std::abs(a.round()->radius - b.round()->radius);
    if (!a.motion || !b.motion) return shift;
    constexpr int samples = 16;
    double moved = 0.0;
    for (int i = 0; i <= samples; ++i) {
        const double time = end_time * i / samples;
        const ObstaclePlacement here = place_obstacle(a, time), there = place_obstacle(b, time);
        moved = std::max(moved,
                         (here.displacement - there.displacement).norm() +
                             extent * (here.rotation - there.rotation).norm());
    }
    return shift + moved;
}

// Bounds by how much surfaces that can touch and nodes differ, relative to what is small enough.
double find_excess(const Problem& a, const Problem& b) {
    const Contact &one = a.model.contact, &other = b.model.contact;
    double extent = 0.0, shift = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < std::min(a.model.nodes.size(), b.model.nodes.size()); ++i) {
        extent = std::max(extent, a.model.nodes[i].position.norm());
        moved = std::max(moved, (a.model.nodes[i].position - b.model.nodes[i].position).norm());
    }
    for (std::size_t i = 0; i < std::min(one.radii.size(), other.radii.size()); ++i)
        shift = std::max(shift, std::abs(one.radii[i] - other.radii[i]));
    for (std::size_t i = 0; i < std::min(one.bodies.size(), other.bodies.size()); ++i) {
        shift = std::max(shift, std::abs(one.bodies[i].radius - other.bodies[i].radius));
        for (std::size_t end = 0; end < 2; ++end)
            shift = std::max(shift, (one.bodies[i].ends[end] - other.bodies[i].ends[end]).norm());
    }
    const double end_time = end_of(a.stages.back().analysis);
    for (std::size_t i = 0; i < std::min(one.obstacles.size(), other.obstacles.size()); ++i) {
        if (one.obstacles[i].shape.index() == other.obstacles[i].shape.index())
            shift = std::max(shift, find_shift(one.obstacles[i], other.obstacles[i], extent, end_time));
    }
    return 0.5 * std::max(shift / part_of_skin, moved / part_of_skin_of_nodes) / find_skin(a.model);
}

}  // namespace

VariedNumber vary(const Deck& deck, const std::string& number) {
    const auto [key, value] = find_number(deck, number);
    double step = relative_step * (value != 0.0 ? std::abs(value) : 1.0);
    const auto build = [&](double steps) { return Deck(deck).set(key, value + steps * step).build_varied(); };
    Problem up = build(1.0), down = build(-1.0);
    if (rubs(up.model.contact)) {
        step *= relative_step_of_friction / relative_step;
        up = build(1.0);
        down = build(-1.0);
    }
    if (!up.model.contact.is_empty()) {
        const double excess = find_excess(up, down);
        if (excess > 1.0) {
            step /= excess;
            up = build(1.0);
            down = build(-1.0);
        }
    }
    return {number, {std::move(up), std::move(down), build(2.0), build(-2.0)}, step};
}

}  // namespace gxrod
