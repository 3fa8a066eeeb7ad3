#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rotation/types.hpp"
#include "state/motion.hpp"

// What is known of a path of equilibria beyond its states.
namespace gxrod {

// Of an accepted equilibrium of a path.
struct PathRow {
    double load_factor = 0.0;
    double load_rate = 0.0;  // of the unit tangent: how the load factor grows with the arc length
};

enum class CriticalKind {
    limit,        // the load factor turns back
    bifurcation,  // another path crosses this one
    divergence    // the same where loads have no potential: a real eigenvalue of the tangent passes zero
};

// How the branch lies to the path.
enum class Branching {
    unknown,        // not a bifurcation, or a multiple one, or no branch was found
    transcritical,  // the load factor grows to one side of the branch and falls to the other
    supercritical,  // a pitchfork whose branch is where the path is less stable
    subcritical     // a pitchfork whose branch is where the path is more stable
};

// A critical point of a path. The step that leads to it ends on it where it was located; where not, it lies
// within that step.
struct CriticalPoint {
    CriticalKind kind = CriticalKind::limit;
    Branching branching = Branching::unknown;
    bool is_located = true;
    std::int64_t step = 0;  // accepted steps of the path up to it
    double arc_length = 0.0;
    double load_factor = 0.0;
    // Of the tangent before and after it; −1: not counted.
    std::int64_t pivots_before = -1, pivots_after = -1;
    int multiplicity = 1;  // of the tangent's eigenvalue zero
    // As many shapes (δr, δφ of each node) without stiffness, orthonormal; of several, any basis.
    std::vector<std::vector<Vec6>> kernel;
    std::string shape;              // the first of them in words
    std::vector<NodeMotion> nodes;  // where it is; of a point that was not located, where the step ends
};

// A path, or a branch of one, as it was followed.
struct FollowedPath {
    std::string name;            // "path" of the main one, "path.2+" of a branch at its second critical point
    int parent = -1;             // index of the path that it leaves; −1 of the main one
    std::size_t point = 0;       // index of the parent's critical point where it begins
    int side = 0;                // 1 or −1, of the kernel's shape; 0 of the main path
    std::int64_t first_row = 0;  // of the histories that belongs to it
    std::vector<CriticalPoint> points = {};
    std::vector<std::int64_t> rows = {};     // of the histories, of each point
    std::vector<std::string> findings = {};  // the points in words
    std::string cause = {};                  // why it was not followed to its end; "" if it was
};

// Of a stage: the main path, then its branches in the order in which they were followed.
using PathRecord = std::vector<FollowedPath>;

}  // namespace gxrod
