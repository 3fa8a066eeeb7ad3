#include <cmath>

#include "deck/text/fault.hpp"
#include "tools/catch.hpp"
#include "verification/benchmark.hpp"

using namespace gxrod;

namespace {

const std::string sound = R"(sentence = "A beam"
kind = "statics"
source = "exact"
[[value]]
history  = "tip"
quantity = "position"
time     = 0.5
is       = [1, nan, 2.5]
uncertainty = 1e-9
[[value]]
ledger   = true
quantity = "energy"
time     = "all"
is       = 3
scale    = 10
[[refinement]]
name      = "finer"
set       = ["rod.r.order=2"]
rows      = [["rod.r.elements=2"], ["rod.r.elements=4", "analysis.steps=3"]]
order     = 4
tolerance = 1e-3
floor     = 1e-9
)";

// What is said of the sound text with one change.
std::string find_fault(const std::string& what, const std::string& instead) {
    std::string text = sound;
    text.replace(text.find(what), what.size(), instead);
    try {
        read_benchmark("beam", "", text);
    } catch (const DeckError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a reference says what a deck must give and how it is refined", "[verification]") {
    const Benchmark benchmark = read_benchmark("beam", "the deck", sound);
    CHECK(benchmark.name == "beam");
    CHECK(benchmark.deck == "the deck");
    CHECK(benchmark.sentence == "A beam");
    CHECK(benchmark.kind == "statics");
    CHECK(benchmark.source == "exact");
    REQUIRE(benchmark.values.size() == 2);
    const BenchmarkValue& position = benchmark.values[0];
    CHECK(position.source == "tip");
    CHECK(position.quantity == "position");
    CHECK(position.time == 0.5);
    REQUIRE(position.reference.size() == 3);
    CHECK(position.reference[0] == 1.0);
    CHECK(std::isnan(position.reference[1]));
    CHECK(position.reference[2] == 2.5);
    CHECK(position.scale == 1.0);
    CHECK(position.uncertainty == 1e-9);
    CHECK_FALSE(position.is_constant);
    const BenchmarkValue& energy = benchmark.values[1];
    CHECK(energy.source == "ledger");
    CHECK(energy.is_constant);
    CHECK(energy.uncertainty == 0.0);
    CHECK(energy.reference == std::vector{3.0});
    CHECK(energy.scale == 10.0);
    REQUIRE(benchmark.refinements.size() == 1);
    const Refinement& refinement = benchmark.refinements[0];
    CHECK(refinement.name == "finer");
    REQUIRE(refinement.rows.size() == 2);
    CHECK(refinement.rows[0] == std::vector<std::string>{"rod.r.order=2", "rod.r.elements=2"});
    CHECK(refinement.rows[1] ==
          std::vector<std::string>{"rod.r.order=2", "rod.r.elements=4", "analysis.steps=3"});
    CHECK(refinement.order == 4.0);
    CHECK(refinement.tolerance == 1e-3);
    CHECK(refinement.floor == 1e-9);
}

TEST_CASE("a value is of the end, load factor 1, unless it says when", "[verification]") {
    std::string text = sound;
    text.replace(text.find("time     = \"all\""), 16, "");
    const Benchmark benchmark = read_benchmark("beam", "", text);
    CHECK(benchmark.values[1].time == 1.0);
    CHECK_FALSE(benchmark.values[1].is_constant);
}

TEST_CASE("each fault of a reference is reported with its place", "[verification]") {
    const auto says = [](const std::string& what, const std::string& instead, const std::string& expected) {
        CHECK_THAT(find_fault(what, instead), Catch::Contains(expected));
    };
    says("sentence = \"A beam\"", "sentence = 3", "beam/reference.toml:1:1: sentence: expected a text");
    says("scale    = 10",
         "size = 10",
         "beam/reference.toml:15:1: size: unknown key; known here: history, ledger");
    says("quantity = \"energy\"", "", "quantity: expected a text");
    says("is       = 3", "", "is: expected a number or an array of them");
    says("is       = 3", "is = \"3\"", "beam/reference.toml:14:6: is: expected a number");
    says("[1, nan, 2.5]", "[1, 2, 3, 4, 5]", "is: expected at most 4 numbers");
    says("[\"rod.r.order=2\"]", "\"rod.r.order=2\"", "set: expected an array of texts");
    says("[\"rod.r.order=2\"]", "[2]", "set: expected a text \"KEY=VALUE\"");
    says("[[\"rod.r.elements=2\"], [\"rod.r.elements=4\", \"analysis.steps=3\"]]",
         "[]",
         "rows: expected an array of arrays of \"KEY=VALUE\"");
    says("kind = \"statics\"", "", "kind: expected a text");
    says("source = \"exact\"", "", "source: expected a text");
    says("time     = \"all\"", "time = \"always\"", "time: expected a number");
    says("tolerance = 1e-3", "", "refinement: one must have a tolerance, for the values to be held to");
    says("order     = 4", "order = true", "order: expected a number");
}
