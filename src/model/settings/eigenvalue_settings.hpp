#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gxrod {

// Eigenvalues at each of several values of a number of the deck.
struct EigenvalueSweep {
    std::string key;             // of the deck, such as parameters.Omega
    std::vector<double> values;  // in the order in which modes are followed
    bool finds_onset = true;     // where motions begin to grow, or stop to
};

// Small motions about a state with all that damps, follows or turns.
struct EigenvalueSettings {
    int count = 10;  // with Im λ ≥ 0, those nearest to zero; more if motions beyond seem to grow
    // Looks by the determinant for those that were missed: about as long again in small models, and much
    // longer in large ones that are not chains.
    bool counts = true;
    bool left = false;  // the left vectors too
    // Steps of Arnoldi's method before it looks at what it has, such as those of a problem next to this one;
    // 0: by the count.
    std::int64_t first_steps = 0;
    std::optional<EigenvalueSweep> sweep = {};
};

}  // namespace gxrod
