#include "assembly/joints/joint_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "assembly/scatter.hpp"
#include "constraints/joints/joint_motors.hpp"

namespace gxrod {

namespace {

using joint_scaling::acceleration_scale;
using joint_scaling::regularization;

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

JointScales larger_of(const JointScales& a, const JointScales& b) {
    return {std::max(a.length, b.length), std::max(a.turn, b.turn)};
}

Vec6 increment_at(const std::vector<Vec6>& increments, int node) {
    return node < 0 ? Vec6::Zero() : increments[node];
}

}  // namespace

JointAssembly::JointAssembly(const Model& model) : model_(&model), wide_(model) {
    are_linear_ = wide_.empty();
    are_driven_ = wide_.are_driven();
    have_forces_ = wide_.have_laws();
    is_damped_ = wide_.are_damped();
    std::vector<int> counts(model.joints.empty() && wide_.empty() ? 0 : model.nodes.size(), 0);
    first_rows_.push_back(0);
    for (const Joint& joint : model.joints) {
        const JointRows& rows = joints_.emplace_back(joint);
        are_linear_ = are_linear_ && rows.is_linear();
        have_stops_ = have_stops_ || rows.has_stops();
        const JointForces& forces = forces_.emplace_back(joint);
        have_forces_ = have_forces_ || !forces.is_empty();
        for (const JointCoordinate* laws : {&joint.turn, &joint.slide}) {
            are_driven_ = are_driven_ || is_driven_by(*laws);
            is_damped_ = is_damped_ || is_damped_by(*laws);
        }
        is_damped_ = is_damped_ || (joint.clearance && joint.clearance->dissipates());
        first_rows_.push_back(first_rows_.back() + rows.count());
        // Behind the node that carries fewer, so that no block grows large.
        int owner = joint.b.anchor.node;
        const int other = joint.a.anchor.node;
        if (owner < 0 || (other >= 0 && counts[other] < counts[owner])) owner = other;
        counts[owner] += rows.count();
        attached_.push_back({owner, rows.count()});
    }
    wide_.attach(counts, attached_);
}

std::string JointAssembly::name(int index) const {
    const auto joint = static_cast<std::size_t>(index);
    return joint < joints_.size() ? "joint " + model_->joints[joint].name
                                  : wide_.rows(joint - joints_.size()).name();
}

int JointAssembly::shown_node(int index) const {
    const auto joint = static_cast<std::size_t>(index);
    return joint < joints_.size() ? model_->joints[joint].moving_anchor().node : attached_[joint].node;
}

std::vector<NodeGroup> JointAssembly::node_groups() const {
    std::vector<NodeGroup> groups;
    groups.reserve(joints_.size());
    for (const Joint& joint : model_->joints) groups.push_back(list_nodes(joint));
    wide_.add_groups(groups);
    return groups;
}

bool JointAssembly::have_friction_by_multipliers() const {
    return wide_.have_friction_by_multipliers() ||
           std::ranges::any_of(forces_, [](const JointForces& forces) { return forces.follows_held(); });
}

void JointAssembly::lay_out(const Layout& layout) {
    equations_ = &layout.equations;
    groups_ = &layout.groups;
    pattern_ = &layout.pattern;
    length_ = layout.length;
    memory_ = {layout.first_memory, memory_count()};
    places_.reserve(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i)
        places_.push_back(find_places(i, layout.equations, layout.pattern));
    wide_.lay_out(layout, first_rows_.back(), memory_of(joints_.size()).first);
}

JointAssembly::Places JointAssembly::find_places(std::size_t index,
                                                 const EquationNumbers& equations,
                                                 const SparsePattern& pattern) const {
    const Joint& joint = model_->joints[index];
    const int count = joints_[index].count();
    Places places;
    places.first = equations.of_attached(index);
    if (count > 0) {
        places.first_diagonal = pattern.slot(places.first, places.first);
        places.stride = pattern.block_of(places.first).stride + 1;
    }
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
    for (int k = 0; k < 12; ++k)
        places.diagonals[k] = numbers[k] < 0 ? -1 : pattern.slot(numbers[k], numbers[k]);
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

JointInputs JointAssembly::inputs_at(std::size_t index, const State& state, double time) const {
    const Joint& joint = model_->joints[index];
    const double held = forces_[index].follows_held() ? find_held_force(state, index).size : 0.0;
    return {{joint.turn.rest(time), joint.turn.drive(time), held},
            {joint.slide.rest(time), joint.slide.drive(time), held}};
}

// Of the rows that are lengths, but that of a motor.
JointAssembly::HeldForce JointAssembly::find_held_force(const State& state, std::size_t index) const {
    const JointRows& rows = joints_[index];
    HeldForce held{0.0, multipliers(state, index)};
    for (int row = 0; row < rows.count(); ++row) {
        if (!rows.is_length(row) || row == rows.slide_motor_row() || rows.is_stop(row))
            held.by_multipliers[row] = 0.0;
    }
    held.size = held.by_multipliers.norm();
    if (held.size > 0.0) held.by_multipliers /= held.size;
    return held;
}

// λ changes by D (μ − G δ), and so does the friction.
void JointAssembly::add_held_tangent(
    std::size_t index, const State& state, double time, const JointVector& D, Matrix& matrix) const {
    const JointState& before = state.joints_previous[index];
    const JointMotions at = motions(state.trial, index);
    const PairVector by_held =
        forces_[index]
            .compute_held_derivative(
                at, before.turn, inputs_at(index, state, time), slips_before(state, index))
            .transpose();
    const JointVector by_multipliers = find_held_force(state, index).by_multipliers;
    const JointMatrix G = joints_[index].compute_gradient(at);
    for (int row = 0; row < joints_[index].count(); ++row) {
        const PairVector column = D[row] * by_multipliers[row] * by_held;
        matrix.block<12, 1>(0, 12 + row) -= column;
        matrix.topLeftCorner<12, 12>() += column * G.row(row);
    }
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
    rows.resize(static_cast<std::size_t>(first_rows_.back()) + wide_.row_count());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointMotors motors = compute_motors(model_->joints[i], time, request.step, request.level);
        const JointVector values = joints_[i].compute_values(
            motions(state.trial, i), state.joints_previous[i].turn, motors, request.level);
        const double factor = holds(state, i) ? request.factor : 0.0;
        const RowHolds row_holds = find_row_holds(state, i, request);
        for (int row = 0; row < joints_[i].count(); ++row) {
            double& result = rows[static_cast<std::size_t>(first_rows_[i] + row)];
            result = factor * values[row];
            if (row_holds[static_cast<std::size_t>(row)]) continue;
            // A multiplier that is to be let go has not been yet: nothing has converged.
            constexpr double not_met = 1e-6;
            const bool is_searched =
                request.level == ConstraintLevel::position && request.stops == StopChoice::by_level;
            const bool is_kept = state.joints_trial[i].multipliers[static_cast<std::size_t>(row)] != 0.0;
            result = is_searched && is_kept ? not_met * measure_of(i, row) : 0.0;
        }
    }
    wide_.compute_rows(state, time, request, rows);
}

// A stop that holds goes on to hold within a step, whatever its multiplier; it is let go at its end.
JointAssembly::RowHolds JointAssembly::find_row_holds(const State& state,
                                                      std::size_t index,
                                                      const ConstraintRequest& request) const {
    constexpr double round_off = 1e-13;    // of the length, or in rad
    constexpr double closed = 1e-9;        // likewise
    constexpr double still_closed = 1e-4;  // where accelerations alone keep it closed
    constexpr double still = 1e-8;         // of the speed of both sides
    RowHolds holds;
    holds.set();
    const JointRows& rows = joints_[index];
    if (!rows.has_stops()) return holds;
    const JointMotions at = motions(state.trial, index);
    for (int row = 0; row < rows.count(); ++row) {
        if (!rows.is_stop(row)) continue;
        const auto place = static_cast<std::size_t>(row);
        const double multiplier = state.joints_trial[index].multipliers[place];
        const StopPlace stop = rows.find_stop(row, at, state.joints_previous[index].turn);
        const double push = stop.sign * multiplier;
        const double gap = stop.gap / measure_of(index, row);
        const bool is_closed = gap <= (multiplier == 0.0 ? closed : still_closed);
        if (request.stops == StopChoice::as_before ||
            (request.level == ConstraintLevel::acceleration && request.stops == StopChoice::by_level))
            holds[place] = state.joints_previous[index].multipliers[place] != 0.0;
        else if (request.level == ConstraintLevel::position)
            holds[place] =
                push > 0.0 ||
                (request.stops == StopChoice::at_end ? gap < 0.0 : push == 0.0 && gap <= round_off);
        else if (request.level == ConstraintLevel::velocity)
            holds[place] = is_closed && (multiplier != 0.0 || stop.approach > 0.0);
        else
            holds[place] =
                is_closed && (multiplier != 0.0 || stop.approach >= -still * measure_speed(at, index, row));
    }
    return holds;
}

double JointAssembly::measure_speed(const JointMotions& at, std::size_t index, int row) const {
    const Joint& joint = model_->joints[index];
    const double turning = at.a.omega.norm() + at.b.omega.norm();
    if (!joints_[index].is_length(row)) return turning;
    return at.a.v.norm() + at.b.v.norm() + at.a.omega.norm() * joint.a.anchor.arm.norm() +
           at.b.omega.norm() * joint.b.anchor.arm.norm();
}

bool JointAssembly::has_just_stopped(const State& state) const {
    for (std::size_t i = 0; i < joints_.size() && have_stops_; ++i) {
        if (!joints_[i].has_stops() || !holds(state, i)) continue;
        const RowHolds row_holds =
            find_row_holds(state, i, {.level = ConstraintLevel::acceleration, .stops = StopChoice::at_end});
        for (int row = 0; row < joints_[i].count(); ++row) {
            const auto place = static_cast<std::size_t>(row);
            if (joints_[i].is_stop(row) && row_holds[place] &&
                state.joints_previous[i].multipliers[place] == 0.0)
                return true;
        }
    }
    return false;
}

JointVector JointAssembly::acting_multipliers(const State& state,
                                              std::size_t index,
                                              const ConstraintRequest& request) const {
    JointVector acting = multipliers(state, index);
    if (!joints_[index].has_stops()) return acting;
    const RowHolds row_holds = find_row_holds(state, index, request);
    for (int row = 0; row < joints_[index].count(); ++row) {
        if (!row_holds[static_cast<std::size_t>(row)]) acting[row] = 0.0;
    }
    return acting;
}

PairVector JointAssembly::compute_force(const State& state,
                                        double time,
                                        std::size_t index,
                                        const JointVector& multipliers) const {
    if (!holds(state, index)) return PairVector::Zero();
    const JointMotions at = motions(state.trial, index);
    const JointRows& rows = joints_[index];
    PairVector force = rows.compute_force(rows.compute_frames(at, ConstraintLevel::position), multipliers);
    if (!forces_[index].is_empty()) {
        const JointState& before = state.joints_previous[index];
        force +=
            forces_[index]
                .compute_force(at, before.turn, inputs_at(index, state, time), slips_before(state, index))
                .transpose();
    }
    return force;
}

void JointAssembly::subtract_forces(const State& state,
                                    double time,
                                    const ConstraintRequest& request,
                                    Residual& residual) const {
    if (empty()) return;
    compute_rows(state, time, request, residual.rows);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const PairVector force = compute_force(state, time, i, acting_multipliers(state, i, request));
        const std::array<int, 2> nodes = nodes_of(model_->joints[i]);
        for (int side = 0; side < 2; ++side) {
            if (nodes[side] < 0) continue;
            const Vec6 on_node = force.segment<6>(6 * side);
            residual.raise_group(groups_->of_node(nodes[side]), on_node);
            residual.nodal[nodes[side]] -= on_node;
        }
    }
    wide_.add_forces(state, time, request.level, *groups_, residual);
}

