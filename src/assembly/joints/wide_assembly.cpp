#include "assembly/joints/wide_assembly.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/scatter.hpp"
#include "assembly/tendons/capstan_rows.hpp"
#include "assembly/tendons/tendon_rows.hpp"
#include "constraints/joints/list_wide_rows.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

// Those that are in all groups.
std::vector<int> find_common_nodes(const std::vector<NodeGroup>& groups) {
    std::vector<int> common;
    for (const int node : groups.front()) {
        const auto has_it = [&](const NodeGroup& group) {
            return std::ranges::find(group, node) != group.end();
        };
        if (std::ranges::all_of(groups, has_it)) common.push_back(node);
    }
    return common;
}

Eigen::Index columns_of(const std::vector<int>& nodes) { return 6 * static_cast<Eigen::Index>(nodes.size()); }

// Calls visit(node, part) with each node and its six entries of a vector.
template <class Visit>
void visit_parts(const std::vector<int>& nodes, const Eigen::VectorXd& vector, Visit&& visit) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
        visit(static_cast<std::size_t>(nodes[i]), Vec6(vector.segment<6>(6 * static_cast<Eigen::Index>(i))));
}

}  // namespace

WideAssembly::WideAssembly(const Model& model)
    : rows_(list_wide_rows(model)), first_(number_of(model, TieKind::gear, 0)) {
    for (auto& tendon : list_capstan_rows(model)) rows_.push_back(std::move(tendon));
    for (auto& tendon : list_tendon_rows(model)) rows_.push_back(std::move(tendon));
}

bool WideAssembly::have_laws() const {
    return std::ranges::any_of(rows_, [](const auto& rows) { return rows->has_laws(); });
}

bool WideAssembly::are_driven() const {
    return std::ranges::any_of(rows_, [](const auto& rows) { return rows->is_driven(); });
}

bool WideAssembly::have_friction_by_multipliers() const {
    return std::ranges::any_of(rows_, [](const auto& rows) { return rows->held_rows() > 0; });
}

bool WideAssembly::are_damped() const {
    return std::ranges::any_of(rows_, [](const auto& rows) { return rows->is_damped(); });
}

void WideAssembly::attach(std::vector<int>& carried, std::vector<AttachedUnknowns>& attached) const {
    for (const auto& rows : rows_) {
        const std::vector<int> nodes = find_common_nodes(rows->list_groups());
        const int owner = *std::ranges::min_element(
            nodes, {}, [&](int node) { return carried[static_cast<std::size_t>(node)]; });
        carried[static_cast<std::size_t>(owner)] += rows->count();
        attached.push_back({owner, rows->count()});
    }
}

void WideAssembly::add_groups(std::vector<NodeGroup>& groups) const {
    for (const auto& rows : rows_) {
        for (NodeGroup& group : rows->list_groups()) groups.push_back(std::move(group));
    }
}

void WideAssembly::lay_out(const Layout& layout, std::int64_t first_row, std::size_t first_memory) {
    equations_ = &layout.equations;
    pattern_ = &layout.pattern;
    length_ = layout.length;
    first_memory_ = first_memory;
    for (const auto& rows : rows_) {
        first_rows_.push_back(first_row);
        first_row += rows->count();
    }
}

std::size_t WideAssembly::row_count() const {
    std::size_t count = 0;
    for (const auto& rows : rows_) count += static_cast<std::size_t>(rows->count());
    return count;
}

Eigen::VectorXd WideAssembly::kept_multipliers(const State& state, std::size_t index) const {
    return Eigen::Map<const Eigen::VectorXd>(state.joints_trial[first_ + index].multipliers.data(),
                                             rows_[index]->count());
}

Eigen::VectorXd WideAssembly::multipliers(std::size_t index,
                                          const WidePlace& at,
                                          ConstraintLevel level) const {
    Eigen::VectorXd kept = kept_multipliers(at.state, index);
    if (!rows_[index]->hold(at, kept, level)) kept.setZero();
    return kept;
}

bool WideAssembly::hold(std::size_t index, const WidePlace& at, ConstraintLevel level) const {
    return rows_[index]->hold(at, kept_multipliers(at.state, index), level);
}

