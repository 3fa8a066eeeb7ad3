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
    double uncertainty = 0.0;       // of the reference; 0: exact
    std::vector<double> value;
    double error = 0.0;  // as the study measures it
    double tolerance = 0.0;
    std::optional<double> order = {};  // with which the error fell, if it was refined

    bool passed() const { return error <= tolerance; }  // false if the error is NaN
};

// That an order was seen: at most `allowance` below the one that theory has.
Check make_order_check(const std::string& of, double expected, double observed, double allowance);

nlohmann::ordered_json to_json(const Check& check);

}  // namespace gxrod