void JointAssembly::subtract_ground_forces(const State& state, double time, std::vector<Vec6>& nodal) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const std::array<int, 2> nodes = nodes_of(model_->joints[i]);
        if (nodes[0] >= 0 && nodes[1] >= 0) continue;
        const int side = nodes[0] < 0 ? 1 : 0;
        nodal[nodes[side]] -= compute_force(state, time, i).segment<6>(6 * side);
    }
    wide_.subtract_ground_forces(state, time, nodal);
}

// The mean of the diagonal's entries at the joint's nodes, of displacements and of rotations, at least a part
// of the largest. Nodes that joints alone hold have none in statics: they resist by how the joint's own
// forces change, and where nothing else resists at all, every joint takes the stiffest of these.
std::vector<JointScales> JointAssembly::compute_scales(const State& state,
                                                       double time,
                                                       const std::vector<double>& values) const {
    std::vector<JointScales> scales;
    scales.reserve(count());
    for (const Places& places : places_) {
        DiagonalMean mean;
        for (int k = 0; k < 12; ++k) {
            if (places.diagonals[k] >= 0) mean.add(k, values[places.diagonals[k]]);
        }
        scales.push_back(mean.mean());
    }
    wide_.add_means(state, time, values, scales);
    const bool nothing_resists = std::ranges::none_of(
        scales, [](const JointScales& scale) { return scale.length > 0.0 || scale.turn > 0.0; });
    const NodeLinearization displaced{.placement = 1.0};
    JointScales stiffest;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        JointScales& scale = scales[i];
        if ((scale.length > 0.0 && scale.turn > 0.0) || !holds(state, i)) continue;
        const JointMotions motion = motions(state.trial, i);
        PairMatrix own = joints_[i].compute_force_derivative(motion, multipliers(state, i));
        if (!forces_[i].is_empty()) {
            own += forces_[i].compute_tangent(motion,
                                              {displaced, displaced},
                                              state.joints_previous[i].turn,
                                              inputs_at(i, state, time),
                                              slips_before(state, i));
        }
        DiagonalMean mean;
        for (int k = 0; k < 12; ++k) {
            if (places_[i].diagonals[k] >= 0) mean.add(k, own(k, k));
        }
        scale = larger_of(scale, mean.mean());
        stiffest = larger_of(stiffest, scale);
    }
    if (nothing_resists) std::ranges::fill(scales, stiffest);
    bound_scales(length_, scales);
    return scales;
}

