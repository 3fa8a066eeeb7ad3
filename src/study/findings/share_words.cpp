#include "study/findings/share_words.hpp"

#include <fmt/format.h>

namespace gxrod {

namespace {

constexpr double least_whole = 0.995;  // what is 100 % with two digits
constexpr double most_shown = 1000.0;  // of what is reported as a share

}  // namespace

std::string describe_share(double share) {
    if (share > most_shown) return fmt::format("more than {:.0f} %", 100.0 * most_shown);
    // Two digits of what is more than 100 % as of the rest.
    if (share >= least_whole) return fmt::format("{:.0f} %", std::stod(fmt::format("{:.1e}", 100.0 * share)));
    return share >= 1e-4 ? fmt::format("{:.2g} %", 100.0 * share) : fmt::format("{:.0e}", share);
}

}  // namespace gxrod
