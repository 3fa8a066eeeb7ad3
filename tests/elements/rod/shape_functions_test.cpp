#include "elements/rod/shape_functions.hpp"

#include <catch2/catch.hpp>

#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

template <int Nodes>
void check_shape_functions() {
    INFO(Nodes << " nodes");
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    CHECK(at[0] == -1.0);
    CHECK(at[Nodes - 1] == 1.0);
    for (int i = 0; i < Nodes; ++i) {
        CHECK(compute_shape_functions<Nodes>(at[i]).isApprox(NodeValues<Nodes>::Unit(i), 1e-15));
    }
    for (const double xi : {-1.0, -0.83, -0.21, 0.0, 0.4, 0.77, 1.0}) {
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
        const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
        CHECK(shape.sum() == Approx(1.0).epsilon(1e-14));
        CHECK(std::abs(slope.sum()) < 1e-14);
        // They interpolate every polynomial that their number allows.
        for (int power = 1; power < Nodes; ++power) {
            const NodeValues<Nodes> values = at.array().pow(power);
            CHECK(std::abs(shape.dot(values) - std::pow(xi, power)) < 1e-14);
            CHECK(std::abs(slope.dot(values) - power * std::pow(xi, power - 1)) < 1e-13);
        }
        const NodeValues<Nodes> difference =
            differentiate([&](double h) { return compute_shape_functions<Nodes>(xi + h); });
        CHECK((slope - difference).norm() < 1e-12);
    }
}

template <int Points>
void check_gauss_rule() {
    INFO(Points << " points");
    for (int power = 0; power <= 2 * Points; ++power) {
        double integral = 0.0;
        for (const auto& [xi, weight] : compute_gauss_rule<Points>())
            integral += weight * std::pow(xi, power);
        const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
        const double error = std::abs(integral - exact);
        if (power < 2 * Points) {
            CHECK(error < 1e-15);
        } else {
            CHECK(error > 5e-4);  // one degree more is beyond the rule
        }
    }
    const auto rule = compute_gauss_rule<Points>();
    for (int i = 1; i < Points; ++i) CHECK(rule[i].xi > rule[i - 1].xi);
}

}  // namespace

TEST_CASE("shape functions interpolate polynomials", "[elements][rod]") {
    check_shape_functions<2>();
    check_shape_functions<3>();
    check_shape_functions<4>();
    check_shape_functions<5>();
}

TEST_CASE("Gauss rules integrate polynomials exactly", "[elements][rod]") {
    check_gauss_rule<1>();
    check_gauss_rule<2>();
    check_gauss_rule<3>();
    check_gauss_rule<4>();
    check_gauss_rule<5>();
    check_gauss_rule<6>();
}