void JointAssembly::add_tangents(const State& state,
                                 double time,
                                 const ConstraintRequest& request,
                                 const std::vector<NodeLinearization>& linearizations,
                                 std::vector<double>& values) const {
    if (empty()) return;
    const bool has_equations =
        request.level != ConstraintLevel::position || linearizations.front().placement != 0.0;
    if (!has_equations && !have_forces_) return;
    std::vector<JointScales> scales;
    if (has_equations && request.scaled_as == nullptr) scales = compute_scales(state, time, values);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        Matrix matrix = Matrix::Zero();
        if (has_equations) {
            JointVector D(joints_[i].count());
            for (int row = 0; row < joints_[i].count(); ++row) {
                D[row] = request.scaled_as ? scale_of_row(i, row, *request.scaled_as)
                                           : scales[i].of(joints_[i].is_length(row));
            }
            if (request.level == ConstraintLevel::acceleration) D *= acceleration_scale;
            if (!holds(state, i)) {
                for (int row = 0; row < joints_[i].count(); ++row)
                    matrix(12 + row, 12 + row) = -regularization * D[row];
            } else {
                add_equations(i, state, linearizations, request, D, matrix);
                if (forces_[i].follows_held()) add_held_tangent(i, state, time, D, matrix);
            }
        }
        if (!forces_[i].is_empty() && holds(state, i)) {
            const JointState& before = state.joints_previous[i];
            matrix.topLeftCorner<12, 12>() -=
                forces_[i].compute_tangent(motions(state.trial, i),
                                           linearizations_of(model_->joints[i], linearizations),
                                           before.turn,
                                           inputs_at(i, state, time),
                                           slips_before(state, i));
        }
        add_matrix(i, matrix, values);
    }
    wide_.add_tangents(state, time, linearizations, request, has_equations ? &scales : nullptr, values);
}

