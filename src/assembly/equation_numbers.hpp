#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "constraints/supports.hpp"

namespace gxrod {

// Which equation each of a node's six unknowns (δr, δφ) has; −1 where a support holds it. The unknowns of a
// node whose support has its own axes are counted in those.
class EquationNumbers {
  public:
    // The supports must outlive it.
    explicit EquationNumbers(const Supports& supports);

    std::int64_t count() const { return firsts_.back(); }
    std::size_t node_count() const { return firsts_.size() - 1; }
    std::array<std::int64_t, 6> of_node(int node) const {
        const HeldComponents& held = supports_->held(node);
        std::array<std::int64_t, 6> numbers;
        std::int64_t next = firsts_[node];
        for (int i = 0; i < 6; ++i) numbers[i] = held[i] ? -1 : next++;
        return numbers;
    }
    // Whether a node has all six unknowns, in global axes: then their numbers follow each other.
    bool is_free(int node) const {
        return firsts_[node + 1] - firsts_[node] == 6 && !supports_->has_own_axes(node);
    }
    const Supports& supports() const { return *supports_; }

    struct Unknown {
        int node;
        int component;  // 0 … 5: x y z rx ry rz
    };
    // Searched for: not for every equation.
    Unknown unknown(std::int64_t equation) const;

    // From global components of a node to those in which its unknowns are counted, and back.
    Vec6 to_own_axes(int node, const Vec6& global) const;
    Vec6 to_global_axes(int node, const Vec6& own) const;
    // The increment (δr, δφ) of a node, global components, zero where held.
    Vec6 increment_of(int node, const Eigen::VectorXd& solution) const;

  private:
    const Supports* supports_;
    std::vector<std::int64_t> firsts_;  // of each node, and the number of all
};

}  // namespace gxrod
