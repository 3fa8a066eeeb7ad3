#pragma once

#include <span>
#include <string>
#include <vector>

#include "analyses/path/branch_switch.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// Describes the critical points of a path, a sentence each. `branches` leave the path. If the loads have no
// potential, pivots do not tell whether it is stable.
std::vector<std::string> describe_critical_points(std::span<const CriticalPoint> points,
                                                  std::span<const BranchStart> branches,
                                                  bool has_potential);

// Says that the tangent is singular in this direction all along a path, and which displacement to hold.
std::string describe_symmetry(const System& system, const Eigen::VectorXd& direction);

// Says that a limit point was followed to an end of the parameter, and its load factor there.
std::string describe_followed_limit(double end, double load_factor);

}  // namespace gxrod
