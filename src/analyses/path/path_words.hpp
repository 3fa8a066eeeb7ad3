#pragma once

#include <span>
#include <string>
#include <vector>

#include "analyses/path/branch_switch.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// The critical points of a path in words, a sentence each. `branches` are those that leave it; if the loads
// have no potential, pivots say nothing of stability.
std::vector<std::string> describe_critical_points(std::span<const CriticalPoint> points,
                                                  std::span<const BranchStart> branches,
                                                  bool has_potential);

// That the tangent is singular in this direction all along a path, and which displacement to hold.
std::string describe_symmetry(const System& system, const Eigen::VectorXd& direction);

// That a limit point was followed to an end of the parameter, where its load factor is this.
std::string describe_followed_limit(double end, double load_factor);

}  // namespace gxrod
