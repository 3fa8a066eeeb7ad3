#include "assembly/system_values.hpp"

#include <algorithm>

#include "assembly/surroundings_assembly.hpp"
#include "loads/shape_functions.hpp"

namespace gxrod {

std::vector<PointValues> SystemValues::compute_point_values(const State& state,
                                                            double time,
                                                            const std::vector<RodPlace>& places) const {
    std::vector<PointValues> values(places.size());
    // Forces of an element serve all of its places that follow one another.
    for (std::size_t first = 0, next = 0; first < places.size(); first = next) {
        const RodPlace& place = places[first];
        for (next = first + 1; next < places.size(); ++next) {
            const RodPlace& other = places[next];
            if (other.rod != place.rod || other.element != place.element || other.is_asked != place.is_asked)
                break;
        }
        if (place.is_asked)
            compute_points_of_element(state,
                                      time,
                                      std::span(places).subspan(first, next - first),
                                      std::span(values).subspan(first, next - first));
    }
    return values;
}

std::vector<PointSurroundings> SystemValues::compute_body_surroundings(const State& state,
                                                                       double time) const {
    std::vector<PointSurroundings> values;
    if (!system_->surroundings_) return values;
    for (std::size_t body = 0; body < system_->model_->bodies.size(); ++body)
        values.push_back(system_->surroundings_->compute_body_value(state, time, body));
    return values;
}

std::span<const double> SystemValues::compute_pressure_forces(const State& state, double time) const {
    if (!system_->surroundings_) return {};
    return system_->surroundings_->compute_pressure_forces(state, time);
}

std::span<const Vec3> SystemValues::compute_bed_forces(const State& state, double time) const {
    if (!system_->surroundings_) return {};
    return system_->surroundings_->compute_bed_forces(state, time);
}

void SystemValues::compute_points_of_element(const State& state,
                                             double time,
                                             std::span<const RodPlace> places,
                                             std::span<PointValues> values) const {
    const RodPlace& first_place = places.front();
    int index = first_place.element;
    for (int rod = 0; rod < first_place.rod; ++rod) index += system_->model_->rods[rod].element_count();
    for_each_block(system_->blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::has_section) {
            const auto found =
                std::lower_bound(block.section_index.begin(), block.section_index.end(), index);
            if (found == block.section_index.end() || *found != index) return;
            const auto e = static_cast<std::size_t>(found - block.section_index.begin());
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const Histories histories = block.histories(state, e, system_->instant_of_sections(state, time));
            NodalVector<Block::node_count> force = NodalVector<Block::node_count>::Zero();
            element.add_internal_force(motions, histories, force);
            if (element.is_damped()) element.add_damping_force(motions, histories, force);
            element.add_inertial_force(motions, system_->model_->gravity(time), force);
            for (const auto& load : system_->loads_)
                load->subtract_element_forces(state, time, first_place, force);
            for (std::size_t k = 0; k < places.size(); ++k) {
                const RodPlace& place = places[k];
                values[k] = element.point_values(motions, histories, force, place.xi);
                const auto shape = compute_shape_functions<Block::node_count>(place.xi);
                values[k].start.setZero();
                for (int i = 0; i < Block::node_count; ++i)
                    values[k].start += shape[i] * system_->model_->nodes[element.nodes[i]].position;
                if (system_->surroundings_)
                    values[k].surroundings = system_->surroundings_->compute_point_value(
                        state, time, place, find_shape_functions(Block::node_count - 1)(place.xi));
            }
        }
    });
}

std::vector<Vec6> SystemValues::compute_strain_work(const State& state,
                                                    const std::vector<Vec6>& increments) const {
    const Instant now = system_->instant(state);
    std::vector<Vec6> of_elements(static_cast<std::size_t>(system_->rod_element_count_), Vec6::Zero());
    for_each_block(system_->blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::has_section) {
            system_->team_->for_each_range(block.elements.size(), [&](std::size_t first, std::size_t last) {
                for (std::size_t e = first; e < last; ++e) {
                    const auto& element = block.elements[e];
                    NodalVector<Block::node_count> increment;
                    for (int i = 0; i < Block::node_count; ++i) {
                        increment.template segment<6>(6 * i) = increments[element.nodes[i]];
                    }
                    of_elements[block.section_index[e]] = element.compute_strain_work(
                        block.motions(state.trial, e), block.histories(state, e, now), increment);
                }
            });
        }
    });
    std::vector<Vec6> of_rods(system_->model_->rods.size(), Vec6::Zero());
    std::size_t element = 0;
    for (std::size_t rod = 0; rod < of_rods.size(); ++rod) {
        for (int e = 0; e < system_->model_->rods[rod].element_count(); ++e)
            of_rods[rod] += of_elements[element++];
    }
    return of_rods;
}

std::vector<TendonValues> SystemValues::compute_tendon_values(const State& state, double time) const {
    return system_->tendon_lines_.compute_values(state, system_->joints_, time);
}

std::vector<SectionValues> SystemValues::compute_section_values(const State& state) const {
    const Instant now = system_->instant_of_sections(state, state.trial_time);
    std::vector<SectionValues> values(static_cast<std::size_t>(system_->rod_element_count_));
    for_each_block(system_->blocks_, [&](const auto& block) {
        if constexpr (std::remove_cvref_t<decltype(block)>::has_section) {
            system_->team_->for_each_range(block.elements.size(), [&](std::size_t first, std::size_t last) {
                for (std::size_t e = first; e < last; ++e) {
                    values[block.section_index[e]] = block.elements[e].section_values(
                        block.motions(state.trial, e), block.histories(state, e, now));
                }
            });
        }
    });
    return values;
}

}  // namespace gxrod
