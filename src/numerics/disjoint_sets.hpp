#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace gxrod {

// Sets of the numbers from 0, each known by its smallest one.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }
    int find(int one) {
        while (parent(one) != one) one = parent(one) = parent(parent(one));
        return one;
    }
    void join(int a, int b) {
        const auto [first, second] = std::minmax({find(a), find(b)});
        parent(second) = first;
    }

  private:
    int& parent(int one) { return parents_[static_cast<std::size_t>(one)]; }

    std::vector<int> parents_;
};

}  // namespace gxrod
