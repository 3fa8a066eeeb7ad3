#include "study/error_estimate.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// Solutions 1 + C h^p at two samples, C and 3 C, with h = 1, 1/2, 1/4: their differences.
std::vector<std::vector<double>> differences_of(double order, double c, int levels) {
    std::vector<std::vector<double>> differences;
    for (int level = 0; level < levels; ++level) {
        const double fall = std::pow(2.0, -order * level) - std::pow(2.0, -order * (level + 1));
        differences.push_back({c * fall, 3.0 * c * fall});
    }
    return differences;
}

}  // namespace

TEST_CASE("order and size of errors C h^p are found exactly", "[study]") {
    for (const double order : {1.0, 2.0, 3.3, 4.0}) {
        const ErrorEstimate estimate = estimate_error(differences_of(order, 0.1, 2), 4.0, 1e-12);
        REQUIRE(estimate.order);
        CHECK(*estimate.order == Approx(order));
        CHECK(estimate.errors[0] == Approx(0.1));
        CHECK(estimate.largest() == Approx(0.3));
        CHECK(estimate.is_supported);
    }
}

TEST_CASE("with one refinement the method's order is taken for granted", "[study]") {
    const ErrorEstimate estimate = estimate_error(differences_of(2.0, 0.1, 1), 2.0, 1e-12);
    CHECK_FALSE(estimate.order);
    CHECK_FALSE(estimate.is_supported);
    CHECK(estimate.largest() == Approx(0.3));
}

TEST_CASE("a fall faster than the method's is not believed", "[study]") {
    // d = 1 then 1/64: of order 6, of a method of order 2: the rest is 1/64 · 4/3.
    const ErrorEstimate estimate = estimate_error({{1.0}, {1.0 / 64.0}}, 2.0, 1e-12);
    CHECK(*estimate.order == Approx(6.0));
    CHECK(estimate.largest() == Approx(1.0 + 4.0 / 3.0 / 64.0));
}

TEST_CASE("differences that do not fall are said to support nothing", "[study]") {
    const ErrorEstimate estimate = estimate_error({{1.0}, {0.9}}, 2.0, 1e-12);
    CHECK_FALSE(estimate.is_supported);
    CHECK(estimate.largest() > 1.9);
}

TEST_CASE("differences of round-off show no order and raise no warning", "[study]") {
    const ErrorEstimate estimate = estimate_error({{1e-13}, {2e-13}}, 2.0, 1e-12);
    CHECK_FALSE(estimate.order);
    CHECK(estimate.is_supported);
    CHECK(estimate.largest() == 1e-13);
    CHECK(estimate.is_round_off);
}

TEST_CASE("a fall into round-off shows no order, and raises no warning", "[study]") {
    // The last two would be of orders 0.2 and 1.3, but for what is round-off in the second difference.
    for (const auto& [first, second] : {std::pair{1e-3, 1e-15}, {1.1e-12, 0.9e-12}, {2.4e-12, 1e-12}}) {
        const ErrorEstimate estimate = estimate_error({{first}, {second}}, 2.0, 1e-12);
        CHECK_FALSE(estimate.order);
        CHECK(estimate.is_supported);
        CHECK_FALSE(estimate.is_round_off);
        CHECK(estimate.largest() == Approx(first + second * 4.0 / 3.0));
    }
    CHECK(*estimate_error({{2.4e-12}, {1.2e-12}}, 2.0, 1e-12).order == Approx(1.0));
}

TEST_CASE("what only the finest run meets is not taken for round-off", "[study]") {
    const ErrorEstimate estimate = estimate_error({{1e-15}, {1.0}}, 2.0, 1e-12);
    CHECK_FALSE(estimate.is_supported);
    CHECK_FALSE(estimate.is_round_off);
    CHECK(estimate.largest() == 1.0);
}

TEST_CASE("without runs nothing is known", "[study]") {
    const ErrorEstimate estimate = estimate_error({}, 2.0, 1e-12);
    CHECK_FALSE(estimate.is_known());
    CHECK(estimate.largest() == 0.0);
}
