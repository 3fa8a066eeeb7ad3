#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cross_section/cross_section.hpp"
#include "model/model.hpp"

// Collects what gxrod section prints and writes of one section.
namespace gxrod {

// Describes the largest stress of resultants (N, Vy, Vz, T, My, Mz), and how near they are to failure, in
// lines.
std::string describe_stress(const CrossSection& section, const Vec6& resultants);

// Solves a section again with an order one higher and describes how much each constant changes, in lines.
std::string describe_estimate(const CrossSection& section);

nlohmann::ordered_json section_json(const Section& section, const std::optional<Vec6>& resultants);

// Returns the stresses of resultants at all points, as CSV.
std::string write_stress_csv(const CrossSection& section, const Vec6& resultants);

}  // namespace gxrod
