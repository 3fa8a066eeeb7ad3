#include "solvers/coupled/exact_matrix.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>

#include "assembly/contact/contacts.hpp"
#include "assembly/scatter.hpp"

namespace gxrod {

namespace {

using Matrix = Eigen::MatrixXd;

void add_scaled(double factor, const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * from[i];
}

}  // namespace

ExactMatrix::ExactMatrix(const System& system, const CoupledStages& scheme, LinearSolverKind kind)
    : system_(&system), kind_(kind), count_(scheme.stage_count()) {
    build();
    const int count = count_;
    to_equations_.resize(count, count);
    from_unknowns_.resize(count, count);
    int next = 0;
    if (scheme.real_factor() > 0.0) {
        to_equations_.row(0) = scheme.to_real().transpose();
        from_unknowns_.col(0) = scheme.from_real();
        next = 1;
    }
    const Eigen::VectorXcd turned = std::polar(1.0, -std::arg(scheme.complex_factor())) * scheme.to_complex();
    to_equations_.row(next) = turned.real().transpose();
    to_equations_.row(next + 1) = turned.imag().transpose();
    from_unknowns_.col(next) = 2.0 * scheme.from_complex().real();
    from_unknowns_.col(next + 1) = -2.0 * scheme.from_complex().imag();
}

void ExactMatrix::build() {
    solver_.reset();
    stacked_.reset();
    paired_.reset();
    if (!groups_.empty()) {
        std::vector<NodeGroup> all = system_->list_node_groups();
        all.insert(all.end(), groups_.begin(), groups_.end());
        paired_ = compute_pattern(system_->equations(), all);
        places_.resize(static_cast<std::size_t>(system_->pattern().nonzeros()));
        system_->pattern().visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
            places_[static_cast<std::size_t>(slot)] = paired_->slot(row, column);
        });
    }
    stacked_.emplace(paired_ ? *paired_ : system_->pattern(), count_);
    solver_ = make_linear_solver(kind_, stacked_->pattern(), system_->team());
}

void ExactMatrix::find_pairs(const StagesOfStep& stages, SolverWorkspace& workspace) {
    const Contacts contacts(stages.system);
    pairs_.assign(stages.count() * stages.count(), {});
    if (!contacts.couple_rods()) return;
    std::vector<NodeGroup> needed;
    const auto count = stages.count();
    const Contact& contact = stages.system.model().contact;
    const bool are_damped = contact.damping > 0.0 || contact.has_restitution();
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t k = 0; k < count; ++k) {
            if (k != j && !are_damped) continue;
            std::vector<PairBlock>& blocks = pairs_[j * count + k];
            stages.scheme.linearize(stages.state,
                                    stages.step.time_step,
                                    static_cast<int>(j),
                                    static_cast<int>(k),
                                    workspace.linearizations,
                                    stages.system.team());
            stages.with_stage(
                j, [&] { blocks = contacts.compute_tangents(stages.state, 1.0, workspace.linearizations); });
            for (PairBlock& block : blocks) {
                turn_to_own_axes(std::span<const int>(block.nodes), stages.system.equations(), block.matrix);
                needed.push_back(block.nodes);
            }
        }
    }
    std::ranges::sort(needed);
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    if (std::ranges::includes(groups_, needed)) return;
    // Those that are near are likely to touch next.
    for (std::size_t j = 0; j < stages.count(); ++j) {
        stages.with_stage(
            j, [&] { std::ranges::move(contacts.list_groups(stages.state), std::back_inserter(needed)); });
    }
    std::ranges::sort(needed);
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    groups_ = std::move(needed);
    build();
}

