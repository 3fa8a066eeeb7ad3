#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "parallel/thread_team.hpp"

namespace gxrod {

// Items 0 … count − 1 that add to nodes, in parts of `part_size`; parts are grouped in phases. No two parts
// of a phase touch the same node, so they can add at the same time. Parts and phases do not depend on the
// number of threads, so sums at nodes are the same to the last bit.
class WorkPhases {
  public:
    static constexpr std::size_t part_size = 128;

    WorkPhases() = default;
    // visit(item, mark) calls mark(node) for each node that the item touches.
    template <class Visit>
    WorkPhases(std::size_t count, std::size_t node_count, const Visit& visit) : count_(count) {
        std::vector<std::uint64_t> phases_of_node(node_count, 0);
        for (std::size_t part = 0; part < part_count(); ++part) {
            std::uint64_t taken = 0;
            const auto visit_part = [&](const auto& mark) {
                for (std::size_t item = first(part); item < last(part); ++item) visit(item, mark);
            };
            visit_part([&](int node) { taken |= phases_of_node[node]; });
            const std::uint64_t phase = add(part, taken);
            visit_part([&](int node) { phases_of_node[node] |= phase; });
        }
    }

    std::size_t part_count() const { return (count_ + part_size - 1) / part_size; }
    std::size_t phase_count() const { return phases_.size(); }
    std::size_t first(std::size_t part) const { return part * part_size; }
    std::size_t last(std::size_t part) const { return std::min(count_, (part + 1) * part_size); }

    // Calls work(part) for each part, phase after phase.
    template <class Work>
    void run(const ThreadTeam& team, const Work& work) const {
        for (const std::vector<std::size_t>& phase : phases_) {
            team.for_each(phase.size(), [&](std::size_t i) { work(phase[i]); });
        }
        for (const std::size_t part : alone_) work(part);
    }

  private:
    static constexpr std::size_t most_phases = 64;

    // Puts a part into the first phase that is not taken, and returns the bit of that phase.
    std::uint64_t add(std::size_t part, std::uint64_t taken);

    std::size_t count_ = 0;
    std::vector<std::vector<std::size_t>> phases_;
    std::vector<std::size_t> alone_;  // parts for which no phase was left
};

}  // namespace gxrod
