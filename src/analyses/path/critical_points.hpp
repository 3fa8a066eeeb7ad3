#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// A critical point; the trial motions hold it.
struct LocatedPoint {
    PathTrial trial;  // with the pivots beyond the point
    int multiplicity = 1;
    Eigen::MatrixXd kernel;  // a column each, orthonormal in the metric
    bool turns = false;      // whether the load factor turns back there
    double softening =
        0.0;  // at a simple bifurcation, how the eigenvalue that passes zero changes along the path
};

// Locates the point within a step from the last accepted equilibrium where the load factor turns back: the
// load part of the direction changes its sign from `start` to `end`. Returns nullopt if it cannot be found.
std::optional<LocatedPoint> locate_limit(PathContext& work, const PathVector& start, const PathTrial& end);

// Locates the first place within the step where eigenvalues of the tangent pass zero; the pivots at both ends
// count its negative eigenvalues. It searches from equilibria nearby, since two paths cross at the point and
// Newton's method finds either. Returns nullopt if no eigenvalue passes zero continuously: then the step has
// jumped.
std::optional<LocatedPoint> locate_bifurcation(PathContext& work,
                                               const PathVector& start,
                                               std::int64_t pivots_at_start,
                                               const PathTrial& end);

// Locates the point where the path crosses another one as the branch of a pitchfork: the load factor turns
// back, and an eigenvalue touches zero. Returns nullopt if it does not, or not at the same point.
std::optional<LocatedPoint> locate_crossing(PathContext& work,
                                            const PathVector& start,
                                            std::int64_t pivots_at_start,
                                            const PathTrial& end);

}  // namespace gxrod
