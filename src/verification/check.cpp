#include "verification/check.hpp"

#include <cmath>

namespace gxrod {

namespace {

// As JSON has no such numbers: null where nothing is compared.
nlohmann::ordered_json to_json(const std::vector<double>& numbers) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const double number : numbers)
        json.push_back(std::isfinite(number) ? nlohmann::ordered_json(number) : nullptr);
    return json;
}

}  // namespace

Check make_order_check(const std::string& of, double expected, double observed, double allowance) {
    // A fall that is faster than theory is no error.
    const double shortfall = std::isnan(observed) ? observed : std::fmax(0.0, expected - observed);
    return {"order of the error; " + of, {expected}, 0.0, {observed}, shortfall, allowance};
}

nlohmann::ordered_json to_json(const Check& check) {
    return {{"what", check.what},
            {"reference", to_json(check.reference)},
            {"uncertainty", check.uncertainty},
            {"value", to_json(check.value)},
            {"error", check.error},
            {"tolerance", check.tolerance},
            {"order", check.order ? nlohmann::ordered_json(*check.order) : nullptr},
            {"passed", check.passed()}};
}

}  // namespace gxrod
