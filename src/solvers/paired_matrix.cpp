#include "solvers/paired_matrix.hpp"

#include <algorithm>
#include <limits>

#include "assembly/scatter.hpp"

namespace gxrod {

namespace {

// Of a direct factorization, for each unknown, from which on iterations are faster: with AVX-512 runs take
// a third of the time for 32 rods across 32 (4.9e4) and half of it for a pile of 100 rods (1.1e5).
constexpr double flops_for_iterations = 3e4;

}  // namespace

void PairedMatrix::start(std::vector<NodeGroup> groups) {
    has_failed_ = false;
    std::ranges::sort(groups);
    if (solver_ && !is_stale_ && groups == groups_) return;
    groups_ = std::move(groups);
    build();
}

void PairedMatrix::build() {
    ++orderings_;
    is_stale_ = false;
    std::vector<NodeGroup> all = system_->list_node_groups();
    all.insert(all.end(), groups_.begin(), groups_.end());
    solver_.reset();
    pattern_ = compute_pattern(system_->equations(), all);
    solver_ = make_linear_solver(kind_, pattern_, system_->team());
    slots_.assign(groups_.size(), {});
    places_.resize(static_cast<std::size_t>(system_->pattern().nonzeros()));
    system_->pattern().visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        places_[static_cast<std::size_t>(slot)] = pattern_.slot(row, column);
    });
}

const std::vector<std::int64_t>& PairedMatrix::slots_of(const NodeGroup& group) {
    const auto at = std::ranges::lower_bound(groups_, group) - groups_.begin();
    std::vector<std::int64_t>& slots = slots_[static_cast<std::size_t>(at)];
    if (slots.empty()) {
        slots.resize(36 * group.size() * group.size());
        find_slots(group, system_->equations(), pattern_, slots);
    }
    return slots;
}

void PairedMatrix::set_values(const std::vector<double>& values, std::vector<PairBlock> blocks) {
    bool is_new = false;
    for (const PairBlock& block : blocks) {
        const auto at = std::ranges::lower_bound(groups_, block.nodes);
        if (at != groups_.end() && *at == block.nodes) continue;
        groups_.insert(at, block.nodes);
        is_new = true;
    }
    is_stale_ = is_stale_ || is_new;
    // Iterations need no pattern, and more groups no fewer of them.
    if (!solver_ || (is_stale_ && !wants_iterations())) build();
    system_values_ = values;
    blocks_ = std::move(blocks);
    std::erase_if(blocks_, [](const PairBlock& block) { return block.matrix.isZero(0.0); });
    for (PairBlock& block : blocks_)
        turn_to_own_axes(std::span<const int>(block.nodes), system_->equations(), block.matrix);
}

std::vector<CouplingBlock> PairedMatrix::list_couplings() const {
    std::vector<CouplingBlock> couplings;
    couplings.reserve(blocks_.size());
    for (const PairBlock& block : blocks_) {
        CouplingBlock& coupling = couplings.emplace_back(CouplingBlock{{}, block.matrix});
        for (const int node : block.nodes) {
            const std::array<std::int64_t, 6> unknowns = system_->equations().of_node(node);
            coupling.unknowns.insert(coupling.unknowns.end(), unknowns.begin(), unknowns.end());
        }
    }
    return couplings;
}

bool PairedMatrix::wants_iterations() const {
    return kind_ == LinearSolverKind::automatic && !is_direct_ && !has_failed_ &&
           solver_->estimate_flops() > flops_for_iterations * static_cast<double>(system_->pattern().size());
}

Factorization PairedMatrix::factorize() {
    is_iterative_ = false;
    if (wants_iterations()) {
        if (!coupling_) coupling_ = std::make_unique<CouplingSolver>(system_->pattern(), system_->team());
        is_iterative_ = coupling_->is_suitable() && coupling_->factorize(system_values_, list_couplings());
        if (is_iterative_) return {};
        has_failed_ = true;
    }
    return factorize_directly();
}

Factorization PairedMatrix::factorize_directly() {
    const std::vector<double>& values = assemble();  // may make another solver_
    return solver_->factorize(values);
}

const std::vector<double>& PairedMatrix::assemble() {
    if (is_stale_) build();
    values_.assign(static_cast<std::size_t>(pattern_.nonzeros()), 0.0);
    for (std::size_t i = 0; i < system_values_.size(); ++i)
        values_[static_cast<std::size_t>(places_[i])] = system_values_[i];
    for (const PairBlock& block : blocks_) add_to_values(block.matrix.data(), slots_of(block.nodes), values_);
    return values_;
}

void PairedMatrix::solve(Eigen::VectorXd& right_hand_side) {
    if (is_iterative_) {
        if (coupling_->solve(right_hand_side)) return;
        is_iterative_ = false;
        has_failed_ = true;
        if (!factorize_directly().regular) {
            right_hand_side.setConstant(std::numeric_limits<double>::quiet_NaN());
            return;
        }
    }
    solver_->solve(right_hand_side);
}

}  // namespace gxrod
