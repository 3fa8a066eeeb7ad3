#include "results/energy_warning.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace gxrod {

std::string describe_imbalance(double largest_energy, double largest_error, double round_off) {
    constexpr double tolerable = 0.1;
    if (largest_error <= std::max(tolerable * largest_energy, round_off)) return "";
    return fmt::format(
        "the energy does not balance: an error of {:.3g} beside an energy of {:.3g} (ledger/energy_error). "
        "Steps may be too long, a vibration too fast for them, or, in statics, the structure has jumped",
        largest_error,
        largest_energy);
}

}  // namespace gxrod
