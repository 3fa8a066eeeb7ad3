#include "assembly/joint_assembly.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/scatter.hpp"
#include "constraints/joints/joint_motors.hpp"

namespace gxrod {

namespace {

// Of the entries on the diagonal; it makes redundant equations solvable.
constexpr double regularization = 1e-8;
// D of rows of accelerations, relative to that of rows of positions. Where some are redundant, they
// contradict each other in the inner stages of a step: with a smaller D, their multipliers grow less.
constexpr double acceleration_scale = 1e-2;
// The least scale of a joint, relative to the largest.
constexpr double least_scale = 1e-6;

const NodeMotion ground{};
const NodeLinearization ground_linearization{};

const NodeLinearization& linearization(const std::vector<NodeLinearization>& nodes, int node) {
    return node < 0 ? ground_linearization : nodes[node];
}

// Of A and B; −1: the ground.
std::array<int, 2> nodes_of(const Joint& joint) { return {joint.a.anchor.node, joint.b.anchor.node}; }

JointLinearizations linearizations_of(const Joint& joint, const std::vector<NodeLinearization>& nodes) {
    return {linearization(nodes, joint.a.anchor.node), linearization(nodes, joint.b.anchor.node)};
}

std::vector<int> list_nodes(const Joint& joint) {
    std::vector<int> nodes;
    for (const int node : nodes_of(joint)) {
        if (node >= 0) nodes.push_back(node);
    }
    return nodes;
}

void set_slips(const JointSlips& slips, JointState& state) {
    state.turn_slip = slips.turn;
    state.slide_slip = slips.slide;
}

bool is_damped_by(const JointCoordinate& laws) {
    return laws.damping > 0.0 || laws.friction.force > 0.0 || laws.limits.damping > 0.0;
}

bool is_driven_by(const JointCoordinate& laws) {
    return laws.motion || !laws.drive.is_zero() || !laws.rest.is_constant();
}

Vec6 increment_at(const std::vector<Vec6>& increments, int node) {
    return node < 0 ? Vec6::Zero() : increments[node];
}

}  // namespace

JointAssembly::JointAssembly(const Model& model) : model_(&model) {
    std::vector<int> counts(model.joints.empty() ? 0 : model.nodes.size(), 0);
    first_rows_.push_back(0);
    for (const Joint& joint : model.joints) {
        const JointRows& rows = joints_.emplace_back(joint);
        are_linear_ = are_linear_ && rows.is_linear();
        const JointForces& forces = forces_.emplace_back(joint);
        have_forces_ = have_forces_ || !forces.is_empty();
        for (const JointCoordinate* laws : {&joint.turn, &joint.slide}) {
            are_driven_ = are_driven_ || is_driven_by(*laws);
            is_damped_ = is_damped_ || is_damped_by(*laws);
        }
        first_rows_.push_back(first_rows_.back() + rows.count());
        // Behind the node that carries fewer, so that no block grows large.
        int owner = joint.b.anchor.node;
        const int other = joint.a.anchor.node;
        if (owner < 0 || (other >= 0 && counts[other] < counts[owner])) owner = other;
        counts[owner] += rows.count();
        attached_.push_back({owner, rows.count()});
    }
}

std::vector<NodeGroup> JointAssembly::node_groups() const {
    std::vector<NodeGroup> groups;
    groups.reserve(joints_.size());
    for (const Joint& joint : model_->joints) groups.push_back(list_nodes(joint));
    return groups;
}

void JointAssembly::lay_out(const EquationNumbers& equations, const SparsePattern& pattern, double length) {
    equations_ = &equations;
    pattern_ = &pattern;
    length_ = length;
    places_.reserve(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) places_.push_back(find_places(i, equations, pattern));
}

JointAssembly::Places JointAssembly::find_places(std::size_t index,
                                                 const EquationNumbers& equations,
                                                 const SparsePattern& pattern) const {
    const Joint& joint = model_->joints[index];
    const int count = joints_[index].count();
    Places places;
    places.first = equations.of_attached(index);
    places.first_diagonal = pattern.slot(places.first, places.first);
    places.stride = pattern.block_of(places.first).stride + 1;
    const std::vector<int> nodes = list_nodes(joint);
    const bool is_free =
        std::all_of(nodes.begin(), nodes.end(), [&](int node) { return equations.is_free(node); });
    std::array<std::int64_t, most_unknowns> numbers;
    numbers.fill(-1);
    for (int side = 0; side < 2; ++side) {
        const int node = nodes_of(joint)[side];
        if (node < 0) continue;
        const auto own = equations.of_node(node);
        std::copy(own.begin(), own.end(), numbers.begin() + 6 * side);
    }
    for (int row = 0; row < count; ++row) numbers[12 + row] = places.first + row;
    if (!is_free) {
        const int size = 12 + count;
        for (int column = 0; column < size; ++column) {
            for (int row = 0; row < size; ++row) {
                const bool is_there = numbers[row] >= 0 && numbers[column] >= 0;
                places.slots.push_back(is_there ? pattern.slot(numbers[row], numbers[column]) : -1);
            }
        }
        return places;
    }
    for (int pair = 0; pair < 9; ++pair) {
        const std::int64_t row = numbers[6 * (pair % 3)];
        const std::int64_t column = numbers[6 * (pair / 3)];
        places.blocks[pair] = row < 0 || column < 0
                                  ? Block{-1, 0}
                                  : Block{pattern.slot(row, column), pattern.block_of(column).stride};
    }
    return places;
}

JointInputs JointAssembly::inputs_at(const Joint& joint, double time) {
    return {{joint.turn.rest(time), joint.turn.drive(time)},
            {joint.slide.rest(time), joint.slide.drive(time)}};
}

const NodeMotion& JointAssembly::motion(const std::vector<NodeMotion>& nodes, int node) const {
    return node < 0 ? ground : nodes[node];
}

JointMotions JointAssembly::motions(const std::vector<NodeMotion>& nodes, std::size_t index) const {
    const Joint& joint = model_->joints[index];
    return {motion(nodes, joint.a.anchor.node), motion(nodes, joint.b.anchor.node)};
}

JointVector JointAssembly::multipliers(const State& state, std::size_t index) const {
    return Eigen::Map<const Eigen::VectorXd>(state.joints_trial[index].multipliers.data(),
                                             joints_[index].count());
}

void JointAssembly::compute_rows(const State& state,
                                 double time,
                                 const ConstraintRequest& request,
                                 std::vector<double>& rows) const {
    rows.resize(static_cast<std::size_t>(first_rows_.back()));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointMotors motors = compute_motors(model_->joints[i], time, request.step, request.level);
        const JointVector values = joints_[i].compute_values(
            motions(state.trial, i), state.joints_previous[i].turn, motors, request.level);
        for (int row = 0; row < joints_[i].count(); ++row)
            rows[static_cast<std::size_t>(first_rows_[i] + row)] = request.factor * values[row];
    }
}

