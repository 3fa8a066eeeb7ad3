#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gxrod {

// A name of a profile taken apart: "L 45x45x4.5" has the letters L and three numbers.
struct ProfileName {
    std::string letters;          // before the first number, in capitals
    std::vector<double> numbers;  // whole numbers and fractions too: 1-3/8 is one
    std::string rest;             // letters after the first number, without those between numbers: HOT
    bool operator==(const ProfileName&) const = default;
};

// Takes a name apart: "HE 200 A" is HEA 200, and "L 100x10" is L 100x100x10.
ProfileName parse_profile_name(std::string_view name);

// Returns how far apart two names of a series are: the sum of the differences of their numbers; little more
// if the letters after them differ.
double measure_difference(const ProfileName& a, const ProfileName& b);

}  // namespace gxrod
