#include "solvers/paired_matrix.hpp"

#include <algorithm>

#include "assembly/scatter.hpp"

namespace gxrod {

void PairedMatrix::start(std::vector<NodeGroup> groups) {
    std::ranges::sort(groups);
    if (solver_ && groups == groups_) return;
    groups_ = std::move(groups);
    build();
}

void PairedMatrix::build() {
    ++orderings_;
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

void PairedMatrix::set_values(const std::vector<double>& values, std::vector<PairBlock>& blocks) {
    bool is_new = false;
    for (const PairBlock& block : blocks) {
        const auto at = std::ranges::lower_bound(groups_, block.nodes);
        if (at != groups_.end() && *at == block.nodes) continue;
        groups_.insert(at, block.nodes);
        is_new = true;
    }
    if (is_new || !solver_) build();
    values_.assign(static_cast<std::size_t>(pattern_.nonzeros()), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) values_[static_cast<std::size_t>(places_[i])] = values[i];
    for (PairBlock& block : blocks) {
        if (block.matrix.isZero(0.0)) continue;
        turn_to_own_axes(std::span<const int>(block.nodes), system_->equations(), block.matrix);
        add_to_values(block.matrix.data(), slots_of(block.nodes), values_);
    }
}

}  // namespace gxrod
