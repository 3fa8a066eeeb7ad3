#include "deck/expressions/near_comparisons.hpp"

#include "deck/expressions/expression.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

bool holds(const std::string& condition) {
    return evaluate_constant(compare_nearly(condition), Symbols{}).value() != 0.0;
}

}  // namespace

TEST_CASE("Numbers that differ by round-off are equal", "[deck]") {
    CHECK(evaluate_constant("0.1 + 0.2 == 0.3", Symbols{}).value() == 0.0);
    CHECK(holds("0.1 + 0.2 == 0.3"));
    CHECK(holds("0.1 + 0.2 <= 0.3"));
    CHECK(holds("0.3 >= 0.1 + 0.2"));
    CHECK_FALSE(holds("0.1 + 0.2 != 0.3"));
    CHECK_FALSE(holds("0.1 + 0.2 > 0.3"));
    CHECK_FALSE(holds("0.3 < 0.1 + 0.2"));
    CHECK(holds("1e9 == 1e9 + 0.5"));
}

TEST_CASE("Numbers that differ by more are not", "[deck]") {
    CHECK_FALSE(holds("0.3 == 0.300001"));
    CHECK(holds("0.3 != 0.300001"));
    CHECK(holds("0.3 < 0.300001"));
    CHECK_FALSE(holds("0.3 >= 0.300001"));
    CHECK(holds("0.300001 > 0.3"));
    CHECK_FALSE(holds("0.300001 <= 0.3"));
}

TEST_CASE("Conditions keep their structure", "[deck]") {
    CHECK(holds("1 < 2 && (3 < 2 || min(0.1 + 0.2, 5) == 0.3)"));
    CHECK_FALSE(holds("1 < 2 && 3 < 2 || 0.1 + 0.2 != 0.3"));
    CHECK(holds("1 > 2 ? 0 : 0.1 + 0.2 == 0.3"));
    CHECK(holds("(0.1 + 0.2 == 0.3) + (1 == 2)"));
    CHECK(compare_nearly("2*x + 1") == "2*x+1");
}

}  // namespace gxrod::test
