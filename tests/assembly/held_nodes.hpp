#pragma once

#include "assembly/equation_numbers.hpp"

namespace gxrod::tools {

// Nodes with a support each, and the numbers of their equations.
struct HeldNodes {
    Model model;
    Supports supports;
    EquationNumbers equations;

    // `axes` are the supports' own, identity where there are none.
    explicit HeldNodes(const std::vector<HeldComponents>& held, const std::vector<Quat>& axes = {})
        : model(make_model(held, axes)), supports(model), equations(supports) {}
    HeldNodes(const HeldNodes&) = delete;  // its parts point at each other
    HeldNodes& operator=(const HeldNodes&) = delete;

  private:
    static Model make_model(const std::vector<HeldComponents>& held, const std::vector<Quat>& axes) {
        Model made;
        made.nodes.resize(held.size());
        for (std::size_t i = 0; i < held.size(); ++i) {
            made.supports.push_back({.node = static_cast<int>(i), .fixed = held[i]});
            if (i < axes.size()) made.supports.back().axes = axes[i];
        }
        return made;
    }
};

}  // namespace gxrod::tools
