#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gxrod {

// A number or vector of a study and its reference: a line of the table of `gxrod verify --all`.
struct Check {
    std::string what;               // "position of tip, t = 1"
    std::vector<double> reference;  // a NaN entry is not compared
    double uncertainty = 0.0;       // uncertainty of the reference; 0: exact
    std::vector<double> value;
    double error = 0.0;  // as the study measures it
    double tolerance = 0.0;
    std::optional<double> order = {};  // observed order of the error, if the study refines

    bool passed() const { return error <= tolerance; }  // false if the error is NaN
};

// Makes a check that the observed order is at most `allowance` below the theoretical one.
Check make_order_check(const std::string& of, double expected, double observed, double allowance);

nlohmann::ordered_json to_json(const Check& check);

}  // namespace gxrod
