#pragma once

#include "model/spring_law.hpp"

namespace gxrod {

// What a spring's law has stored at this length: the integral of its force, without a rate, over the length
// from where it was at t = 0.
double compute_law_energy(const SpringLaw& law, double length);

}  // namespace gxrod
