#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "constraints/supports.hpp"

namespace gxrod {

// Which equation each of a node's six unknowns (δr, δφ) has; −1 where a support holds it.
class EquationNumbers {
  public:
    explicit EquationNumbers(const std::vector<FixedComponents>& fixed);

    std::int64_t count() const { return static_cast<std::int64_t>(unknowns_.size()); }
    std::size_t node_count() const { return equations_.size(); }
    const std::array<std::int64_t, 6>& of_node(int node) const { return equations_[node]; }

    struct Unknown {
        int node;
        int component;  // 0 … 5: x y z rx ry rz
    };
    const Unknown& unknown(std::int64_t equation) const { return unknowns_[equation]; }
    const std::vector<Unknown>& unknowns() const { return unknowns_; }

  private:
    std::vector<std::array<std::int64_t, 6>> equations_;
    std::vector<Unknown> unknowns_;
};

}  // namespace gxrod
