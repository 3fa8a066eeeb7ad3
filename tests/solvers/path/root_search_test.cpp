#include "solvers/path/root_search.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("a root is found to the tolerance, and was evaluated last", "[solvers]") {
    double last = 0.0;
    int evaluations = 0;
    const auto cube = [&](double x) {
        last = x;
        ++evaluations;
        return x * x * x - 2.0;
    };
    const double root = find_root({0.0, -2.0, 2.0, 6.0}, {1e-13, 0.0, 50}, cube);
    CHECK(std::abs(root - std::cbrt(2.0)) < 1e-12);
    CHECK(root == last);
    CHECK(evaluations < 16);
}

TEST_CASE("a search ends where the function cannot be evaluated", "[solvers]") {
    CHECK(std::isnan(find_root({0.0, -1.0, 1.0, 1.0}, {1e-9, 0.0, 50}, [](double) { return std::nan(""); })));
}
