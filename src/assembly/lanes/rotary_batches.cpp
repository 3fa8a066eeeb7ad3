#include "assembly/lanes/rotary_batches.hpp"

#include <algorithm>

#include "assembly/lanes/lane_column.hpp"

namespace gxrod {

RotaryBatches::RotaryBatches(const RotaryKernels& kernels, int width, const EquationNumbers& equations)
    : width_(width), kernels_(kernels), equations_(&equations), index_(equations.node_count(), -1) {}

void RotaryBatches::add(int node, int group, const Mat3& inertia) {
    if (index_[node] < 0) {
        index_[node] = static_cast<int>(nodes_.size());
        nodes_.push_back(node);
        groups_.push_back(group);
        inertias_.push_back(Mat3::Zero());
    }
    inertias_[index_[node]] += inertia;
}

void RotaryBatches::find_part_groups() {
    part_groups_.resize(part_count());
    for (std::size_t part = 0; part < part_count(); ++part) {
        std::vector<int>& own = part_groups_[part];
        own.assign(&groups_[part * part_size],
                   &groups_[part * part_size] + (last_of(part) - part * part_size));
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        for (std::size_t i = part * part_size; i < last_of(part); ++i)
            groups_[i] = static_cast<int>(std::lower_bound(own.begin(), own.end(), groups_[i]) - own.begin());
    }
}

void RotaryBatches::lay_out(const SparsePattern& pattern) {
    find_part_groups();
    const std::size_t batches = (nodes_.size() + width_ - 1) / width_;
    constants_.resize(batches * RotaryKernels::constant_rows * width_);
    for (std::size_t lane = 0; lane < batches * width_; ++lane) {
        LaneColumn(&constants_[lane / width_ * RotaryKernels::constant_rows * width_],
                   static_cast<int>(lane % width_),
                   width_)
            .write(inertias_[std::min(lane, nodes_.size() - 1)]);
    }
    inertias_ = std::vector<Mat3>();
    index_ = std::vector<int>();
    nodes_.shrink_to_fit();
    places_.reserve(nodes_.size());
    for (const int node : nodes_) places_.push_back(find_places<1>({node}, *equations_, pattern));
}

void RotaryBatches::add_forces(std::size_t part,
                               const std::vector<NodeMotion>& motions,
                               std::vector<Vec6>& nodal,
                               std::span<ForceScales> scales) const {
    alignas(64) std::array<double, RotaryKernels::motion_rows * most_lanes> rows;
    alignas(64) std::array<double, RotaryKernels::moment_rows * most_lanes> moments;
    for (std::size_t first = part * part_size; first < last_of(part); first += width_) {
        for (int lane = 0; lane < width_; ++lane) {
            const NodeMotion& motion = motions[node_of(first + lane)];
            LaneColumn column(rows.data(), lane, width_);
            column.write(motion.Lambda);
            column.write(motion.omega);
            column.write(motion.alpha);
        }
        kernels_.compute_moments(
            &constants_[first * RotaryKernels::constant_rows], rows.data(), moments.data());
        for (int lane = 0; lane < width_ && first + lane < nodes_.size(); ++lane) {
            const Vec3 moment(moments[lane], moments[width_ + lane], moments[2 * width_ + lane]);
            scales[groups_[first + lane]].raise(0.0, moment.lpNorm<Eigen::Infinity>());
            nodal[node_of(first + lane)].tail<3>() += moment;
        }
    }
}

void RotaryBatches::add_tangents(std::size_t part,
                                 const std::vector<NodeMotion>& motions,
                                 const std::vector<NodeLinearization>& linearizations,
                                 std::vector<double>& values) const {
    alignas(64) std::array<double, RotaryKernels::linearization_rows * most_lanes> rows;
    alignas(64) std::array<double, RotaryKernels::tangent_rows * most_lanes> tangents;
    for (std::size_t first = part * part_size; first < last_of(part); first += width_) {
        for (int lane = 0; lane < width_; ++lane) {
            const int node = node_of(first + lane);
            LaneColumn column(rows.data(), lane, width_);
            column.write(motions[node].Lambda);
            column.write(motions[node].omega);
            column.write(motions[node].alpha);
            column.write(linearizations[node].placement);
            column.write(linearizations[node].d_omega);
            column.write(linearizations[node].d_alpha);
        }
        kernels_.compute_tangents(
            &constants_[first * RotaryKernels::constant_rows], rows.data(), tangents.data());
        for (int lane = 0; lane < width_ && first + lane < nodes_.size(); ++lane) {
            add_tangent(&tangents[lane], first + lane, values);
        }
    }
}

void RotaryBatches::add_tangent(const double* tangents, std::size_t lane, std::vector<double>& values) const {
    const ElementPlaces<1>& place = places_[lane];
    Mat3 by_spin;
    for (int entry = 0; entry < RotaryKernels::tangent_rows; ++entry)
        by_spin.data()[entry] = tangents[entry * width_];
    if (place.slots.empty()) {
        const auto [first, stride] = place.blocks[0];
        for (int column = 0; column < 3; ++column) {
            double* target = &values[first + (column + 3) * stride + 3];
            for (int row = 0; row < 3; ++row) target[row] += by_spin(row, column);
        }
        return;
    }
    const int node = node_of(lane);
    Mat6 tangent = Mat6::Zero();
    tangent.bottomRightCorner<3, 3>() = by_spin;
    turn_to_own_axes(std::span(&node, 1), *equations_, tangent);
    add_to_values<1>(tangent, place, values);
}

}  // namespace gxrod
