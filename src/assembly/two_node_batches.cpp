#include "assembly/two_node_batches.hpp"

#include "assembly/lane_column.hpp"

namespace gxrod {

void TwoNodeBatches::build(const Block& block, const EquationNumbers& equations) {
    block_ = &block;
    equations_ = &equations;
    is_member_.assign(block.elements.size(), false);
    for (std::size_t e = 0; e < block.elements.size(); ++e) {
        if (block.elements[e].inertia().has_offset()) continue;
        is_member_[e] = true;
        add_to_batches(static_cast<int>(e));
    }
    write_constants();
}

void TwoNodeBatches::add_to_batches(int element) {
    const auto& rod = block_->elements[element].two_node_rod();
    Section section;
    double* target = section.data();
    for (const Mat3* stiffness : {&rod.C_NN, &rod.C_NM, &rod.C_MM})
        target = std::copy_n(stiffness->data(), 9, target);
    const bool is_same = !sections_.empty() && sections_.back() == section;
    if (!is_same) sections_.push_back(section);
    if (!is_same || batches_.back().count == width_) {
        batches_.push_back({.section = sections_.size() - 1, .count = 0, .elements = {}, .nodes = {}});
    }
    Batch& batch = batches_.back();
    for (int lane = batch.count++; lane < width_; ++lane) {
        batch.elements[lane] = element;
        batch.nodes[lane] = block_->elements[element].nodes;
    }
}

void TwoNodeBatches::write_constants() {
    const std::size_t batch_size = static_cast<std::size_t>(TwoNodeKernels::constant_rows) * width_;
    constants_.resize(batches_.size() * batch_size);
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        for (int lane = 0; lane < width_; ++lane) {
            const ObjectiveElement<2>& element = block_->elements[batches_[b].elements[lane]];
            LaneColumn column(&constants_[b * batch_size], lane, width_);
            column.write(element.two_node_rod().length);
            column.write(element.two_node_rod().Gamma_0);
            column.write(element.two_node_rod().Kappa_0);
            for (const Quat& triad : element.triads()) column.write(triad);
            column.write(element.inertia().mass()(0, 0));
            column.write(element.inertia().mass()(0, 1));
            column.write(element.inertia().mass()(1, 1));
        }
    }
}

void TwoNodeBatches::add_forces(const std::vector<NodeMotion>& motions,
                                const Vec3& gravity,
                                Residual& residual) const {
    alignas(64) std::array<double, TwoNodeKernels::motion_rows * most_lanes> rows;
    alignas(64) std::array<double, TwoNodeKernels::force_rows * most_lanes> forces;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const Batch& batch = batches_[b];
        for (int lane = 0; lane < width_; ++lane) {
            const NodeMotion& motion_a = motions[batch.nodes[lane][0]];
            const NodeMotion& motion_b = motions[batch.nodes[lane][1]];
            LaneColumn column(rows.data(), lane, width_);
            column.write(motion_a.Lambda);
            column.write(motion_b.Lambda);
            column.write(Vec3(motion_b.r - motion_a.r));
            column.write(Vec3(motion_a.a - gravity));
            column.write(Vec3(motion_b.a - gravity));
        }
        kernels_.compute_forces(sections_[batch.section].data(), constants(b), rows.data(), forces.data());
        for (int lane = 0; lane < batch.count; ++lane) {
            const double* force = &forces[lane];
            for (const int node : batch.nodes[lane]) {
                for (int i = 0; i < 6; ++i, force += width_) residual.nodal[node][i] += *force;
            }
            residual.force_scale = std::max(residual.force_scale, force[0]);
            residual.moment_scale = std::max(residual.moment_scale, force[width_]);
        }
    }
}

void TwoNodeBatches::add_tangents(const std::vector<NodeMotion>& motions,
                                  const std::vector<NodeLinearization>& linearizations,
                                  std::vector<double>& values) const {
    alignas(64) std::array<double, TwoNodeKernels::linearization_rows * most_lanes> rows;
    alignas(64) std::array<double, TwoNodeKernels::tangent_rows * most_lanes> tangents;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const Batch& batch = batches_[b];
        for (int lane = 0; lane < width_; ++lane) {
            const auto [a, b_node] = batch.nodes[lane];
            LaneColumn column(rows.data(), lane, width_);
            column.write(motions[a].Lambda);
            column.write(motions[b_node].Lambda);
            column.write(Vec3(motions[b_node].r - motions[a].r));
            for (const int node : {a, b_node}) column.write(linearizations[node].placement);
            for (const int node : {a, b_node}) column.write(linearizations[node].acceleration);
        }
        kernels_.compute_tangents(
            sections_[batch.section].data(), constants(b), rows.data(), tangents.data());
        for (int lane = 0; lane < batch.count; ++lane)
            add_tangent(&tangents[lane], batch.elements[lane], values);
    }
}

// Of one lane.
void TwoNodeBatches::add_tangent(const double* tangents, int element, std::vector<double>& values) const {
    NodalMatrix<2> tangent;
    for (int entry = 0; entry < TwoNodeKernels::tangent_rows; ++entry) {
        tangent.data()[entry] = tangents[entry * width_];
    }
    turn_to_own_axes(std::span<const int>(block_->elements[element].nodes), *equations_, tangent);
    add_to_values<2>(tangent, block_->places[element], values);
}

}  // namespace gxrod
