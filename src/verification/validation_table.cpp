#include "verification/validation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gxrod {

namespace {

constexpr std::size_t most_lines = 8;  // of a study, of checks that passed

// The entry of a vector that is furthest from its reference.
std::size_t find_worst_entry(const Check& check) {
    std::size_t worst = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < check.reference.size(); ++i) {
        const double error = std::abs(check.value[i] - check.reference[i]);
        if (error > most) {
            most = error;
            worst = i;
        }
    }
    return worst;
}

// "position of tip, t = 1" → "position of tip, t = 1: y".
std::string name_entry(const Check& check, std::size_t entry) {
    constexpr std::array axes{"x", "y", "z"};
    constexpr std::array quaternion{"w", "x", "y", "z"};
    if (check.reference.size() == 1) return check.what;
    if (check.reference.size() == 4) return check.what + ": " + quaternion[entry];
    return check.what + ": " + (check.reference.size() <= 3 ? axes[entry] : std::to_string(entry + 1));
}

// Pads text to a width in characters; a UTF-8 letter counts as one.
std::string pad(const std::string& text, std::size_t width) {
    const auto characters = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    return text + std::string(characters < width ? width - characters : 1, ' ');
}

constexpr std::size_t what_width = 58;
constexpr std::size_t reference_width = 25;

std::string describe(const Check& check) {
    const std::size_t entry = find_worst_entry(check);
    const std::string uncertainty =
        check.uncertainty == 0.0 ? "" : fmt::format(" ± {:.0e}", check.uncertainty);
    return fmt::format("  {}{}{:<18.11g}{:>9.1e}{:>10.1e}{:>7}{}\n",
                       pad(name_entry(check, entry), what_width),
                       pad(fmt::format("{:.11g}{}", check.reference[entry], uncertainty), reference_width),
                       check.value[entry],
                       check.error,
                       check.tolerance,
                       check.order ? fmt::format("{:.2f}", *check.order) : "-",
                       check.passed() ? "" : "  MISSED");
}

}  // namespace

std::string validation_head() {
    return fmt::format("  {}{}{:<18}{:>9}{:>10}{:>7}\n",
                       pad("case and value", what_width),
                       pad("reference ± uncertainty", reference_width),
                       "gxrod",
                       "error",
                       "tolerance",
                       "order");
}

std::string describe_checks(const Study& study, const StudyResult& result, double seconds) {
    std::string text = fmt::format("{} ({}): {}. {:.2f} s\n", study.name, study.kind, study.source, seconds);
    std::size_t passed = 0;
    for (const Check& check : result.checks) {
        if (check.passed() && ++passed > most_lines) continue;
        text += describe(check);
    }
    if (passed > most_lines) text += fmt::format("  … and {} more within tolerance\n", passed - most_lines);
    return text;
}

std::string describe_totals(const ValidationTotals& totals) {
    return fmt::format(
        "Of a vector the entry that is furthest off is shown; error: the length of the whole difference, by "
        "the value's scale.\n{} case{}, {} checks, {} in {:.1f} s\n",
        totals.studies,
        totals.studies == 1 ? "" : "s",
        totals.checks,
        totals.missed == 0 ? "none missed" : fmt::format("{} MISSED", totals.missed),
        totals.seconds);
}

}  // namespace gxrod
