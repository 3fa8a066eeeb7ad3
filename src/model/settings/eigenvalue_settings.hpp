#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gxrod {

// Eigenvalues at several values of a number in the deck.
struct EigenvalueSweep {
    std::string key;             // key of the deck, such as parameters.Omega
    std::vector<double> values;  // in the order in which modes are followed
    bool finds_onset = true;     // finds where motions begin to grow, or stop growing
    bool keeps_shapes = false;   // keeps the shapes at each value
};

// Small motions about a state with damping, follower loads and rotation.
struct EigenvalueSettings {
    int count = 10;  // those nearest to zero with Im λ ≥ 0; more if others seem to grow
    // Uses the determinant to look for missed ones: takes about as long again in small models, and much
    // longer in large ones that are not chains.
    bool counts = true;
    bool left = false;  // the left vectors too
    // Steps of Arnoldi's method before its first check, such as the steps of a similar problem; 0: by the
    // count.
    std::int64_t first_steps = 0;
    std::optional<EigenvalueSweep> sweep = {};
};

}  // namespace gxrod
