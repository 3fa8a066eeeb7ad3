#include "deck/expressions/use_order.hpp"

#include "tools/catch.hpp"

namespace gxrod {

using Names = std::vector<std::string>;

TEST_CASE("Names come after those that they use", "[deck]") {
    const UseOrder order =
        find_use_order({"a", "b", "c", "d"}, {{"a", {"c", "d"}}, {"b", {}}, {"c", {"b"}}, {"d", {"b", "c"}}});
    CHECK(order.names == Names{"b", "c", "d", "a"});
    CHECK(order.cycles.empty());
    CHECK(order.in_cycle.empty());
}

TEST_CASE("Cycles are found, each once", "[deck]") {
    const UseOrder order =
        find_use_order({"x", "a", "b", "c", "s"},
                       {{"x", {"a"}}, {"a", {"b"}}, {"b", {"c"}}, {"c", {"a", "x"}}, {"s", {"s"}}});
    CHECK(order.cycles == std::vector<Names>{{"a", "b", "c"}, {"x", "a", "b", "c"}, {"s"}});
    CHECK(order.in_cycle == std::set<std::string>{"x", "a", "b", "c", "s"});
    const UseOrder onto = find_use_order({"x", "a"}, {{"x", {"a"}}, {"a", {"a"}}});
    CHECK(onto.cycles == std::vector<Names>{{"a"}});
    CHECK(onto.in_cycle == std::set<std::string>{"a"});
}

}  // namespace gxrod
