#pragma once

#include <vector>

#include "state/contact_trial.hpp"

namespace gxrod {

// Friction between two pieces of rods, as it acts on the first; spatial.
struct PairTraction {
    NearPieces pieces;
    Vec3 traction = Vec3::Zero();
};

// Memory of contact: friction at the last accepted step.
struct ContactMemory {
    // Friction from obstacles at each place, per length, spatial: places of the first obstacle, then of the
    // next.
    std::vector<Vec3> on_obstacles;
    std::vector<PairTraction> of_pairs;  // pairs that touch, sorted
};

// Pairs as rows of numbers: both pieces, then the traction; rows of zeros fill up to a power of two.
using PairTractionRow = Eigen::Matrix<double, 5, 1>;
std::vector<PairTractionRow> pack(const std::vector<PairTraction>& pairs);
std::vector<PairTraction> unpack(const std::vector<PairTractionRow>& rows);

}  // namespace gxrod
