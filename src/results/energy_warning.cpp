#include "results/energy_warning.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace gxrod {

namespace {

std::string describe_jumps(const EnergyJumps& jumps, double largest_energy, double round_off) {
    if (jumps.count == 0 || jumps.largest.energy <= round_off) return "";
    const std::string others =
        jumps.count == 1 ? "" : fmt::format("; {} load steps jump, this one the farthest", jumps.count);
    return fmt::format(
        "the structure jumps between t = {:.10g} and t = {:.10g}: its strain energy and the work of its "
        "loads "
        "part there by at least {:.3g}, compared with an energy of {:.3g}{}. What follows is another branch "
        "of "
        "equilibria: more load steps narrow down where the structure leaves the first, and a dynamic "
        "analysis "
        "shows where it goes",
        jumps.largest.from,
        jumps.largest.to,
        jumps.largest.energy,
        largest_energy,
        others);
}

}  // namespace

std::string describe_imbalance(const EnergySurvey& survey, double round_off) {
    if (survey.is_static) return describe_jumps(survey.jumps, survey.largest, round_off);
    constexpr double tolerable = 0.1;
    if (survey.largest_error <= std::max(tolerable * survey.largest, round_off)) return "";
    return fmt::format(
        "the energy does not balance: an error of {:.3g} compared with an energy of {:.3g} "
        "(ledger/energy_error). The steps are too long for how fast the structure moves or vibrates: take "
        "shorter ones",
        survey.largest_error,
        survey.largest);
}

}  // namespace gxrod
