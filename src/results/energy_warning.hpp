#pragma once

#include <string>

namespace gxrod {

// What to say where the largest error of the energy balance is above a tenth of the largest energy and above
// what is round-off, so that results are not to be trusted: a clause that begins in lower case and has no
// full stop. Else "".
std::string describe_imbalance(double largest_energy, double largest_error, double round_off);

}  // namespace gxrod
