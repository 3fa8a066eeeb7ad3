#include "results/tables/rod_places.hpp"

namespace gxrod {
namespace {

constexpr std::int64_t none = -1;

std::size_t nodes_per_element(const Rod& rod) { return static_cast<std::size_t>(rod.order) + 1; }

}  // namespace

RodPlaces find_cell_places(const Model& model) {
    RodPlaces places;
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        const Rod& rod = model.rods[i];
        const std::size_t nodes = nodes_per_element(rod);
        for (std::size_t first = 0; first < rod.arc_length.size(); first += nodes) {
            places.rod.push_back(static_cast<std::int64_t>(i));
            places.element.push_back(static_cast<std::int64_t>(first / nodes));
            places.arc_length.push_back(0.5 * (rod.arc_length[first] + rod.arc_length[first + nodes - 1]));
        }
    }
    const std::size_t cells = places.rod.size() + model.bodies.size();
    places.rod.resize(cells, none);
    places.element.resize(cells, none);
    places.arc_length.resize(cells, 0.0);
    return places;
}

RodPlaces find_point_places(const Model& model) {
    const std::size_t count = model.nodes.size();
    RodPlaces places{std::vector(count, none), std::vector(count, none), std::vector(count, 0.0)};
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        const Rod& rod = model.rods[i];
        for (std::size_t place = 0; place < rod.element_nodes.size(); ++place) {
            const auto node = static_cast<std::size_t>(rod.element_nodes[place]);
            if (places.rod[node] != none) continue;
            places.rod[node] = static_cast<std::int64_t>(i);
            places.element[node] = static_cast<std::int64_t>(place / nodes_per_element(rod));
            places.arc_length[node] = rod.arc_length[place];
        }
    }
    return places;
}

std::vector<double> list_arc_lengths(const Model& model) {
    std::vector<double> arc_lengths;
    for (const Rod& rod : model.rods) {
        const std::size_t nodes = nodes_per_element(rod);
        for (std::size_t first = 0; first < rod.arc_length.size(); first += nodes) {
            arc_lengths.push_back(rod.arc_length[first]);
            arc_lengths.push_back(rod.arc_length[first + nodes - 1]);
            for (std::size_t i = 1; i + 1 < nodes; ++i) arc_lengths.push_back(rod.arc_length[first + i]);
        }
    }
    arc_lengths.resize(arc_lengths.size() + model.bodies.size(), 0.0);
    return arc_lengths;
}

}  // namespace gxrod
