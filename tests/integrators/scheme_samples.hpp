#pragma once

#include <string>
#include <vector>

#include "integrators/integrator.hpp"

// Every scheme, with its parameters, for the every_integrator tests. A new scheme joins by an entry in
// make_schemes().
namespace gxrod::tools {

struct SchemeSample {
    std::string name;
    DynamicSettings settings;  // the scheme and its parameters
    double order;              // for motions with finite rotations

    // Its stages have no equilibria of their own.
    bool is_coupled() const {
        return settings.scheme == Scheme::radau_5 || settings.scheme == Scheme::gauss_4;
    }
};

const std::vector<SchemeSample>& all_schemes();

// Two nodes with random last steps: Λ_n, rates, accelerations; A_n of generalized-α and rates of earlier
// stages too.
State make_random_state(const Integrator& integrator, unsigned seed);

// The step in which the samples are looked at.
Stage make_stage(int index);

// A stage begun at random rates of the stages before it, its trial placed at a random finite θ and
// displacement.
void begin_random_stage(const Integrator& integrator, const Stage& stage, unsigned seed, State& state);

// v, a, ω, α of the first node, stacked.
using Rates = Eigen::Matrix<double, 12, 1>;
Rates stack_rates(const NodeMotion& motion);

}  // namespace gxrod::tools
