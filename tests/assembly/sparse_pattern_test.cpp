#include "assembly/sparse_pattern.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "assembly/held_nodes.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

std::set<std::pair<std::int64_t, std::int64_t>> entries_of(const SparsePattern& pattern) {
    std::set<std::pair<std::int64_t, std::int64_t>> entries;
    for (std::int64_t column = 0; column < pattern.size(); ++column) {
        for (std::int64_t k = pattern.column_starts[column]; k < pattern.column_starts[column + 1]; ++k) {
            entries.emplace(pattern.rows[k], column);
        }
    }
    return entries;
}

// Nodes 0–1–2 in a chain, 2–4 by another element, 3 alone; 0 clamped in position and node 4 a hinge.
const std::vector<HeldComponents> held{
    {true, true, true}, {}, {}, {}, {false, false, false, true, true, false}};
const std::vector<NodeGroup> groups{{0, 1}, {1, 2}, {3}, {4, 2}};

}  // namespace

TEST_CASE("the pattern couples exactly the free unknowns of each group", "[assembly]") {
    const HeldNodes nodes(held);
    const EquationNumbers& equations = nodes.equations;
    const SparsePattern pattern = compute_pattern(equations, groups);
    REQUIRE(pattern.size() == equations.count());
    std::set<std::pair<std::int64_t, std::int64_t>> expected;
    for (const NodeGroup& group : groups) {
        for (const int a : group) {
            for (const int b : group) {
                for (const auto row : equations.of_node(a)) {
                    for (const auto column : equations.of_node(b)) {
                        if (row >= 0 && column >= 0) expected.emplace(row, column);
                    }
                }
            }
        }
    }
    const auto entries = entries_of(pattern);
    CHECK(entries == expected);
    CHECK(static_cast<std::int64_t>(entries.size()) == pattern.nonzeros());  // none twice
    for (const auto& [row, column] : entries) CHECK(entries.contains({column, row}));
}

TEST_CASE("rows ascend within a column and a slot is their place", "[assembly]") {
    const HeldNodes nodes(held);
    const SparsePattern pattern = compute_pattern(nodes.equations, groups);
    for (std::int64_t column = 0; column < pattern.size(); ++column) {
        for (std::int64_t k = pattern.column_starts[column]; k < pattern.column_starts[column + 1]; ++k) {
            if (k > pattern.column_starts[column]) CHECK(pattern.rows[k - 1] < pattern.rows[k]);
            CHECK(pattern.slot(pattern.rows[k], column) == k);
        }
    }
}
