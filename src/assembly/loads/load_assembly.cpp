#include "assembly/loads/load_assembly.hpp"

#include <span>

#include "assembly/element_geometry.hpp"
#include "loads/distributed_load.hpp"
#include "loads/motion_load.hpp"
#include "loads/nodal_load.hpp"
#include "loads/shape_functions.hpp"

namespace gxrod {

namespace {

template <int Nodes>
LoadedElement make_loaded_element(const Model& model, const DistributedLoad& load, int element) {
    const Rod& rod = model.rods[load.rod];
    const RodElementGeometry<Nodes> geometry = find_geometry<Nodes>(model, rod, element);
    const std::array<Vec3, Nodes> positions = geometry.reference().positions;
    const auto first = rod.arc_length.begin() + element * Nodes;
    return {.load = &load,
            .nodes = {geometry.nodes.begin(), geometry.nodes.end()},
            .triads = {geometry.triads.begin(), geometry.triads.end()},
            .arc_lengths = {first, first + Nodes},
            .positions = {positions.begin(), positions.end()},
            .shapes = find_shape_functions(rod.order)};
}

std::vector<LoadedElement> make_loaded_elements(const Model& model) {
    std::vector<LoadedElement> elements;
    for (const DistributedLoad& load : model.distributed_loads) {
        const Rod& rod = model.rods[load.rod];
        for (int e = 0; e < rod.element_count(); ++e) {
            visit_node_count(rod.order, [&](auto node_count) {
                elements.push_back(make_loaded_element<node_count>(model, load, e));
            });
        }
    }
    return elements;
}

}  // namespace

LoadAssembly::LoadAssembly(const Model& model)
    : model_(&model), values_(model, make_loaded_elements(model)) {}

void LoadAssembly::lay_out(const Layout& layout) {
    equations_ = &layout.equations;
    groups_ = &layout.groups;
    length_ = layout.length;
    for (const NodalLoad& load : model_->loads)
        places_.push_back(find_places<1>({load.node}, layout.equations, layout.pattern));
    for (const LoadedElement& element : values_.elements()) {
        const std::size_t size = 6 * element.nodes.size();
        element_slots_.emplace_back(size * size);
        find_slots(element.nodes, layout.equations, layout.pattern, element_slots_.back());
    }
}

void LoadAssembly::subtract_forces(const State& state,
                                   double time,
                                   const ConstraintRequest& /*request*/,
                                   Residual& residual) const {
    values_.move_to(time);
    for (std::size_t i = 0; i < model_->loads.size(); ++i) {
        const NodalLoad& load = model_->loads[i];
        const Vec6 force = compute_load(load, values_.nodal()[i], state.trial[load.node], time);
        residual.raise_group(groups_->of_node(load.node), force);
        residual.nodal[load.node] -= force;
    }
    const std::vector<Vec6>& distributed = values_.add_distributed(state.trial);
    for (std::size_t i = 0; i < distributed.size(); ++i) {
        residual.raise_group(groups_->of_node(static_cast<int>(i)), distributed[i]);
        residual.nodal[i] -= distributed[i];
    }
    for (const LoadedElement& element : values_.elements()) {
        if (!element.load->by_motion) continue;
        const LoadVector forces = compute_motion_load(element, time, state.trial);
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
            const Vec6 force = forces.segment<6>(6 * static_cast<Eigen::Index>(i));
            residual.raise_group(groups_->of_node(element.nodes[i]), force);
            residual.nodal[static_cast<std::size_t>(element.nodes[i])] -= force;
        }
    }
}

void LoadAssembly::add_tangents(const State& state,
                                double time,
                                const ConstraintRequest& /*request*/,
                                const std::vector<NodeLinearization>& linearizations,
                                std::vector<double>& values) const {
    values_.move_to(time);
    for (std::size_t i = 0; i < model_->loads.size(); ++i) {
        const NodalLoad& load = model_->loads[i];
        if (load.frame == Frame::spatial && !load.by_motion) continue;
        const NodeMotion& motion = state.trial[load.node];
        const Vec6 force = compute_load(load, values_.nodal()[i], motion, time);
        const NodeLinearization& linearization = linearizations[load.node];
        Mat6 tangent = -compute_load_tangent(load, force, linearization);
        if (load.by_motion) tangent -= compute_motion_tangent(load, motion, linearization, time, length_);
        turn_to_own_axes(std::span(&load.node, 1), *equations_, tangent);
        add_to_values<1>(tangent, places_[i], values);
    }
    for (std::size_t i = 0; i < values_.elements().size(); ++i) {
        const LoadedElement& element = values_.elements()[i];
        const MotionLoad& by_motion = element.load->by_motion;
        if (element.load->frame == Frame::spatial && !by_motion) continue;
        LoadMatrix tangent = -compute_distributed_load_tangent(
            element, {time, values_.moments(i)}, state.trial, linearizations);
        if (by_motion)
            tangent -= compute_motion_load_tangent(element, time, state.trial, linearizations, length_);
        turn_to_own_axes(std::span<const int>(element.nodes), *equations_, tangent);
        add_to_values(tangent.data(), element_slots_[i], values);
    }
}

void LoadAssembly::subtract_element_forces(const State& state,
                                           double time,
                                           const RodPlace& place,
                                           Eigen::Ref<Eigen::VectorXd> forces) const {
    for (std::size_t i = 0; i < model_->distributed_loads.size(); ++i) {
        if (model_->distributed_loads[i].rod != place.rod) continue;
        values_.move_to(time);
        const std::size_t loaded = values_.first_element(i) + static_cast<std::size_t>(place.element);
        const LoadedElement& element = values_.elements()[loaded];
        forces -= compute_distributed_load(element, {time, values_.moments(loaded)}, state.trial);
        if (element.load->by_motion) forces -= compute_motion_load(element, time, state.trial);
    }
}

}  // namespace gxrod
