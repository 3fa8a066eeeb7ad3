#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cross_section/profiles/profile_shape.hpp"

// Standard profiles, by name.
namespace gxrod {

struct CatalogueProfile {
    std::string name;  // "IPE 200", as messages have it
    ProfileShape shape;
    double unit;  // of its lengths, in mm
};

// Returns all profiles.
std::span<const CatalogueProfile> list_profiles();

// Finds a profile. In names, blanks, capitals, and which of x, × and * stands between numbers do not matter;
// "HE 200 A" is HEA 200, "L 100x10" is L 100x100x10, "SHS 100x5 hot" is SHS 100x100x5 hot.
const CatalogueProfile* find_profile(std::string_view name);

// Returns names near one that is not in the catalogue: of the same series, by their numbers. Without a series
// of that name, nothing.
std::vector<std::string> find_nearest_profiles(std::string_view name);

// Returns the names of all series: IPE, HEA, ….
std::vector<std::string> list_series();

}  // namespace gxrod
