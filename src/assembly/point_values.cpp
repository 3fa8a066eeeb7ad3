#include <algorithm>

#include "assembly/surroundings_assembly.hpp"
#include "assembly/system.hpp"
#include "loads/shape_functions.hpp"

// Points of rods: the part of System that histories look at.
namespace gxrod {

std::vector<PointValues> System::compute_point_values(const State& state,
                                                      double time,
                                                      const std::vector<RodPlace>& places) const {
    std::vector<PointValues> values;
    values.reserve(places.size());
    for (const RodPlace& place : places)
        values.push_back(place.is_asked ? compute_point_value(state, time, place) : PointValues{});
    return values;
}

std::vector<PointSurroundings> System::compute_body_surroundings(const State& state, double time) const {
    std::vector<PointSurroundings> values;
    if (!surroundings_) return values;
    for (std::size_t body = 0; body < model_->bodies.size(); ++body)
        values.push_back(surroundings_->compute_body_value(state, time, body));
    return values;
}

PointValues System::compute_point_value(const State& state, double time, const RodPlace& place) const {
    int index = place.element;
    for (int rod = 0; rod < place.rod; ++rod) index += model_->rods[rod].element_count();
    PointValues values;
    for_each_block(blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::has_section) {
            const auto found =
                std::lower_bound(block.section_index.begin(), block.section_index.end(), index);
            if (found == block.section_index.end() || *found != index) return;
            const auto e = static_cast<std::size_t>(found - block.section_index.begin());
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const Histories histories = block.histories(state, e, instant_of_sections(state, time));
            NodalVector<Block::node_count> force = NodalVector<Block::node_count>::Zero();
            element.add_internal_force(motions, histories, force);
            if (element.is_damped()) element.add_damping_force(motions, histories, force);
            element.add_inertial_force(motions, model_->gravity(time), force);
            for (const auto& load : loads_) load->subtract_element_forces(state, time, place, force);
            values = element.point_values(motions, histories, force, place.xi);
            const auto shape = compute_shape_functions<Block::node_count>(place.xi);
            values.start.setZero();
            for (int i = 0; i < Block::node_count; ++i)
                values.start += shape[i] * model_->nodes[element.nodes[i]].position;
            if (surroundings_)
                values.surroundings = surroundings_->compute_point_value(
                    state, time, place, find_shape_functions(Block::node_count - 1)(place.xi));
        }
    });
    return values;
}

}  // namespace gxrod
