#include "batch/cases/case_list.hpp"

#include <algorithm>

#include "batch/plans.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Texts = std::vector<std::string>;

Plan read_vary(const std::string& keys, const std::string& vary) {
    return PlanFiles("deck = \"deck.toml\"\n" + keys + "[vary]\n" + vary).read();
}

}  // namespace

TEST_CASE("A grid runs every combination, the last key fastest", "[batch]") {
    const Plan plan = read_vary("", "\"a.b\" = [1, 2]\n\"c\" = [\"x y\", [1, 2.5], true]\n");
    const CaseList cases(plan);
    REQUIRE(cases.count() == 6);
    CHECK(cases.parameter_names() == Texts{"a.b", "c"});
    CHECK(cases.overrides(1) == Texts{"a.b=1", "c=\"x y\""});
    CHECK(cases.overrides(2) == Texts{"a.b=1", "c=[1, 2.5]"});
    CHECK(cases.overrides(3) == Texts{"a.b=1", "c=true"});
    CHECK(cases.overrides(4) == Texts{"a.b=2", "c=\"x y\""});
    CHECK(cases.overrides(6) == Texts{"a.b=2", "c=true"});
    CHECK(cases.parameters(4) == Texts{"2", "x y"});
    CHECK(cases.describe(5) == "a.b = 2, c = [1, 2.5]");
}

TEST_CASE("Zip takes values together", "[batch]") {
    const Plan plan = read_vary("combine = \"zip\"\n", "a = [1, 2]\nb = { from = 1, to = 0.5, count = 2 }\n");
    const CaseList cases(plan);
    REQUIRE(cases.count() == 2);
    CHECK(cases.overrides(1) == Texts{"a=1", "b=1"});
    CHECK(cases.overrides(2) == Texts{"a=2", "b=0.5"});
}

TEST_CASE("A table has a row for each case; cells are as --set takes them", "[batch]") {
    const PlanFiles files("deck = \"deck.toml\"\ncombine = \"table\"\ntable = \"t.csv\"\n");
    files.write("t.csv", "a,load[0].force\n1.5,\"[0, 0, 1]\"\r\nEI/2,\"[0, 0, \"\"x\"\"]\"\n");
    const Plan plan = files.read();
    const CaseList cases(plan);
    REQUIRE(cases.count() == 2);
    CHECK(cases.overrides(1) == Texts{"a=1.5", "load[0].force=[0, 0, 1]"});
    CHECK(cases.overrides(2) == Texts{"a=EI/2", "load[0].force=[0, 0, \"x\"]"});
    CHECK(cases.parameters(2) == Texts{"EI/2", "[0, 0, \"x\"]"});
}

TEST_CASE("A Latin hypercube draws from distributions and from lists alike", "[batch]") {
    const Plan plan = read_vary("combine = \"latin-hypercube\"\ncount = 10\nseed = 3\n",
                                "a = { uniform = { from = 5, to = 6 } }\nb = [\"p\", \"q\"]\n");
    const CaseList cases(plan);
    REQUIRE(cases.count() == 10);
    std::vector<double> drawn;
    long first_words = 0;
    for (long number = 1; number <= 10; ++number) {
        const Texts values = cases.parameters(number);
        drawn.push_back(std::stod(values[0]));
        first_words += values[1] == "p" ? 1 : 0;
        CHECK(cases.overrides(number)[0] == "a=" + values[0]);
    }
    CHECK(first_words == 5);
    std::sort(drawn.begin(), drawn.end());
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(drawn[i] > 5.0 + 0.1 * static_cast<double>(i));
        CHECK(drawn[i] < 5.1 + 0.1 * static_cast<double>(i));
    }
}

TEST_CASE("A list of decks is a case each", "[batch]") {
    const Plan plan = plan_of_decks({"a.toml", "b/c.toml"});
    const CaseList cases(plan);
    REQUIRE(cases.count() == 2);
    CHECK(cases.parameter_names() == Texts{"deck"});
    CHECK(cases.parameters(2) == Texts{"b/c.toml"});
    CHECK(cases.overrides(2).empty());
    CHECK(cases.deck(2) == 1);
}

}  // namespace gxrod::test
