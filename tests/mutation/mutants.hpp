#pragma once

#include <cstdlib>

// What tests/mutation puts before every source of its copy: one sign or coefficient is wrong, the one whose
// number the environment variable GXROD_MUTANT has.

inline int gxrod_active_mutant() {
    static const int active = [] {
        const char* text = std::getenv("GXROD_MUTANT");
        return text == nullptr ? 0 : std::atoi(text);
    }();
    return active;
}

inline double gxrod_sign(int mutant) { return gxrod_active_mutant() == mutant ? -1.0 : 1.0; }

inline double gxrod_coefficient(int mutant, double right, double wrong) {
    return gxrod_active_mutant() == mutant ? wrong : right;
}