void JointAssembly::add_equations(std::size_t index,
                                  const State& state,
                                  const std::vector<NodeLinearization>& linearizations,
                                  const ConstraintRequest& request,
                                  const JointVector& D,
                                  Matrix& matrix) const {
    const JointRows& rows = joints_[index];
    const int count = rows.count();
    const bool is_of_positions = request.level == ConstraintLevel::position;
    const JointFrames frames =
        rows.compute_frames(motions(state.trial, index),
                            is_of_positions ? ConstraintLevel::position : ConstraintLevel::acceleration);
    const double placement = linearizations.front().placement;
    const JointMatrix G = rows.compute_gradient(frames);
    auto of_nodes = matrix.topLeftCorner<12, 12>();
    if (placement != 0.0)
        of_nodes =
            -placement * rows.compute_force_derivative(frames, acting_multipliers(state, index, request));
    const RowHolds row_holds = find_row_holds(state, index, request);
    for (int column = 0; column < 12; ++column) {
        PairVector sum = of_nodes.col(column);
        for (int row = 0; row < count; ++row) {
            if (row_holds[static_cast<std::size_t>(row)])
                sum += D[row] * G(row, column) * G.row(row).transpose();
        }
        of_nodes.col(column) = sum;
    }
    const JointMatrix H = is_of_positions
                              ? G
                              : rows.compute_acceleration_derivative(
                                    frames, linearizations_of(model_->joints[index], linearizations));
    for (int row = 0; row < count; ++row) {
        const double size = D[row];
        matrix(12 + row, 12 + row) = -regularization * size;
        if (!row_holds[static_cast<std::size_t>(row)]) continue;
        matrix.block<12, 1>(0, 12 + row) = -size * G.row(row).transpose();
        matrix.block<1, 12>(12 + row, 0) = -(is_of_positions ? size : size * request.factor) * H.row(row);
    }
}

