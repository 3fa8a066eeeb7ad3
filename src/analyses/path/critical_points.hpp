#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// A critical point that the trial motions hold.
struct LocatedPoint {
    PathTrial trial;  // its pivots are those beyond the point
    int multiplicity = 1;
    Eigen::MatrixXd kernel;  // a column each, orthonormal in the metric
    bool turns = false;      // whether the load factor turns back there
    double softening =
        0.0;  // at a simple bifurcation, how the eigenvalue that passes zero changes along the path
};

// Where the load factor turns back within a step from the last accepted equilibrium, from whose direction's
// load part to `end`'s it changes sign. nullopt if it cannot be found.
std::optional<LocatedPoint> locate_limit(PathContext& work, const PathVector& start, const PathTrial& end);

// The first place within the step where eigenvalues of the tangent pass zero, of which there are as many
// negative ones as pivots at both ends: from equilibria close to it, since at it two paths cross and Newton's
// method finds either. nullopt if no eigenvalue passes zero continuously: then the step has jumped.
std::optional<LocatedPoint> locate_bifurcation(PathContext& work,
                                               const PathVector& start,
                                               std::int64_t pivots_at_start,
                                               const PathTrial& end);

// Where the path crosses another one as the branch of a pitchfork: the load factor turns back, and an
// eigenvalue touches zero. nullopt if it does not, or not at once.
std::optional<LocatedPoint> locate_crossing(PathContext& work,
                                            const PathVector& start,
                                            std::int64_t pivots_at_start,
                                            const PathTrial& end);

}  // namespace gxrod
