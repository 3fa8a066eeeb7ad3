#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rotation/types.hpp"
#include "state/motion.hpp"

// Results on a path of equilibria beyond its states.
namespace gxrod {

// An accepted equilibrium of a path.
struct PathRow {
    double load_factor = 0.0;
    double load_rate = 0.0;  // derivative of the load factor by the arc length, from the unit tangent
};

enum class CriticalKind {
    limit,        // the load factor turns back
    bifurcation,  // another path crosses this one
    divergence,   // the same where loads have no potential: a real eigenvalue of the tangent passes zero
    touch,        // things begin to touch each other: no critical point, but listed with them
    release       // things that touched leave each other
};

// Whether the tangent is singular there.
inline bool is_critical(CriticalKind kind) {
    return kind != CriticalKind::touch && kind != CriticalKind::release;
}

// The kind of a branch by how its load factor changes.
enum class Branching {
    unknown,        // not a bifurcation, or a multiple one, or no branch was found
    transcritical,  // the load factor grows to one side of the branch and falls to the other
    supercritical,  // a pitchfork whose branch is where the path is less stable
    subcritical     // a pitchfork whose branch is where the path is more stable
};

// A critical point of a path. If it was located, the step that leads to it ends on it; if not, it lies within
// that step.
struct CriticalPoint {
    CriticalKind kind = CriticalKind::limit;
    Branching branching = Branching::unknown;
    bool is_located = true;
    std::int64_t step = 0;  // accepted steps of the path up to it
    double arc_length = 0.0;
    double load_factor = 0.0;
    // Negative pivots of the tangent before and after it; −1: not counted.
    std::int64_t pivots_before = -1, pivots_after = -1;
    int multiplicity = 1;  // multiplicity of the tangent's eigenvalue zero; 0 of contact
    // As many shapes (δr, δφ of each node) without stiffness, orthonormal; any basis if there are several.
    std::vector<std::vector<Vec6>> kernel;
    std::string shape;              // the first of them in words; of contact, what touches
    std::vector<NodeMotion> nodes;  // at the point, or at the end of the step if it was not located
};

// A path, or a branch of one, as it was followed.
struct FollowedPath {
    std::string name;       // "path" for the main one, "path.2+" for a branch at its second critical point
    int parent = -1;        // index of the path that it leaves; −1 for the main one
    std::size_t point = 0;  // index of the parent's critical point where it begins
    int side = 0;           // 1 or −1, along the kernel's shape; 0 for the main path
    std::int64_t first_row = 0;  // first of its rows in the histories
    std::vector<CriticalPoint> points = {};
    std::vector<std::int64_t> rows = {};     // rows of the histories, one for each point
    std::vector<std::string> findings = {};  // the points in words
    std::string cause = {};                  // why it was not followed to its end; "" if it was
};

// The paths of a stage: the main one, then its branches in the order in which they were followed.
using PathRecord = std::vector<FollowedPath>;

}  // namespace gxrod
