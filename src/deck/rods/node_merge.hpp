#pragma once

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace gxrod {

// Keeps which nodes become one: the node that the deck names first.
class NodeMerge {
  public:
    explicit NodeMerge(std::size_t nodes) : parents_(nodes), ranks_(nodes, never) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    void name(int node) {
        if (ranks_[node] == never) ranks_[node] = next_rank_++;
    }

    int root(int node) const {
        while (parents_[node] != node) node = parents_[node];
        return node;
    }

    void join(int first, int second) {
        first = root(first);
        second = root(second);
        if (ranks_[second] < ranks_[first]) std::swap(first, second);
        parents_[second] = first;
    }

    // Numbers all nodes anew; nodes that stand for others keep their order.
    std::vector<int> renumber() const {
        std::vector<int> numbers(parents_.size());
        int next = 0;
        for (int node = 0; node < static_cast<int>(parents_.size()); ++node) {
            if (parents_[node] == node) numbers[node] = next++;
        }
        for (int node = 0; node < static_cast<int>(parents_.size()); ++node) {
            numbers[node] = numbers[root(node)];
        }
        return numbers;
    }

  private:
    static constexpr int never = std::numeric_limits<int>::max();

    std::vector<int> parents_;
    std::vector<int> ranks_;  // when the deck named the node first
    int next_rank_ = 0;
};

}  // namespace gxrod
