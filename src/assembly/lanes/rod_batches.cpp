#include "assembly/lanes/rod_batches.hpp"

#include <algorithm>

#include "assembly/lanes/lane_column.hpp"
#include "elements/lanes/kernel_rows.hpp"

namespace gxrod {

namespace {

// Whether a node of a lane is an earlier one of a lane behind it: what both add to it would change its order.
template <int Nodes>
bool is_in_order(const std::array<int, Nodes>& first, const std::array<int, Nodes>& second) {
    for (int i = 0; i < Nodes; ++i) {
        for (int j = i + 1; j < Nodes; ++j) {
            if (first[i] == second[j]) return false;
        }
    }
    return true;
}

}  // namespace

template <int Nodes>
void RodBatches<Nodes>::build(const Block& block,
                              const EquationNumbers& equations,
                              const DriveValues& drives) {
    block_ = &block;
    equations_ = &equations;
    for (std::size_t part = 0; part < block.phases.part_count(); ++part) add_part(part, drives);
    first_batch_.push_back(batches_.size());
    write_sections();
    write_constants();
    for (Batch& batch : batches_) find_blocks(batch);
}

template <int Nodes>
void RodBatches<Nodes>::find_blocks(Batch& batch) const {
    const auto has_blocks = [&](int lane) { return block_->places[batch.elements[lane]].slots.empty(); };
    int first = 0, last = batch.count;
    while (first < last && !has_blocks(first)) ++first;
    while (last > first && !has_blocks(last - 1)) --last;
    for (int lane = first; lane < last; ++lane) {
        bool fits = has_blocks(lane);
        for (int before = first; before < lane; ++before)
            fits = fits && is_in_order<Nodes>(batch.nodes[before], batch.nodes[lane]);
        if (!fits) last = first;
    }
    batch.first_block = first;
    batch.last_block = last;
}

template <int Nodes>
bool RodBatches<Nodes>::is_alone(int e, const DriveValues& drives) const {
    const ObjectiveElement<Nodes>& element = block_->elements[e];
    return element.has_law() || element.is_damped_unevenly() || drives.is_driven(block_->rods[e].rod) ||
           (element.inertia().has_offset() && !element.inertia().section(0).has_inertia);
}

template <int Nodes>
void RodBatches<Nodes>::add_part(std::size_t part, const DriveValues& drives) {
    first_batch_.push_back(batches_.size());
    for (std::size_t e = block_->phases.first(part); e < block_->phases.last(part); ++e)
        add_to_batches(static_cast<int>(e), drives);
}

template <int Nodes>
void RodBatches<Nodes>::add_to_batches(int element, const DriveValues& drives) {
    const ObjectiveElement<Nodes>& added = block_->elements[element];
    const bool fits = batches_.size() > first_batch_.back() && batches_.back().count < width_ &&
                      is_alone(element, drives) == batches_.back().is_alone &&
                      make_shared_rows<Nodes>(added) ==
                          make_shared_rows<Nodes>(block_->elements[batches_.back().elements[0]]);
    if (!fits) {
        batches_.push_back({.section = 0,
                            .is_general = added.is_damped() || added.inertia().has_offset(),
                            .is_damped = added.is_damped(),
                            .is_alone = is_alone(element, drives),
                            .count = 0,
                            .first_block = 0,
                            .last_block = 0,
                            .elements = {},
                            .nodes = {}});
    }
    Batch& batch = batches_.back();
    for (int lane = batch.count++; lane < width_; ++lane) {
        batch.elements[lane] = element;
        batch.nodes[lane] = added.nodes;
    }
}

template <int Nodes>
void RodBatches<Nodes>::write_sections() {
    const std::size_t size =
        static_cast<std::size_t>(Rows::shared_rows) + static_cast<std::size_t>(Rows::section_rows) * width_;
    std::vector<double> rows(size);
    for (Batch& batch : batches_) {
        std::ranges::copy(make_shared_rows<Nodes>(block_->elements[batch.elements[0]]), rows.begin());
        for (int lane = 0; lane < width_; ++lane) {
            LaneColumn column(&rows[Rows::shared_rows], lane, width_);
            for (const double row : make_section_rows<Nodes>(block_->elements[batch.elements[lane]]))
                column.write(row);
        }
        // Most batches are of the section of the one before.
        const bool is_same =
            !sections_.empty() && std::equal(rows.begin(), rows.end(), sections_.end() - std::ssize(rows));
        if (!is_same) sections_.insert(sections_.end(), rows.begin(), rows.end());
        batch.section = sections_.size() - size;
    }
}

template <int Nodes>
void RodBatches<Nodes>::write_constants() {
    const std::size_t batch_size = static_cast<std::size_t>(Rows::constant_rows) * width_;
    constants_.resize(batches_.size() * batch_size);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        for (int lane = 0; lane < width_; ++lane) {
            LaneColumn column(&constants_[b * batch_size], lane, width_);
            for (const double constant :
                 make_constant_rows<Nodes>(block_->elements[batches_[b].elements[lane]])) {
                column.write(constant);
            }
        }
    }
}