Eigen::Matrix<double, 12, 1> JointAssembly::compute_force(const State& state,
                                                          double time,
                                                          std::size_t index) const {
    const JointMotions at = motions(state.trial, index);
    Eigen::Matrix<double, 12, 1> force =
        joints_[index].compute_gradient(at).transpose() * multipliers(state, index);
    if (!forces_[index].is_empty()) {
        const JointState& before = state.joints_previous[index];
        force += forces_[index]
                     .compute_force(at, before.turn, inputs_at(model_->joints[index], time), slips_of(before))
                     .transpose();
    }
    return force;
}

void JointAssembly::add_forces(const State& state,
                               double time,
                               const ScaleGroups& groups,
                               Residual& residual) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Eigen::Matrix<double, 12, 1> force = compute_force(state, time, i);
        const std::array<int, 2> nodes = nodes_of(model_->joints[i]);
        for (int side = 0; side < 2; ++side) {
            if (nodes[side] < 0) continue;
            const Vec6 on_node = force.segment<6>(6 * side);
            residual.raise_group(groups.of_node(nodes[side]), on_node);
            residual.nodal[nodes[side]] -= on_node;
        }
    }
}

void JointAssembly::subtract_ground_forces(const State& state, double time, std::vector<Vec6>& nodal) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const std::array<int, 2> nodes = nodes_of(model_->joints[i]);
        if (nodes[0] >= 0 && nodes[1] >= 0) continue;
        const int side = nodes[0] < 0 ? 1 : 0;
        nodal[nodes[side]] -= compute_force(state, time, i).segment<6>(6 * side);
    }
}

