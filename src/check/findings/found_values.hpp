#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "state/records/path_record.hpp"
#include "state/records/shapes_record.hpp"

// Quantities that stages find, by their names in results.
namespace gxrod {

inline constexpr std::array<std::string_view, 9> found_quantities{"frequency",
                                                                  "omega",
                                                                  "growth",
                                                                  "damping_ratio",
                                                                  "factor",
                                                                  "load_factor",
                                                                  "onset",
                                                                  "onset_omega",
                                                                  "unstable"};

// Lists one value for each shape or onset, in their order; empty if this kind has no such quantity.
// "unstable", for modes and eigenvalues, is one number.
std::vector<double> list_found_values(const ShapesRecord& record, std::string_view quantity);
// Lists load_factor for each critical point, the main path's first.
std::vector<double> list_found_values(const PathRecord& record, std::string_view quantity);
// Lists "omega" or "growth" of each mode of a sweep at one of its values; empty at any other value.
std::vector<double> list_values_at(const SweepRecord& record, std::string_view quantity, double value);

// Whether stages of this kind have the quantity; without a sweep, and with one.
bool has_found_quantity(std::string_view kind, bool sweeps, std::string_view quantity);

}  // namespace gxrod
