#include "numerics/lagrange.hpp"

#include "tools/catch.hpp"
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

}  // namespace

TEST_CASE("shape functions interpolate polynomials", "[numerics]") {
    check_shape_functions<2>();
    check_shape_functions<3>();
    check_shape_functions<4>();
    check_shape_functions<5>();
}
