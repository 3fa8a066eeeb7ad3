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

    std::int64_t count() const { return static_cast<std::int64_t>(unknowns_.size()); }
    std::size_t node_count() const { return equations_.size(); }
    const std::array<std::int64_t, 6>& of_node(int node) const { return equations_[node]; }
    // Whether a node has all six unknowns, in global axes: then their numbers follow each other.
    bool is_free(int node) const;
    const Supports& supports() const { return *supports_; }

    struct Unknown {
        int node;
        int component;  // 0 … 5: x y z rx ry rz
    };
    const Unknown& unknown(std::int64_t equation) const { return unknowns_[equation]; }
    const std::vector<Unknown>& unknowns() const { return unknowns_; }

    // From global components of a node to those in which its unknowns are counted, and back.
    Vec6 to_own_axes(int node, const Vec6& global) const;
    Vec6 to_global_axes(int node, const Vec6& own) const;
    // The increment (δr, δφ) of a node, global components, zero where held.
    Vec6 increment_of(int node, const Eigen::VectorXd& solution) const;

  private:
    const Supports* supports_;
    std::vector<std::array<std::int64_t, 6>> equations_;
    std::vector<Unknown> unknowns_;
};

}  // namespace gxrod
