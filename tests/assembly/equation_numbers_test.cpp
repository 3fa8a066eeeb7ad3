#include "assembly/equation_numbers.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;

TEST_CASE("equations are numbered node by node, held components left out", "[assembly]") {
    const std::vector<FixedComponents> fixed{{true, true, true, false, false, false},
                                             {},
                                             {true, true, true, true, true, true},
                                             {false, true, false, true, true, false}};
    const EquationNumbers equations(fixed);
    CHECK(equations.count() == 3 + 6 + 0 + 3);
    CHECK(equations.of_node(0) == std::array<std::int64_t, 6>{-1, -1, -1, 0, 1, 2});
    CHECK(equations.of_node(1) == std::array<std::int64_t, 6>{3, 4, 5, 6, 7, 8});
    CHECK(equations.of_node(2) == std::array<std::int64_t, 6>{-1, -1, -1, -1, -1, -1});
    CHECK(equations.of_node(3) == std::array<std::int64_t, 6>{9, -1, 10, -1, -1, 11});
    CHECK(equations.unknown(10).node == 3);
    CHECK(equations.unknown(10).component == 2);
    for (std::int64_t equation = 0; equation < equations.count(); ++equation) {
        const auto& [node, component] = equations.unknown(equation);
        CHECK(equations.of_node(node)[component] == equation);
    }
}

TEST_CASE("a model that is held everywhere has no equations", "[assembly]") {
    const EquationNumbers equations({{true, true, true, true, true, true}});
    CHECK(equations.count() == 0);
    CHECK(equations.unknowns().empty());
}