void JointAssembly::add_matrix(std::size_t index, Matrix& matrix, std::vector<double>& values) const {
    const Places& places = places_[index];
    const int count = joints_[index].count();
    if (!places.slots.empty()) {
        turn_to_own_axes(nodes_of(model_->joints[index]), *equations_, matrix);
        auto slots = std::span(places.slots);
        const std::size_t size = 12 + static_cast<std::size_t>(count);
        for (int column = 0; column < 12 + count; ++column, slots = slots.subspan(size))
            add_to_values(&matrix.coeffRef(0, column), slots.first(size), values);
        return;
    }
    for (int pair = 0; pair < 9; ++pair) {
        const auto [first, stride] = places.blocks[pair];
        if (first < 0) continue;
        const int columns = pair / 3 == 2 ? count : 6;
        for (int column = 0; column < columns; ++column) {
            double* target = &values[first + column * stride];
            const double* source = &matrix(6 * (pair % 3), 6 * (pair / 3) + column);
            if (pair % 3 < 2) {
                Eigen::Map<Vec6>(target) += Eigen::Map<const Vec6>(source);
            } else {
                for (int row = 0; row < count; ++row) target[row] += source[row];
            }
        }
    }
}

double JointAssembly::scale_of_row(std::size_t index, int row, const std::vector<double>& values) const {
    const Places& places = places_[index];
    return -values[places.first_diagonal + row * places.stride] / regularization;
}

bool JointAssembly::has_equation(std::size_t index, int row, const std::vector<double>& values) const {
    const std::int64_t number = places_[index].first + row;
    for (const int node : list_nodes(model_->joints[index])) {
        for (const std::int64_t column : equations_->of_node(node)) {
            if (column >= 0 && values[pattern_->slot(number, column)] != 0.0) return true;
        }
    }
    return false;
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
    wide_.set_rows(rows, values, vector);
}

void JointAssembly::advance_multipliers(const std::vector<Vec6>& increments,
                                        const Eigen::VectorXd& solution,
                                        const std::vector<double>& values,
                                        State& state) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!holds(state, i)) continue;
        const Joint& joint = model_->joints[i];
        PairRow delta;
        delta << increment_at(increments, joint.a.anchor.node).transpose(),
            increment_at(increments, joint.b.anchor.node).transpose();
        const JointMatrix G = joints_[i].compute_gradient(motions(state.trial, i));
        for (int row = 0; row < joints_[i].count(); ++row) {
            double& multiplier = state.joints_trial[i].multipliers[static_cast<std::size_t>(row)];
            if (joints_[i].is_stop(row) && !has_equation(i, row, values)) {
                multiplier = 0.0;
                continue;
            }
            multiplier +=
                scale_of_row(i, row, values) * (solution[places_[i].first + row] - G.row(row).dot(delta));
        }
    }
    wide_.advance_multipliers(increments, solution, values, state);
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
    const WideAssembly::Gap wide = wide_.measure_gap(rows, state);
    if (!(wide.size <= gap.size)) gap = {wide.size, static_cast<int>(joints_.size() + wide.index)};
    return gap;
}

void JointAssembly::start(State& state) const {
    state.joints_previous.resize(count());
    for (std::size_t i = 0; i < joints_.size(); ++i)
        write(forces_[i].compute_first_slips(motions(state.trial, i), 0.0), memory_of(i).of(state));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!model_->joints[i].acts) write(JointHold::rests, 0.0, memory_of(i).of(state));
    }
    state.joints_trial = state.joints_previous;
    wide_.start(state);
}