template <int Nodes>
void RodBatches<Nodes>::write_motions(const Batch& batch,
                                      const std::vector<NodeMotion>& motions,
                                      const Vec3& gravity,
                                      double* rows) const {
    for (int lane = 0; lane < width_; ++lane) {
        const std::array<int, Nodes>& nodes = batch.nodes[lane];
        LaneColumn column(rows, lane, width_);
        for (const int node : nodes) column.write(motions[node].Lambda);
        for (int i = 1; i < Nodes; ++i) column.write(Vec3(motions[nodes[i]].r - motions[nodes[0]].r));
        for (const int node : nodes) column.write(Vec3(motions[node].a - gravity));
        if (!batch.is_general) continue;
        for (const int node : nodes) column.write(motions[node].omega);
        for (const int node : nodes) column.write(motions[node].alpha);
        for (const int node : nodes) column.write(motions[node].v);
    }
}

template <int Nodes>
void RodBatches<Nodes>::write_linearizations(const Batch& batch,
                                             const std::vector<NodeMotion>& motions,
                                             const Vec3& gravity,
                                             const std::vector<NodeLinearization>& linearizations,
                                             double* rows) const {
    for (int lane = 0; lane < width_; ++lane) {
        const std::array<int, Nodes>& nodes = batch.nodes[lane];
        LaneColumn column(rows, lane, width_);
        for (const int node : nodes) column.write(motions[node].Lambda);
        for (int i = 1; i < Nodes; ++i) column.write(Vec3(motions[nodes[i]].r - motions[nodes[0]].r));
        for (const int node : nodes) column.write(linearizations[node].placement);
        for (const int node : nodes) column.write(linearizations[node].acceleration);
        if (!batch.is_general) continue;
        for (const int node : nodes) column.write(Vec3(motions[node].a - gravity));
        for (const int node : nodes) column.write(motions[node].omega);
        for (const int node : nodes) column.write(motions[node].alpha);
        for (const int node : nodes) column.write(motions[node].v);
        for (const int node : nodes) column.write(linearizations[node].rate);
        for (const int node : nodes) column.write(linearizations[node].d_omega);
        for (const int node : nodes) column.write(linearizations[node].d_alpha);
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_lanes(const Batch& batch, const double* forces, std::vector<Vec6>& nodal) const {
    for (int lane = 0; lane < batch.count; ++lane) {
        const double* force = forces + lane;
        for (const int node : batch.nodes[lane]) {
            for (int i = 0; i < 6; ++i, force += width_) nodal[node][i] += *force;
        }
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_forces(std::size_t part,
                                   const State& state,
                                   const Instant& instant,
                                   const Vec3& gravity,
                                   std::vector<Vec6>& nodal,
                                   const PartScales& scales) const {
    alignas(64) std::array<double, Rows::motion_rows * most_lanes> rows;
    alignas(64) std::array<double, Rows::force_rows * most_lanes> forces;
    for (std::size_t b = first_batch_[part]; b < first_batch_[part + 1]; ++b) {
        const Batch& batch = batches_[b];
        if (!batch.is_alone) write_motions(batch, state.trial, gravity, rows.data());
        if (batch.is_alone ||
            !kernels_of(batch).compute_forces(section(batch), constants(b), rows.data(), forces.data())) {
            add_forces_alone(batch, state, instant, gravity, nodal, scales);
            continue;
        }
        add_lanes(batch, forces.data(), nodal);
        const double* largest = &forces[6 * Nodes * width_];
        for (int lane = 0; lane < batch.count; ++lane) {
            scales.of(block_->groups[batch.elements[lane]]).raise(largest[lane], largest[width_ + lane]);
        }
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_forces_alone(const Batch& batch,
                                         const State& state,
                                         const Instant& instant,
                                         const Vec3& gravity,
                                         std::vector<Vec6>& nodal,
                                         const PartScales& scales) const {
    for (int lane = 0; lane < batch.count; ++lane) {
        const auto e = static_cast<std::size_t>(batch.elements[lane]);
        const ObjectiveElement<Nodes>& element = block_->elements[e];
        const Histories histories = block_->histories(state, e, instant);
        const Motions<Nodes> nodes = block_->motions(state.trial, e);
        NodalVector<Nodes> internal = NodalVector<Nodes>::Zero();
        NodalVector<Nodes> inertial = NodalVector<Nodes>::Zero();
        element.add_internal_force(nodes, histories, internal);
        if (batch.is_damped) {
            element.add_viscous_force(nodes, histories, internal);
            element.inertia().add_translational_damping_force(nodes, internal);
        }
        element.inertia().add_translational_force(nodes, gravity, inertial);
        ForceScales& own = scales.of(block_->groups[batch.elements[lane]]);
        own.raise(internal);
        own.raise(inertial);
        add_to_nodes<Nodes>(internal + inertial, element.nodes, nodal);
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_damping_forces(std::size_t part,
                                           const State& state,
                                           const Instant& instant,
                                           std::vector<Vec6>& nodal) const {
    alignas(64) std::array<double, Rows::motion_rows * most_lanes> rows;
    alignas(64) std::array<double, Rows::force_rows * most_lanes> forces;
    for (std::size_t b = first_batch_[part]; b < first_batch_[part + 1]; ++b) {
        const Batch& batch = batches_[b];
        if (!batch.is_damped) continue;
        write_motions(batch, state.trial, Vec3::Zero(), rows.data());
        if (!batch.is_alone &&
            kernels_.compute_damping_forces(section(batch), constants(b), rows.data(), forces.data())) {
            add_lanes(batch, forces.data(), nodal);
        } else {
            add_damping_forces_alone(batch, state, instant, nodal);
        }
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_damping_forces_alone(const Batch& batch,
                                                 const State& state,
                                                 const Instant& instant,
                                                 std::vector<Vec6>& nodal) const {
    for (int lane = 0; lane < batch.count; ++lane) {
        const auto e = static_cast<std::size_t>(batch.elements[lane]);
        const ObjectiveElement<Nodes>& element = block_->elements[e];
        const Histories histories = block_->histories(state, e, instant);
        const Motions<Nodes> nodes = block_->motions(state.trial, e);
        NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
        element.add_viscous_force(nodes, histories, force);
        element.inertia().add_translational_damping_force(nodes, force);
        add_to_nodes<Nodes>(force, element.nodes, nodal);
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_tangents(std::size_t part,
                                     const State& state,
                                     const Instant& instant,
                                     const Vec3& gravity,
                                     const std::vector<NodeLinearization>& linearizations,
                                     std::vector<double>& values) const {
    alignas(64) std::array<double, Rows::linearization_rows * most_lanes> rows;
    alignas(64) std::array<double, Rows::tangent_rows * most_lanes> tangents;
    for (std::size_t b = first_batch_[part]; b < first_batch_[part + 1]; ++b) {
        const Batch& batch = batches_[b];
        if (!batch.is_alone) write_linearizations(batch, state.trial, gravity, linearizations, rows.data());
        if (batch.is_alone ||
            !kernels_of(batch).compute_tangents(section(batch), constants(b), rows.data(), tangents.data())) {
            add_tangents_alone(batch, state, instant, gravity, linearizations, values);
            continue;
        }
        add_lanes(batch, tangents.data(), values);
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_lanes(const Batch& batch,
                                  const double* tangents,
                                  std::vector<double>& values) const {
    for (int lane = 0; lane < batch.first_block; ++lane)
        add_tangent_of_lane(tangents + lane, batch.elements[lane], values);
    if (batch.last_block > batch.first_block) {
        std::array<double, 36> spare{};  // where the other lanes go
        std::array<LaneBlock, Nodes * Nodes * most_lanes> blocks;
        for (int lane = 0; lane < width_; ++lane) {
            const bool is_used = lane >= batch.first_block && lane < batch.last_block;
            const auto& places = block_->places[batch.elements[lane]].blocks;
            for (int pair = 0; pair < Nodes * Nodes; ++pair) {
                blocks[pair * width_ + lane] =
                    is_used ? LaneBlock{&values[places[pair].first], places[pair].stride}
                            : LaneBlock{spare.data(), 6};
            }
        }
        kernels_.add_tangents(tangents, blocks.data());
    }
    for (int lane = batch.last_block; lane < batch.count; ++lane)
        add_tangent_of_lane(tangents + lane, batch.elements[lane], values);
}

template <int Nodes>
void RodBatches<Nodes>::add_tangent_of_lane(const double* tangents,
                                            int element,
                                            std::vector<double>& values) const {
    NodalMatrix<Nodes> tangent;
    for (int entry = 0; entry < Rows::tangent_rows; ++entry) tangent.data()[entry] = tangents[entry * width_];
    add_tangent(tangent, element, values);
}

template <int Nodes>
void RodBatches<Nodes>::add_tangents_alone(const Batch& batch,
                                           const State& state,
                                           const Instant& instant,
                                           const Vec3& gravity,
                                           const std::vector<NodeLinearization>& linearizations,
                                           std::vector<double>& values) const {
    for (int lane = 0; lane < batch.count; ++lane) {
        const auto e = static_cast<std::size_t>(batch.elements[lane]);
        const ObjectiveElement<Nodes>& element = block_->elements[e];
        const Histories histories = block_->histories(state, e, instant);
        const Motions<Nodes> nodal = block_->motions(state.trial, e);
        const Linearizations<Nodes> following = block_->point_at(linearizations, element.nodes);
        NodalMatrix<Nodes> tangent = NodalMatrix<Nodes>::Zero();
        element.add_internal_tangent(nodal, histories, following, tangent);
        if (batch.is_damped) {
            element.add_viscous_tangent(nodal, histories, following, tangent);
            element.inertia().add_translational_damping_tangent(nodal, following, tangent);
        }
        element.inertia().add_translational_tangent(nodal, gravity, following, tangent);
        add_tangent(tangent, batch.elements[lane], values);
    }
}

template <int Nodes>
void RodBatches<Nodes>::add_tangent(NodalMatrix<Nodes>& tangent,
                                    int element,
                                    std::vector<double>& values) const {
    turn_to_own_axes(std::span<const int>(block_->elements[element].nodes), *equations_, tangent);
    add_to_values<Nodes>(tangent, block_->places[element], values);
}

template class RodBatches<2>;
template class RodBatches<3>;
template class RodBatches<4>;
template class RodBatches<5>;

}  // namespace gxrod