void WideAssembly::compute_rows(const State& state,
                                double time,
                                const ConstraintRequest& request,
                                std::vector<double>& rows) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const WidePlace at = place(i, state, time);
        Eigen::VectorXd values = rows_[i]->compute_values(at, request.level, request.step);
        if (!hold(i, at, request.level)) values.setZero();
        for (int row = 0; row < rows_[i]->count(); ++row)
            rows[static_cast<std::size_t>(first_rows_[i] + row)] = request.factor * values[row];
    }
}

Eigen::VectorXd WideAssembly::compute_force(const State& state,
                                            double time,
                                            std::size_t index,
                                            ConstraintLevel level) const {
    const WideRows& rows = *rows_[index];
    const WidePlace at = place(index, state, time);
    Eigen::VectorXd force = rows.compute_force(at, multipliers(index, at, level));
    if (rows.has_laws()) force += rows.compute_law_force(at);
    return force;
}

void WideAssembly::add_forces(const State& state,
                              double time,
                              ConstraintLevel level,
                              const ScaleGroups& groups,
                              Residual& residual) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        visit_parts(rows_[i]->list_nodes(place(i, state, time)),
                    compute_force(state, time, i, level),
                    [&](std::size_t node, const Vec6& on_node) {
                        residual.raise_group(groups.of_node(static_cast<int>(node)), on_node);
                        residual.nodal[node] -= on_node;
                    });
    }
}

void WideAssembly::subtract_ground_forces(const State& state, double time, std::vector<Vec6>& nodal) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const WidePlace at = place(i, state, time);
        const Eigen::VectorXd force = rows_[i]->compute_ground_force(at, multipliers(i, at));
        if (force.size() == 0) continue;
        visit_parts(rows_[i]->list_nodes(at), force, [&](std::size_t node, const Vec6& on_node) {
            nodal[node] -= on_node;
        });
    }
}

void WideAssembly::add_means(const State& state,
                             double time,
                             const std::vector<double>& values,
                             std::vector<JointScales>& means) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        DiagonalMean mean;
        for (const int node : rows_[i]->list_nodes(place(i, state, time))) {
            const std::array<std::int64_t, 6> numbers = equations_->of_node(node);
            for (int k = 0; k < 6; ++k) {
                const std::int64_t number = numbers[static_cast<std::size_t>(k)];
                if (number >= 0) mean.add(k, values[pattern_->slot(number, number)]);
            }
        }
        means.push_back(mean.mean());
    }
}

double WideAssembly::scale_of_row(std::size_t index, int row, const std::vector<double>& values) const {
    const std::int64_t number = equations_->of_attached(first_ + index) + row;
    return -values[pattern_->slot(number, number)] / joint_scaling::regularization;
}

Eigen::VectorXd WideAssembly::compute_regularization(std::size_t index,
                                                     const ConstraintRequest& request,
                                                     const std::vector<JointScales>& scales) const {
    const WideRows& rows = *rows_[index];
    Eigen::VectorXd D(rows.count());
    for (int row = 0; row < rows.count(); ++row) {
        D[row] = request.scaled_as ? scale_of_row(index, row, *request.scaled_as)
                                   : scales[first_ + index].of(rows.is_length(row));
    }
    if (request.level == ConstraintLevel::acceleration) D *= joint_scaling::acceleration_scale;
    return D;
}

// Of the nodes' unknowns, then of its own: as JointAssembly::add_equations.
Eigen::MatrixXd WideAssembly::compute_equations(const WidePlace& at,
                                                std::size_t index,
                                                const std::vector<NodeLinearization>& linearizations,
                                                const ConstraintRequest& request,
                                                const Eigen::VectorXd& D) const {
    const WideRows& rows = *rows_[index];
    const bool is_of_positions = request.level == ConstraintLevel::position;
    const double placement = linearizations.front().placement;
    const Eigen::MatrixXd G = rows.compute_gradient(at);
    const Eigen::MatrixXd scaled = D.asDiagonal() * G;
    const Eigen::Index columns = G.cols();
    const Eigen::Index size = columns + D.size();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    matrix.bottomRightCorner(D.size(), D.size()).diagonal() = -joint_scaling::regularization * D;
    if (!hold(index, at, request.level)) return matrix;
    matrix.topLeftCorner(columns, columns) = G.transpose() * scaled;
    if (placement != 0.0) {
        matrix.topLeftCorner(columns, columns) -=
            placement * rows.compute_force_derivative(at, kept_multipliers(at.state, index));
    }
    matrix.topRightCorner(columns, D.size()) = -scaled.transpose();
    matrix.bottomLeftCorner(D.size(), columns) = -scaled;
    if (!is_of_positions) {
        const Eigen::MatrixXd H = rows.compute_acceleration_derivative(at, linearizations);
        matrix.bottomLeftCorner(D.size(), columns) = -request.factor * (D.asDiagonal() * H);
    }
    return matrix;
}

