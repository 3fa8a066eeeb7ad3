#include "batch/cases/case_slices.hpp"

#include <numeric>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::vector<long> count_up(long first, long last) {
    std::vector<long> numbers(static_cast<std::size_t>(last - first + 1));
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

using Ranges = std::vector<CaseRange>;

}  // namespace

TEST_CASE("Slices have equal numbers of cases, give or take one", "[batch]") {
    CHECK(divide_cases(count_up(1, 9), {}, 3) == Ranges{{1, 3}, {4, 6}, {7, 9}});
    CHECK(divide_cases(count_up(1, 10), {}, 3) == Ranges{{1, 3}, {4, 6}, {7, 10}});
    CHECK(divide_cases(count_up(1, 2), {}, 5) == Ranges{{1, 1}, {2, 2}});
    CHECK(divide_cases(count_up(4, 6), {}, 0) == Ranges{{4, 6}});
    CHECK(divide_cases({}, {}, 3).empty());
}

TEST_CASE("A slice reaches over cases that are done, which it need not run", "[batch]") {
    CHECK(divide_cases({2, 3, 20, 31, 32, 90}, {}, 2) == Ranges{{2, 20}, {31, 90}});
}

TEST_CASE("A slice does not reach over cases that another has", "[batch]") {
    const Ranges taken{{10, 12}, {40, 50}};
    CHECK(divide_cases({2, 3, 20, 31, 32, 90}, taken, 2) == Ranges{{2, 3}, {20, 20}, {31, 32}, {90, 90}});
    // Next to it is not over it.
    CHECK(divide_cases({9, 13}, taken, 1) == Ranges{{9, 9}, {13, 13}});
    CHECK(divide_cases({7, 9}, taken, 1) == Ranges{{7, 9}});
    CHECK(divide_cases({13, 39}, taken, 1) == Ranges{{13, 39}});
}

TEST_CASE("Ranges are written as --only takes them", "[batch]") {
    CHECK(write_range({3, 7}) == "3..7");
    CHECK(write_range({3, 3}) == "3");
}

TEST_CASE("Numbers in ascending order become ranges", "[batch]") {
    const Ranges ranges = join_numbers({1, 2, 3, 7, 9, 10});
    CHECK(ranges == Ranges{{1, 3}, {7, 7}, {9, 10}});
    CHECK(join_numbers({}).empty());
    CHECK(contain(ranges, 2));
    CHECK(contain(ranges, 10));
    CHECK_FALSE(contain(ranges, 8));
}

}  // namespace gxrod::test