void JointAssembly::begin_stage(State& state, double time) const {
    constexpr double closed = 1e-6;  // of the model's length, or in rad
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Joint& joint = model_->joints[i];
        const std::span<double> memory = memory_of(i).of(state);
        const JointHold before = read_hold(memory);
        if (before == JointHold::has_broken) write(JointHold::is_broken, memory[3], memory);
        if (before == JointHold::has_broken || before == JointHold::is_broken) continue;
        if (!joint.acts) {
            write(JointHold::rests, 0.0, memory);
            state.joints_trial[i].multipliers.fill(0.0);
        } else if (before == JointHold::rests) {
            const JointMotions at = motions(state.trial, i);
            const double turn = state.joints_previous[i].turn;
            const JointMotors motors = compute_motors(joint, time, {}, ConstraintLevel::position);
            const JointGap gap = joints_[i].compute_gap(at, turn, motors);
            if (gap.length > closed * length_ || gap.angle > closed) {
                throw std::runtime_error(
                    fmt::format("joint {} is to hold from here on, and is open by a distance of {:.3g} and "
                                "an angle of {:.3g}; "
                                "let supports, springs or motors close it before",
                                joint.name,
                                gap.length,
                                gap.angle));
            }
            write(JointHold::holds, 0.0, memory);
            write(forces_[i].compute_first_slips(at, turn), memory);
        }
    }
    state.joints_previous = state.joints_trial;
}

std::vector<JointAssembly::Break> JointAssembly::list_breaks(const State& state) const {
    std::vector<Break> all;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const std::span<const double> memory = memory_of(i).of(state);
        if (read_hold(memory) == JointHold::has_broken) all.push_back({i, memory[3]});
    }
    return all;
}

bool JointAssembly::has_just_broken(const State& state) const {
    return std::ranges::any_of(list_breaks(state), [&](const Break& one) { return one.time == state.time; });
}

bool JointAssembly::breaks(const State& state, double time, std::size_t index) const {
    constexpr double close = 1e-6;  // of a step, which ends at the time of a break but for rounding
    const JointStrength& strength = model_->joints[index].strength;
    if (!strength.is_limited() || !holds(state, index)) return false;
    if (strength.time && time >= *strength.time - close * (time - state.time)) return true;
    const JointRows& rows = joints_[index];
    double forces = 0.0, moments = 0.0;
    for (int row = 0; row < rows.count(); ++row) {
        if (row == rows.slide_motor_row() || row == rows.turn_motor_row()) continue;
        const double multiplier = state.joints_trial[index].multipliers[static_cast<std::size_t>(row)];
        double& size = rows.is_length(row) ? forces : moments;
        size = std::hypot(size, multiplier);
    }
    return (strength.force && forces > *strength.force) || (strength.moment && moments > *strength.moment);
}

// Stops that pull at the end of a step hold no longer.
void JointAssembly::let_go(State& state, std::size_t index) const {
    const RowHolds row_holds =
        find_row_holds(state, index, {.level = ConstraintLevel::acceleration, .stops = StopChoice::at_end});
    const JointMotions at = motions(state.trial, index);
    for (int row = 0; row < joints_[index].count(); ++row) {
        if (!joints_[index].is_stop(row)) continue;
        const auto place = static_cast<std::size_t>(row);
        double& multiplier = state.joints_trial[index].multipliers[place];
        const StopPlace stop = joints_[index].find_stop(row, at, state.joints_previous[index].turn);
        if (!row_holds[place] || stop.sign * multiplier < 0.0) multiplier = 0.0;
    }
}

void JointAssembly::commit(State& state, double time) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const JointState& before = state.joints_previous[i];
        JointState& after = state.joints_trial[i];
        after.turn = place_of(state.trial, i, state).turn.value;
        if (!forces_[i].is_empty())
            write(forces_[i].compute_slips(motions(state.trial, i), before.turn, slips_before(state, i)),
                  memory_of(i).of(state));
        if (joints_[i].has_stops()) let_go(state, i);
        if (!breaks(state, time, i)) continue;
        write(JointHold::has_broken, time, memory_of(i).of(state));
        after.multipliers.fill(0.0);
    }
    wide_.commit(state);
    state.joints_previous = state.joints_trial;
}

}  // namespace gxrod
