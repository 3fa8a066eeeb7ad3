#pragma once

#include <Eigen/Core>

#include "assembly/state_matrices.hpp"
#include "state/records/eigenvalue_record.hpp"

namespace gxrod {

// Data by which the modes about a state are compared, a column each: left vectors y; M z and D z of the right
// vectors z; and R z of the relaxing stiffness for each relaxation time.
struct ModeTraces {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd left, mass, damping;
    std::vector<std::pair<RelaxingMatrix, Eigen::MatrixXcd>> relaxing;  // the matrices without values
};
ModeTraces make_traces(const System& system,
                       const StateMatrices& matrices,
                       const std::vector<Eigenmode>& modes);

struct ModeMatch {
    int mode = -1;  // index of the later mode; −1 if none is left
    double corruption =
        1.0;  // largest correlation with another mode, copies aside, over the correlation with this one
};

// Finds the later mode that each earlier mode has become, by |yᵀ ((λ + μ) M + D) z| for the earlier y, λ and
// the later z, μ, relaxing terms included: about 1 for the same mode and 0 for another one, exact within one
// system (docs/theory/vibrations.md, (V20)).
std::vector<ModeMatch> match_modes(const ModeTraces& earlier, const ModeTraces& later);

}  // namespace gxrod
