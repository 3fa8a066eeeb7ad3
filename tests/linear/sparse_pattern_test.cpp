#include "linear/sparse_pattern.hpp"
#include "assembly/node_groups.hpp"
#include "tools/catch.hpp"

#include <set>

#include "assembly/held_nodes.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

std::set<std::pair<std::int64_t, std::int64_t>> entries_of(const SparsePattern& pattern) {
    std::set<std::pair<std::int64_t, std::int64_t>> entries;
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t) {
        CHECK(entries.emplace(row, column).second);
    });
    return entries;
}

// Nodes 0–1–2 in a chain, 2–4 by another element, 3 alone; 0 clamped in position and node 4 a hinge.
const std::vector<HeldComponents> held{
    {true, true, true}, {}, {}, {}, {false, false, false, true, true, false}};
const std::vector<NodeGroup> groups{{0, 1}, {1, 2}, {3}, {4, 2}};

}  // namespace

TEST_CASE("the pattern couples exactly the free unknowns of each group", "[linear]") {
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

TEST_CASE("rows ascend within a column and a slot is their place", "[linear]") {
    const HeldNodes nodes(held);
    const SparsePattern pattern = compute_pattern(nodes.equations, groups);
    std::int64_t next = 0;
    for (std::int64_t column = 0; column < pattern.size(); ++column) {
        std::int64_t last = -1;
        pattern.visit_column(column, [&](std::int64_t row, std::int64_t slot) {
            CHECK(row > last);
            last = row;
            CHECK(slot == next++);
            CHECK(pattern.slot(row, column) == slot);
        });
    }
    CHECK(next == pattern.nonzeros());
}

TEST_CASE("columns with the same rows are one block, whose rows lie in runs", "[linear]") {
    const std::vector<std::int64_t> ends{0, 1, 4}, middle{2, 3}, none;
    SparsePattern pattern;
    CHECK(pattern.size() == 0);
    CHECK(pattern.block_count() == 0);
    pattern.add_columns(1, ends);
    pattern.add_columns(1, ends);
    pattern.add_columns(2, middle);
    pattern.add_columns(0, ends);
    pattern.add_columns(1, none);
    REQUIRE(pattern.block_count() == 3);
    CHECK(pattern.size() == 5);
    CHECK(pattern.nonzeros() == 2 * 3 + 2 * 2);
    const SparsePattern::Block first = pattern.block(0);
    CHECK(first.columns == 2);
    CHECK(first.stride == 3);
    REQUIRE(first.runs.size() == 2);
    CHECK(first.runs[0].count == 2);
    CHECK(first.runs[1].first == 4);
    CHECK(first.runs[1].before == 2);
    const SparsePattern::Block second = pattern.block_of(3);
    CHECK(second.first_column == 2);
    CHECK(second.first_entry == 6);
    CHECK(pattern.block_of(4).runs.empty());
    const CompressedColumns columns(pattern);
    CHECK(columns.column_starts == std::vector<std::int64_t>{0, 3, 6, 8, 10, 10});
    CHECK(columns.rows == std::vector<std::int64_t>{0, 1, 4, 0, 1, 4, 2, 3, 2, 3});
}