// The mean of the diagonal's entries at the joint's nodes, of displacements and of rotations, at least a part
// of the largest.
std::vector<JointAssembly::Scales> JointAssembly::compute_scales(const std::vector<double>& values) const {
    std::vector<Scales> scales;
    scales.reserve(joints_.size());
    Scales largest{0.0, 0.0};
    for (const Joint& joint : model_->joints) {
        double sums[2] = {0.0, 0.0};
        int counts[2] = {0, 0};
        for (const int node : list_nodes(joint)) {
            const auto numbers = equations_->of_node(node);
            for (int k = 0; k < 6; ++k) {
                if (numbers[k] < 0) continue;
                sums[k / 3] += std::abs(values[pattern_->slot(numbers[k], numbers[k])]);
                ++counts[k / 3];
            }
        }
        const Scales mean{sums[0] / std::max(counts[0], 1), sums[1] / std::max(counts[1], 1)};
        largest = {std::max(largest.length, mean.length), std::max(largest.turn, mean.turn)};
        scales.push_back(mean);
    }
    const double square = length_ * length_;
    if (largest.length == 0.0) largest.length = largest.turn / square;
    if (largest.turn == 0.0) largest.turn = largest.length * square;
    if (largest.length == 0.0) largest = {1.0, square};
    for (Scales& scale : scales) {
        scale.length = std::max(scale.length, least_scale * largest.length);
        scale.turn = std::max(scale.turn, least_scale * largest.turn);
    }
    return scales;
}

void JointAssembly::add_tangents(const State& state,
                                 double time,
                                 const std::vector<NodeLinearization>& linearizations,
                                 const ConstraintRequest& request,
                                 std::vector<double>& values) const {
    if (joints_.empty()) return;
    const bool has_equations =
        request.level != ConstraintLevel::position || linearizations.front().placement != 0.0;
    if (!has_equations && !have_forces_) return;
    std::vector<Scales> scales;
    if (has_equations && request.scaled_as == nullptr) scales = compute_scales(values);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        Matrix matrix = Matrix::Zero();
        if (has_equations) {
            JointVector D(joints_[i].count());
            for (int row = 0; row < joints_[i].count(); ++row) {
                D[row] = request.scaled_as
                             ? scale_of_row(i, row, *request.scaled_as)
                             : (is_length(static_cast<int>(i), row) ? scales[i].length : scales[i].turn);
            }
            if (request.level == ConstraintLevel::acceleration) D *= acceleration_scale;
            add_equations(i, state, linearizations, request, D, matrix);
        }
        if (!forces_[i].is_empty()) {
            const JointState& before = state.joints_previous[i];
            matrix.topLeftCorner<12, 12>() -=
                forces_[i].compute_tangent(motions(state.trial, i),
                                           linearizations_of(model_->joints[i], linearizations),
                                           before.turn,
                                           inputs_at(model_->joints[i], time),
                                           slips_of(before));
        }
        add_matrix(i, matrix, values);
    }
}

void JointAssembly::add_equations(std::size_t index,
                                  const State& state,
                                  const std::vector<NodeLinearization>& linearizations,
                                  const ConstraintRequest& request,
                                  const JointVector& D,
                                  Matrix& matrix) const {
    const JointRows& rows = joints_[index];
    const int count = rows.count();
    const JointMotions at = motions(state.trial, index);
    const double placement = linearizations.front().placement;
    const JointMatrix G = rows.compute_gradient(at);
    const JointMatrix DG = D.asDiagonal() * G;
    matrix.topLeftCorner<12, 12>() += G.transpose().lazyProduct(DG);
    if (placement != 0.0) {
        matrix.topLeftCorner<12, 12>() -=
            placement * rows.compute_force_derivative(at, multipliers(state, index));
    }
    matrix.block(0, 12, 12, count) = -DG.transpose();
    if (request.level == ConstraintLevel::position) {
        matrix.block(12, 0, count, 12) = -DG;
    } else {
        const JointMatrix H = rows.compute_acceleration_derivative(
            at, linearizations_of(model_->joints[index], linearizations));
        matrix.block(12, 0, count, 12) = -request.factor * (D.asDiagonal() * H);
    }
    for (int row = 0; row < count; ++row) matrix(12 + row, 12 + row) = -regularization * D[row];
}

