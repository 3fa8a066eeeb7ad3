#pragma once

#include <cmath>
#include <numbers>

#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// Bounds how far the increments of Newton's method can have turned nodes of one element against each other:
// beyond half a turn a logarithm cannot tell in which direction they turned.
class RotationGuard {
  public:
    // The system must outlive it.
    explicit RotationGuard(const System& system) : system_(&system) {}

    // Returns false, and reports it, if these spins of nodes with these motions could turn them so far.
    template <class SpinOf>
    bool admits(const std::vector<NodeMotion>& motions, const SpinOf& spin, EquilibriumReport& report) {
        const auto square = [&](std::size_t node) { return spin(node).squaredNorm(); };
        bound_ += 2.0 * std::sqrt(system_->team().find_largest(motions.size(), square));
        if (bound_ < std::numbers::pi) return true;
        std::vector<Vec3> spins(motions.size());
        for (std::size_t node = 0; node < spins.size(); ++node) spins[node] = spin(node);
        const RelativeRotation bound = SystemMeasures(*system_).bound_relative_rotation(motions, spins);
        bound_ = bound.angle;
        if (bound.angle < std::numbers::pi) return true;
        report.outcome = Outcome::element_too_turned;
        report.worst_node = bound.node;
        report.worst_component = -1;
        return false;
    }

  private:
    const System* system_;
    // Bound on relative rotations of an element's nodes; not known at first.
    double bound_ = std::numbers::pi;
};

// Returns false, and reports it, if a node turned by π or more since the last accepted step, up to rounding.
inline bool check_step_rotations(const System& system,
                                 const std::vector<NodeMotion>& motions,
                                 EquilibriumReport& report) {
    constexpr double largest = (1.0 - 1e-12) * std::numbers::pi * std::numbers::pi;
    const auto square = [&](std::size_t node) { return motions[node].theta.squaredNorm(); };
    if (system.team().find_largest(motions.size(), square) < largest) return true;
    std::size_t node = 0;
    while (square(node) < largest) ++node;
    report.outcome = Outcome::rotation_too_large;
    report.worst_node = static_cast<int>(node);
    report.worst_component = -1;
    return false;
}

}  // namespace gxrod
