#include "linear/fronts/elimination_order.hpp"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <span>
#include <unordered_set>

namespace gxrod {
namespace {

class Graph {
  public:
    explicit Graph(const BlockPartition& blocks)
        : blocks_(blocks), added_(blocks.count()), degrees_(blocks.count()), is_gone_(blocks.count(), false) {
        for (int block = 0; block < blocks.count(); ++block)
            degrees_[block] = static_cast<int>(own(block).size());
    }

    int degree(int block) const { return degrees_[block]; }
    bool is_gone(int block) const { return is_gone_[block]; }

    // The first two neighbours that are left.
    std::array<int, 2> neighbours(int block) const {
        std::array<int, 2> found{-1, -1};
        std::size_t count = 0;
        const auto look = [&](const auto& list) {
            for (const int other : list) {
                if (count == 2) return;
                if (!is_gone_[other]) found[count++] = other;
            }
        };
        look(own(block));
        look(added_[block]);
        return found;
    }

    bool are_coupled(int a, int b) const {
        const auto list = own(a);
        return std::binary_search(list.begin(), list.end(), b) || fills_.count(key(a, b)) > 0;
    }

    void remove(int block) {
        is_gone_[block] = true;
        for (const int other : neighbours(block)) {
            if (other >= 0) --degrees_[other];
        }
    }

    void couple(int a, int b) {
        fills_.insert(key(a, b));
        added_[a].push_back(b);
        added_[b].push_back(a);
        ++degrees_[a];
        ++degrees_[b];
    }

  private:
    std::span<const int> own(int block) const {
        return std::span(blocks_.neighbours)
            .subspan(blocks_.neighbour_starts[block],
                     blocks_.neighbour_starts[block + 1] - blocks_.neighbour_starts[block]);
    }
    static std::uint64_t key(int a, int b) {
        constexpr int half = 32;
        return (static_cast<std::uint64_t>(std::min(a, b)) << half) |
               static_cast<std::uint64_t>(std::max(a, b));
    }

    const BlockPartition& blocks_;
    std::vector<std::vector<int>> added_;  // neighbours by fill
    std::unordered_set<std::uint64_t> fills_;
    std::vector<int> degrees_;
    std::vector<bool> is_gone_;
};

}  // namespace

EliminationOrder::EliminationOrder(const BlockPartition& blocks, int largest) {
    Graph graph(blocks);
    std::queue<int> ends;        // with one neighbour or none
    std::queue<int> between;     // with two, perhaps coupled
    std::vector<int> in_chains;  // with two that were not coupled when last seen
    const auto sort_in = [&](int block) {
        if (graph.is_gone(block) || blocks.size(block) > largest) return;
        if (graph.degree(block) <= 1) ends.push(block);
        if (graph.degree(block) == 2) between.push(block);
    };
    for (int block = 0; block < blocks.count(); ++block) sort_in(block);
    const auto eliminate = [&](int block) {
        const Step step{block, graph.neighbours(block)};
        graph.remove(block);
        const auto [a, b] = step.neighbours;
        if (b >= 0 && !graph.are_coupled(a, b)) {
            ++fills;
            graph.couple(a, b);
        }
        steps.push_back(step);
        for (const int neighbour : step.neighbours) {
            if (neighbour >= 0) sort_in(neighbour);
        }
    };
    while (true) {
        if (!between.empty()) {
            const int block = between.front();
            between.pop();
            if (graph.is_gone(block) || graph.degree(block) != 2) continue;
            const auto [a, b] = graph.neighbours(block);
            if (graph.are_coupled(a, b)) {
                eliminate(block);
            } else {
                in_chains.push_back(block);
            }
        } else if (!ends.empty()) {
            const int block = ends.front();
            ends.pop();
            if (!graph.is_gone(block)) eliminate(block);
        } else if (!in_chains.empty()) {
            const int block = in_chains.back();
            in_chains.pop_back();
            if (!graph.is_gone(block)) eliminate(block);
        } else {
            break;
        }
    }
    for (int block = 0; block < blocks.count(); ++block) {
        if (!graph.is_gone(block)) kept.push_back(block);
    }
}

}  // namespace gxrod
