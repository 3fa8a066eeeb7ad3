#pragma once

namespace gxrod {

// Small motions about a state with all that damps, follows or turns.
struct EigenvalueSettings {
    int count = 10;  // with Im λ ≥ 0, those nearest to zero; more if motions beyond seem to grow
    // Looks by the determinant for those that were missed: about as long again in small models, and much
    // longer in large ones that are not chains.
    bool counts = true;
    bool left = false;  // the left vectors too
};

}  // namespace gxrod