const std::vector<double>& ExactMatrix::spread(const StagesOfStep& stages,
                                               const std::vector<PairBlock>& blocks) {
    if (!paired_) return block_;
    spread_.assign(static_cast<std::size_t>(paired_->nonzeros()), 0.0);
    for (std::size_t i = 0; i < block_.size(); ++i) spread_[static_cast<std::size_t>(places_[i])] = block_[i];
    std::vector<std::int64_t> slots;
    for (const PairBlock& block : blocks) {
        slots.resize(36 * block.nodes.size() * block.nodes.size());
        find_slots(block.nodes, stages.system.equations(), *paired_, slots);
        add_to_values(block.matrix.data(), slots, spread_);
    }
    return spread_;
}

bool ExactMatrix::factorize(const StagesOfStep& stages, SolverWorkspace& workspace) {
    {
        const PhaseTimer timer(workspace.seconds.assembly);
        find_pairs(stages, workspace);
        assemble(stages, workspace);
    }
    const PhaseTimer timer(workspace.seconds.solve);
    return solver_->factorize(values_).regular;
}

void ExactMatrix::assemble(const StagesOfStep& stages, SolverWorkspace& workspace) {
    const std::size_t count = stages.count();
    const SparsePattern& pattern = paired_ ? *paired_ : stages.system.pattern();
    const auto entries = static_cast<std::size_t>(pattern.nonzeros());
    std::vector<std::vector<double>> rows(count * count, std::vector<double>(entries, 0.0));
    of_stages_.resize(count);
    for (std::size_t j = 0; j < count; ++j) {
        blocks_.assign(count, std::vector<double>(entries, 0.0));
        for (std::size_t k = 0; k < count; ++k) {
            stages.scheme.linearize(stages.state,
                                    stages.step.time_step,
                                    static_cast<int>(j),
                                    static_cast<int>(k),
                                    workspace.linearizations,
                                    stages.system.team());
            stages.with_stage(j, [&] {
                stages.system.compute_tangent(stages.state,
                                              stages.time_of(j),
                                              workspace.linearizations,
                                              block_,
                                              stages.tangent_request());
            });
            if (k == j) of_stages_[j] = block_;
            const std::vector<double>& values = spread(stages, pairs_[j * count + k]);
            for (std::size_t l = 0; l < count; ++l)
                add_scaled(from_unknowns_(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)),
                           values,
                           blocks_[l]);
        }
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t l = 0; l < count; ++l)
                add_scaled(to_equations_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                           blocks_[l],
                           rows[i * count + l]);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t l = 0; l < count; ++l)
            stacked_->set(static_cast<int>(i), static_cast<int>(l), rows[i * count + l], 1.0, values_);
    }
}

void ExactMatrix::solve(const StagesOfStep& stages,
                        const std::vector<Residual>& residuals,
                        SolverWorkspace& workspace,
                        std::vector<Eigen::VectorXd>& increments) {
    const PhaseTimer timer(workspace.seconds.solve);
    const System& system = stages.system;
    const auto size = static_cast<Eigen::Index>(system.equations().count());
    const auto count = static_cast<Eigen::Index>(stages.count());
    Matrix right_sides(size, count);
    for (std::size_t j = 0; j < stages.count(); ++j) {
        Eigen::VectorXd right_side = gather(residuals[j].nodal, system.equations(), system.team());
        if (!system.joints().empty()) system.joints().set_rows(residuals[j].rows, of_stages_[j], right_side);
        right_sides.col(static_cast<Eigen::Index>(j)) = -right_side;
    }
    const Matrix combined = right_sides * to_equations_.transpose();
    Eigen::VectorXd vector;
    for (Eigen::Index i = 0; i < count; ++i) stacked_->set(static_cast<int>(i), combined.col(i), vector);
    solver_->solve(vector);
    Matrix unknowns(size, count);
    Eigen::VectorXd one;
    for (Eigen::Index l = 0; l < count; ++l) {
        stacked_->get(static_cast<int>(l), vector, one);
        unknowns.col(l) = one;
    }
    const Matrix found = unknowns * from_unknowns_.transpose();
    increments.resize(stages.count());
    for (Eigen::Index j = 0; j < count; ++j) increments[static_cast<std::size_t>(j)] = found.col(j);
}

}  // namespace gxrod