void JointAssembly::add_matrix(std::size_t index, Matrix& matrix, std::vector<double>& values) const {
    const Places& places = places_[index];
    const int count = joints_[index].count();
    if (!places.slots.empty()) {
        for (int side = 0; side < 2; ++side) {
            const int node = nodes_of(model_->joints[index])[side];
            if (node < 0 || !equations_->supports().has_own_axes(node)) continue;
            const Mat3& Q = equations_->supports().axes(node);
            for (int first = 6 * side; first < 6 * side + 6; first += 3) {
                matrix.middleRows<3>(first) = (Q.transpose() * matrix.middleRows<3>(first)).eval();
                matrix.middleCols<3>(first) = (matrix.middleCols<3>(first) * Q).eval();
            }
        }
        const int size = 12 + count;
        auto slot = places.slots.begin();
        for (int column = 0; column < size; ++column) {
            for (int row = 0; row < size; ++row, ++slot) {
                if (*slot >= 0) values[*slot] += matrix(row, column);
            }
        }
        return;
    }
    for (int pair = 0; pair < 9; ++pair) {
        const auto [first, stride] = places.blocks[pair];
        if (first < 0) continue;
        const int rows = pair % 3 == 2 ? count : 6;
        const int columns = pair / 3 == 2 ? count : 6;
        for (int column = 0; column < columns; ++column) {
            double* target = &values[first + column * stride];
            for (int row = 0; row < rows; ++row)
                target[row] += matrix(6 * (pair % 3) + row, 6 * (pair / 3) + column);
        }
    }
}

double JointAssembly::scale_of_row(std::size_t index, int row, const std::vector<double>& values) const {
    const Places& places = places_[index];
    return -values[places.first_diagonal + row * places.stride] / regularization;
}

void JointAssembly::set_rows(const std::vector<double>& rows,
                             const std::vector<double>& values,
                             Eigen::VectorXd& vector) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        for (int row = 0; row < joints_[i].count(); ++row) {
            vector[places_[i].first + row] =
                -scale_of_row(i, row, values) * rows[static_cast<std::size_t>(first_rows_[i] + row)];
        }
    }
}

void JointAssembly::advance_multipliers(const std::vector<Vec6>& increments,
                                        const Eigen::VectorXd& solution,
                                        const std::vector<double>& values,
                                        State& state) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = model_->joints[i];
        Eigen::Matrix<double, 12, 1> delta;
        delta << increment_at(increments, joint.a.anchor.node), increment_at(increments, joint.b.anchor.node);
        const JointVector change = joints_[i].compute_gradient(motions(state.trial, i)) * delta;
        for (int row = 0; row < joints_[i].count(); ++row) {
            state.joints_trial[i].multipliers[row] +=
                scale_of_row(i, row, values) * (solution[places_[i].first + row] - change[row]);
        }
    }
}

LargestGap JointAssembly::measure_gap(const std::vector<double>& rows, const State& state) const {
    LargestGap gap;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointMotions at = motions(state.trial, i);
        const double length = std::max({length_, at.a.r.norm(), at.b.r.norm()});
        for (int row = 0; row < joints_[i].count(); ++row) {
            const double value = std::abs(rows[static_cast<std::size_t>(first_rows_[i] + row)]) /
                                 (joints_[i].is_length(row) ? length : 1.0);
            if (!(value <= gap.size)) gap = {value, static_cast<int>(i)};
        }
    }
    return gap;
}

void JointAssembly::start(State& state) const {
    state.joints_previous.resize(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i)
        set_slips(forces_[i].compute_first_slips(motions(state.trial, i), 0.0), state.joints_previous[i]);
    state.joints_trial = state.joints_previous;
}

void JointAssembly::commit(State& state) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointState& before = state.joints_previous[i];
        JointState& after = state.joints_trial[i];
        after.turn = place_of(state.trial, i, state).turn.value;
        if (!forces_[i].is_empty())
            set_slips(forces_[i].compute_slips(motions(state.trial, i), before.turn, slips_of(before)),
                      after);
    }
    state.joints_previous = state.joints_trial;
}

}  // namespace gxrod
