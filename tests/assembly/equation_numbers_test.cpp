#include "assembly/equation_numbers.hpp"

#include "assembly/held_nodes.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("equations are numbered node by node, held components left out", "[assembly]") {
    const HeldNodes nodes({{true, true, true, false, false, false},
                           {},
                           {true, true, true, true, true, true},
                           {false, true, false, true, true, false}});
    const EquationNumbers& equations = nodes.equations;
    CHECK(equations.count() == 3 + 6 + 0 + 3);
    CHECK(equations.of_node(0) == std::array<std::int64_t, 6>{-1, -1, -1, 0, 1, 2});
    CHECK(equations.of_node(1) == std::array<std::int64_t, 6>{3, 4, 5, 6, 7, 8});
    CHECK(equations.of_node(2) == std::array<std::int64_t, 6>{-1, -1, -1, -1, -1, -1});
    CHECK(equations.of_node(3) == std::array<std::int64_t, 6>{9, -1, 10, -1, -1, 11});
    CHECK(equations.unknown(10).node == 3);
    CHECK(equations.unknown(10).component == 2);
    for (std::int64_t equation = 0; equation < equations.count(); ++equation) {
        const EquationNumbers::Unknown unknown = equations.unknown(equation);
        CHECK(equations.of_node(unknown.node)[unknown.component] == equation);
    }
}

TEST_CASE("a model that is held everywhere has no equations", "[assembly]") {
    const HeldNodes nodes({{true, true, true, true, true, true}});
    const EquationNumbers& equations = nodes.equations;
    CHECK(equations.count() == 0);
    CHECK(equations.count() == 0);
}

TEST_CASE("unknowns of a node are counted in the axes of its support", "[assembly]") {
    const Quat axes = RandomValues(91).rotation();
    const HeldNodes nodes({{false, true, false, true, true, false}, {}}, {axes});
    const EquationNumbers& equations = nodes.equations;
    REQUIRE(equations.count() == 3 + 6);
    Eigen::VectorXd solution(9);
    for (int i = 0; i < 9; ++i) solution[i] = 1.0 + i;
    Vec6 expected;
    expected << axes * Vec3(1.0, 0.0, 2.0), axes * Vec3(0.0, 0.0, 3.0);
    CHECK(relative_difference(equations.increment_of(0, solution), expected) < 1e-15);
    CHECK(equations.increment_of(1, solution) == solution.tail<6>());
    const Vec6 global = RandomValues(92).matrix<6, 1>();
    const Vec6 own = equations.to_own_axes(0, global);
    CHECK((own.head<3>() - axes.conjugate() * global.head<3>()).norm() < 1e-15);
    CHECK((own.tail<3>() - axes.conjugate() * global.tail<3>()).norm() < 1e-15);
    CHECK((equations.to_global_axes(0, own) - global).norm() < 1e-15);
    CHECK(equations.to_own_axes(1, global) == global);
    CHECK(equations.to_global_axes(1, global) == global);
}
