#pragma once

#include <vector>

#include "state/contact_trial.hpp"

namespace gxrod {

// Friction between two pieces of rods, as it acts on the first; spatial.
struct PairTraction {
    NearPieces pieces;
    Vec3 traction = Vec3::Zero();
};

// Pairs as rows of numbers: both pieces, then the traction; rows of zeros fill up to a power of two.
using PairTractionRow = Eigen::Matrix<double, 5, 1>;
std::vector<PairTractionRow> pack(const std::vector<PairTraction>& pairs);
std::vector<PairTraction> unpack(const std::vector<PairTractionRow>& rows);

}  // namespace gxrod
