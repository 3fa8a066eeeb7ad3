#pragma once

#include "model/spring_law.hpp"

namespace gxrod {

// Computes the energy of a spring's law at this length: the integral of its force, without a rate, over the
// length from its value at t = 0.
double compute_law_energy(const SpringLaw& law, double length);

}  // namespace gxrod