// That of rows which do not hold is zero but for its diagonal.
bool WideAssembly::have_equation(std::size_t index,
                                 int row,
                                 const std::vector<int>& nodes,
                                 const std::vector<double>& values) const {
    const std::int64_t number = equations_->of_attached(first_ + index) + row;
    return std::ranges::any_of(nodes, [&](int node) {
        return std::ranges::any_of(equations_->of_node(node), [&](std::int64_t column) {
            return column >= 0 && values[pattern_->slot(number, column)] != 0.0;
        });
    });
}

void WideAssembly::add_tangents(const State& state,
                                double time,
                                const std::vector<NodeLinearization>& linearizations,
                                const ConstraintRequest& request,
                                const std::vector<JointScales>* scales,
                                std::vector<double>& values) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const WideRows& rows = *rows_[i];
        if (scales == nullptr && !rows.has_laws()) continue;
        const WidePlace at = place(i, state, time);
        const std::vector<int> nodes = rows.list_nodes(at);
        const Eigen::Index columns = columns_of(nodes);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(columns + rows.count(), columns + rows.count());
        if (scales != nullptr) {
            const Eigen::VectorXd D = compute_regularization(i, request, *scales);
            matrix = compute_equations(at, i, linearizations, request, D);
            if (at.held > 0.0) add_held_tangent(i, at, D, matrix);
        }
        if (rows.has_laws())
            matrix.topLeftCorner(columns, columns) -= rows.compute_law_tangent(at, linearizations);
        add_matrix(i, nodes, matrix, values);
    }
}

void WideAssembly::add_held_tangent(std::size_t index,
                                    const WidePlace& at,
                                    const Eigen::VectorXd& D,
                                    Eigen::MatrixXd& matrix) const {
    const Eigen::MatrixXd G = rows_[index]->compute_gradient(at);
    const Eigen::VectorXd by_held = rows_[index]->compute_held_derivative(at);
    const Eigen::VectorXd by_multipliers = kept_multipliers(at.state, index) / at.held;
    const Eigen::Index columns = G.cols();
    for (int row = 0; row < rows_[index]->held_rows(); ++row) {
        const Eigen::VectorXd column = D[row] * by_multipliers[row] * by_held;
        matrix.col(columns + row).head(columns) -= column;
        matrix.topLeftCorner(columns, columns) += column * G.row(row);
    }
}

void WideAssembly::add_matrix(std::size_t index,
                              const std::vector<int>& nodes,
                              Eigen::MatrixXd& matrix,
                              std::vector<double>& values) const {
    turn_to_own_axes(nodes, *equations_, matrix);
    std::vector<std::int64_t> numbers;
    for (const int node : nodes) {
        const std::array<std::int64_t, 6> own = equations_->of_node(node);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    for (int row = 0; row < rows_[index]->count(); ++row)
        numbers.push_back(equations_->of_attached(first_ + index) + row);
    for (std::size_t column = 0; column < numbers.size(); ++column) {
        for (std::size_t row = 0; row < numbers.size(); ++row) {
            if (numbers[row] < 0 || numbers[column] < 0) continue;
            values[pattern_->slot(numbers[row], numbers[column])] +=
                matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        }
    }
}

void WideAssembly::set_rows(const std::vector<double>& rows,
                            const std::vector<double>& values,
                            Eigen::VectorXd& vector) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        for (int row = 0; row < rows_[i]->count(); ++row) {
            vector[equations_->of_attached(first_ + i) + row] =
                -scale_of_row(i, row, values) * rows[static_cast<std::size_t>(first_rows_[i] + row)];
        }
    }
}

