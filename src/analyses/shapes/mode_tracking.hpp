#pragma once

#include <Eigen/Core>

#include "assembly/state_matrices.hpp"
#include "state/records/eigenvalue_record.hpp"

namespace gxrod {

// What is compared of the modes about a state, a column each: left vectors y, and M z and D z of the right
// ones, and R z of what relaxes in each time.
struct ModeTraces {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd left, mass, damping;
    std::vector<std::pair<RelaxingMatrix, Eigen::MatrixXcd>> relaxing;  // without values
};
ModeTraces make_traces(const System& system,
                       const StateMatrices& matrices,
                       const std::vector<Eigenmode>& modes);

struct ModeMatch {
    int mode = -1;            // of the later ones; −1 if none is left
    double corruption = 1.0;  // the largest correlation with another one, copies apart, over its own
};

// Which of the later modes each of the earlier ones has become, by |yᵀ ((λ + μ) M + D) z| of the earlier y, λ
// and the later z, μ, what relaxes included: about 1 for the same mode and 0 for another one, exactly so in
// one and the same system (docs/theory/vibrations.md, (V20)).
std::vector<ModeMatch> match_modes(const ModeTraces& earlier, const ModeTraces& later);

}  // namespace gxrod