void WideAssembly::advance_multipliers(const std::vector<Vec6>& increments,
                                       const Eigen::VectorXd& solution,
                                       const std::vector<double>& values,
                                       State& state) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const WidePlace at = place(i, state, state.time);
        const std::vector<int> nodes = rows_[i]->list_nodes(at);
        Eigen::VectorXd delta(columns_of(nodes));
        for (std::size_t k = 0; k < nodes.size(); ++k)
            delta.segment<6>(6 * static_cast<Eigen::Index>(k)) =
                increments[static_cast<std::size_t>(nodes[k])];
        const Eigen::VectorXd G_delta = rows_[i]->compute_gradient(at) * delta;
        const std::int64_t first = equations_->of_attached(first_ + i);
        for (int row = 0; row < rows_[i]->count(); ++row) {
            double& kept = state.joints_trial[first_ + i].multipliers[static_cast<std::size_t>(row)];
            if (have_equation(i, row, nodes, values)) {
                kept += scale_of_row(i, row, values) * (solution[first + row] - G_delta[row]);
            } else {
                kept = 0.0;
            }
        }
    }
}

void WideAssembly::add_driving_forces(const State& state, double time, std::vector<Vec6>& forces) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        forces.push_back(
            rows_[i]->compute_driving_forces(place(i, state, time), multipliers(i, place(i, state, time))));
}

void WideAssembly::add_coordinates(const std::vector<NodeMotion>& nodes,
                                   double time,
                                   const State& state,
                                   std::vector<Vec6>& coordinates) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        coordinates.push_back(rows_[i]->compute_coordinates(place(i, nodes, time, state)));
}

void WideAssembly::add_joint_values(const State& state, double time, std::vector<JointValues>& all) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const WidePlace at = place(i, state, time);
        JointValues values = rows_[i]->compute_joint_values(at, multipliers(i, at));
        Eigen::VectorXd open = rows_[i]->compute_values(at, ConstraintLevel::position, {});
        if (!hold(i, at, ConstraintLevel::position)) open.setZero();
        for (int row = 0; row < rows_[i]->count(); ++row) {
            const double size = std::abs(open[row]) * (rows_[i]->is_length(row) ? 1.0 : length_);
            values.gap = std::max(values.gap, size);
        }
        all.push_back(values);
    }
}

template <class Compute>
double WideAssembly::sum_over(const State& state, double time, Compute&& compute) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < rows_.size(); ++i) sum += compute(*rows_[i], place(i, state, time), i);
    return sum;
}

double WideAssembly::compute_driving_power(const State& state, double time, const TimeSpan& step) const {
    return sum_over(state, time, [&](const WideRows& rows, const WidePlace& at, std::size_t i) {
        return rows.compute_driving_power(at, multipliers(i, at), step);
    });
}

double WideAssembly::compute_strain_energy(const State& state, double time) const {
    return sum_over(state, time, [](const WideRows& rows, const WidePlace& at, std::size_t) {
        return rows.compute_strain_energy(at);
    });
}

double WideAssembly::compute_damping_power(const State& state) const {
    return sum_over(state, state.time, [](const WideRows& rows, const WidePlace& at, std::size_t) {
        return rows.compute_damping_power(at);
    });
}

double WideAssembly::compute_damping_action(const State& state) const {
    return sum_over(state, state.time, [](const WideRows& rows, const WidePlace& at, std::size_t) {
        return rows.compute_damping_action(at);
    });
}

double WideAssembly::compute_slip_dissipation(const State& state) const {
    return sum_over(state, state.time, [](const WideRows& rows, const WidePlace& at, std::size_t) {
        return rows.compute_slip_dissipation(at);
    });
}

WideAssembly::Gap WideAssembly::measure_gap(const std::vector<double>& rows, const State& state) const {
    Gap gap{0.0, 0};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        double length = length_;
        for (const int node : rows_[i]->list_nodes(place(i, state, state.time)))
            length = std::max(length, state.trial[static_cast<std::size_t>(node)].r.norm());
        for (int row = 0; row < rows_[i]->count(); ++row) {
            const double value = std::abs(rows[static_cast<std::size_t>(first_rows_[i] + row)]) /
                                 (rows_[i]->is_length(row) ? length : 1.0);
            if (!(value <= gap.size)) gap = {value, i};
        }
    }
    return gap;
}

void WideAssembly::check_ranges(const State& state, double time) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->check_range(place(i, state, time));
}

void WideAssembly::start(State& state) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        memory_of(i).of(state)[1] = rows_[i]->find_first_slip(place(i, state, state.time));
}

void WideAssembly::commit(State& state) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
        memory_of(i).of(state)[1] =
            rows_[i]->commit(place(i, state, state.time), state.joints_trial[first_ + i]);
}

}  // namespace gxrod
