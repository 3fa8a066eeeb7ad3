#include "batch/plan/plan.hpp"

#include <cmath>
#include <limits>

#include "batch/collector.hpp"
#include "batch/plans.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string head = "deck = \"deck.toml\"\n";

std::string faults_of_vary(const std::string& entry, const std::string& keys = "") {
    return PlanFiles(head + keys + "[vary]\n" + entry + "\n").faults();
}

std::string faults_of_collect(const std::string& entry) {
    return PlanFiles(head + "[vary]\n\"parameters.EI\" = [1.0, 2.0]\n[collect]\n" + entry + "\n").faults();
}

}  // namespace

TEST_CASE("Every key of a plan arrives", "[batch]") {
    const PlanFiles files(R"(deck = "deck.toml"
combine = "latin-hypercube"
count = 7
seed = 42
time_limit = 30
memory_limit = 2
[vary]
"parameters.EI" = { uniform = { from = 1, to = 2 } }
"parameters.load" = { normal = { mean = 1, deviation = 0.1, from = 0.5, to = 1.5 } }
"section.s.stiffness.GJ" = { lognormal = { mean = 500, deviation = 50 } }
"rod.r.elements" = [2, 4]
"section.s.stiffness.EA" = { from = 1e3, to = 1e5, count = 3, spacing = "log" }
[collect]
height = { history = "tip", quantity = "position", component = "z", take = "max" }
turn = { history = "tip", quantity = "quaternion", component = "w", at = 0.5, reference = 1.0 }
[collect.work]
ledger = "external_work"
take = "rms"
[keep]
results = "failed"
)");
    CHECK(files.faults().empty());
    const Plan plan = files.read();
    CHECK(plan.decks == std::vector<std::filesystem::path>{files.folder() / "deck.toml"});
    CHECK(plan.combination == Combination::latin_hypercube);
    CHECK(plan.count == 7);
    CHECK(plan.seed == 42);
    CHECK(plan.time_limit == 30.0);
    CHECK(plan.memory_limit == 2e9);
    CHECK(plan.keeping == Keeping::failed);

    REQUIRE(plan.variations.size() == 5);
    CHECK(plan.variations[0].key == "parameters.EI");
    CHECK(plan.variations[0].spread->kind == Spread::Kind::uniform);
    CHECK(plan.variations[0].spread->from == 1.0);
    CHECK(plan.variations[0].spread->to == 2.0);
    CHECK(plan.variations[1].spread->kind == Spread::Kind::normal);
    CHECK(plan.variations[1].spread->mean == 1.0);
    CHECK(plan.variations[1].spread->deviation == 0.1);
    CHECK(plan.variations[1].spread->from == 0.5);
    CHECK(plan.variations[1].spread->to == 1.5);
    CHECK(plan.variations[2].spread->kind == Spread::Kind::lognormal);
    CHECK(plan.variations[2].spread->from == -std::numeric_limits<double>::infinity());
    CHECK(plan.variations[3].values == std::vector<std::string>{"2", "4"});
    CHECK(plan.variations[4].values == std::vector<std::string>{"1000", "10000", "100000"});

    REQUIRE(plan.collections.size() == 3);
    CHECK(plan.collections[0].name == "height");
    CHECK(plan.collections[0].history == "tip");
    CHECK(plan.collections[0].quantity == "position");
    CHECK(plan.collections[0].component == Component::z);
    CHECK(plan.collections[0].take == Take::largest);
    CHECK_FALSE(plan.collections[0].at);
    CHECK(plan.collections[1].component == Component::w);
    CHECK(plan.collections[1].at == 0.5);
    CHECK(plan.collections[1].reference == 1.0);
    CHECK(plan.collections[2].history.empty());
    REQUIRE(plan.collections[2].ledger != nullptr);
    CHECK(plan.collections[2].ledger->name == std::string("external_work"));
    CHECK(plan.collections[2].take == Take::rms);
}

TEST_CASE("A plan has defaults", "[batch]") {
    const Plan plan = PlanFiles(head + "[vary]\n\"parameters.EI\" = [1.0]\n").read();
    CHECK(plan.combination == Combination::grid);
    CHECK(plan.keeping == Keeping::all);
    CHECK(plan.time_limit == std::numeric_limits<double>::infinity());
    CHECK_FALSE(plan.memory_limit);
    CHECK(plan.collections.empty());
}

TEST_CASE("What is wrong with a plan's keys is said at its place", "[batch]") {
    CHECK(PlanFiles("combine = \"grid\"\n[vary]\n\"a.b\" = [1]\n").faults() ==
          "plan.toml:1:1: deck: missing; expected text");
    CHECK(PlanFiles(head).faults() ==
          "plan.toml:1:1: vary: missing or empty; expected what differs from case to case");
    CHECK(PlanFiles(head + "combin = \"zip\"\n").faults() ==
          "plan.toml:1:1: vary: missing or empty; expected what differs from case to case\n"
          R"(plan.toml:2:1: combin: unknown key; did you mean "combine"?)");
    CHECK(PlanFiles(head + "[vary]\ntime_limit = 5\n").faults() ==
          "plan.toml:3:1: vary.\"time_limit\": time_limit is a key of the top level and must come before the "
          "first "
          "[table]; here it belongs to [vary]");
    CHECK(PlanFiles(head + "count = 5\n[vary]\ntitle = [\"a\"]\n").faults() ==
          R"(plan.toml:2:1: count: combine "grid" does not use this key; it is for latin-hypercube)");
    CHECK(PlanFiles(head + "time_limit = 0\n[vary]\ntitle = [\"a\"]\n").faults() ==
          "plan.toml:2:14: time_limit: expected a number greater than 0, found 0");
    CHECK(PlanFiles("deck = \"none.toml\"\n[vary]\n\"a.b\" = [1]\n").faults() ==
          "plan.toml:1:8: deck: there is no file none.toml; it is looked for from the plan's folder");
}

TEST_CASE("What is wrong with [vary] is said at its place", "[batch]") {
    CHECK(faults_of_vary("\"parameters.EI\" = []") ==
          "plan.toml:3:19: vary.\"parameters.EI\": an empty list; expected one value at least");
    CHECK(faults_of_vary("\"a..b\" = [1]") ==
          "plan.toml:3:1: vary.\"a..b\": not a key; expected one such as \"analysis.time_step\" or "
          "\"load[0].force\"");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 1, count = 3 }") ==
          "plan.toml:3:36: vary.\"parameters.EI\": an empty range: from and to are the same");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 0, to = 1, count = 3, spacing = \"log\" }") ==
          "plan.toml:3:28: vary.\"parameters.EI\": equal ratios need both ends positive, or both negative");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 2 }") ==
          "plan.toml:3:19: vary.\"parameters.EI\".count: missing; expected an integer from 2 to 1000000");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 2, count = 1 }") ==
          "plan.toml:3:47: vary.\"parameters.EI\".count: expected an integer from 2 to 1000000, found 1");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 2, count = 3, spacng = \"log\" }") ==
          "plan.toml:3:50: vary.\"parameters.EI\".spacng: unknown key; did you mean \"spacing\"?");
    CHECK(faults_of_vary("\"parameters.EI\" = { uniform = { from = 1, to = 2 } }") ==
          "plan.toml:3:19: vary.\"parameters.EI\": a distribution is drawn from with combine = "
          "\"latin-hypercube\" only; expected a list of values or { from, to, count }");
    CHECK(
        faults_of_vary("\"parameters.EI\" = { column = \"a\" }") ==
        "plan.toml:3:19: vary.\"parameters.EI\": a column is taken with combine = \"table\" only; expected a "
        "list of values or { from, to, count }");
    const std::string sampled = "combine = \"latin-hypercube\"\ncount = 3\n";
    CHECK(faults_of_vary("\"parameters.EI\" = { uniform = { from = 2, to = 1 } }", sampled) ==
          "plan.toml:5:48: vary.\"parameters.EI\": an empty range: from 2 to 1");
    CHECK(faults_of_vary("\"parameters.EI\" = { normal = { mean = 2, deviation = -1 } }", sampled) ==
          "plan.toml:5:54: vary.\"parameters.EI\".normal.deviation: expected a number greater than 0, found "
          "-1");
    CHECK(
        faults_of_vary("\"parameters.EI\" = { lognormal = { mean = 2, deviation = 1, to = -1 } }", sampled) ==
        "plan.toml:5:33: vary.\"parameters.EI\": nothing of the distribution lies from -inf to -1; its mean "
        "is 2, "
        "its deviation 1");
    CHECK(
        faults_of_vary("\"parameters.EI\" = { normal = { mean = 0, deviation = 1, from = 50 } }", sampled) ==
        "plan.toml:5:30: vary.\"parameters.EI\": nothing of the distribution lies from 50 to inf; its mean "
        "is 0, "
        "its deviation 1");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 2 }", sampled) ==
          "plan.toml:5:19: vary.\"parameters.EI\": a sample between two numbers is uniform = { from = …, to "
          "= … }");
    CHECK(faults_of_vary("parameters.EI = [1, 2]") ==
          "plan.toml:3:1: vary.\"parameters\": a key of the deck must be in quotes here: \"parameters.EI\" = "
          "…");
    // Of distributions that reach where they may not, one message for all samples.
    CHECK(
        faults_of_vary("\"section.s.stiffness.GJ\" = { normal = { mean = 1, deviation = 1 } }",
                       "combine = \"latin-hypercube\"\ncount = 20\n")
            .starts_with(
                "plan.toml:5:1: vary.\"section.s.stiffness.GJ\": expected a number greater than 0, found -"));
    CHECK(faults_of_vary("\"parameters.EI\" = [1, 2]\n\"parameters.load\" = [1, 2, 3]",
                         "combine = \"zip\"\n") ==
          "plan.toml:5:1: vary.\"parameters.load\": has 3 values where \"parameters.EI\" has 2; combine = "
          "\"zip\" takes them together");
    CHECK(faults_of_vary("\"parameters.EI\" = { from = 1, to = 2, count = 1001 }\n"
                         "\"parameters.load\" = { from = 1, to = 2, count = 1000 }") ==
          "plan.toml:1:1: makes 1001000 cases; 1000000 at most are run");
}

TEST_CASE("Keys and values that the deck does not take are errors before anything runs", "[batch]") {
    CHECK(faults_of_vary("\"parameters.EJ\" = [1.0]") ==
          "plan.toml:3:1: vary.\"parameters.EJ\": the deck has no parameter \"EJ\"; it has EI, load");
    CHECK(faults_of_vary("\"parameters.stiffness\" = [1.0]") ==
          "plan.toml:3:1: vary.\"parameters.stiffness\": the deck has no parameter \"stiffness\"; it has EI, "
          "load");
    CHECK(faults_of_vary("\"analysis.stepss\" = [1]") ==
          "plan.toml:3:1: vary.\"analysis.stepss\": unknown key; did you mean \"steps\"?");
    CHECK(faults_of_vary("\"load[1].force\" = [[0, 0, 1]]") ==
          "plan.toml:3:1: vary.\"load[1].force\": load[1]: no such element; valid are 0 to 0");
    CHECK(faults_of_vary("\"rod.r.elements\" = [2, 0, 4]") ==
          "plan.toml:3:1: vary.\"rod.r.elements\": expected an integer from 1 to 10000000, found 0 [case 2: "
          "rod.r.elements = 0]");
    // A fault elsewhere in the deck that some cases make.
    CHECK(faults_of_vary("\"parameters.EI\" = [1.0, -1.0, -1.0]") ==
          "deck.toml:6:63: section.s.stiffness.EIy: expected a number greater than 0, found \"EI\" = -1 "
          "[case 2 and 1 more: parameters.EI = -1.0]\n"
          "deck.toml:6:75: section.s.stiffness.EIz: expected a number greater than 0, found \"EI\" = -1 "
          "[case 2 and 1 more: parameters.EI = -1.0]");
}

TEST_CASE("A deck that is wrong in every case is reported once", "[batch]") {
    const std::string plan = head + "[vary]\n\"parameters.EI\" = [1.0, 2.0]\n";
    std::string deck = cantilever_deck;
    deck.replace(deck.find("elements = 2"), 12, "elements = 0");
    CHECK(PlanFiles(plan, deck).faults() ==
          "deck.toml:10:12: rod.r.elements: expected an integer from 1 to 10000000, found 0");
}

TEST_CASE("What is collected must be there", "[batch]") {
    CHECK(faults_of_collect(
              "a = { history = \"tp\", quantity = \"position\", component = \"x\", take = \"max\" }") ==
          "plan.toml:5:5: collect.a.history: the deck has no history \"tp\"; did you mean \"tip\"?");
    CHECK(faults_of_collect(
              "a = { history = \"middle\", quantity = \"position\", component = \"x\", take = \"max\" }") ==
          "plan.toml:5:5: collect.a.history: the deck has no history \"middle\"; it has \"tip\"");
    CHECK(faults_of_collect(
              "a = { history = \"tip\", quantity = \"force\", component = \"x\", take = \"max\" }") ==
          "plan.toml:5:5: collect.a.quantity: history \"tip\" of the deck does not record force; it has "
          "position, quaternion");
    CHECK(
        faults_of_collect("a = { history = \"tip\", quantity = \"position\", take = \"max\" }") ==
        "plan.toml:5:5: collect.a.component: position is a vector; expected component \"x\", \"y\", \"z\" or "
        "\"magnitude\"");
    CHECK(faults_of_collect("a = { history = \"tip\", quantity = \"quaternion\", component = \"magnitude\", "
                            "take = \"max\" }") ==
          "plan.toml:5:5: collect.a.component: quaternion is a quaternion; expected component \"w\", "
          "\"x\", \"y\" or \"z\"");
    CHECK(faults_of_collect("a = { ledger = \"strain_energy\", component = \"x\", take = \"max\" }") ==
          "plan.toml:5:5: collect.a.component: strain_energy is a single number, without components");
    CHECK(faults_of_collect("a = { ledger = \"strain_energy\", at = 2 }") ==
          "plan.toml:5:5: collect.a.at: 2 is after the end, 1");
    CHECK(faults_of_collect("a = { ledger = \"strain_energy\" }") ==
          "plan.toml:5:5: collect.a: missing; expected take or at or damage = { … } or range = { … }");
    CHECK(faults_of_collect("a = { take = \"max\" }") ==
          "plan.toml:5:5: collect.a: missing; expected history or ledger or stage");
    CHECK(faults_of_collect("a = { history = \"tip\", take = \"max\" }")
              .starts_with("plan.toml:5:5: collect.a.quantity: missing; expected one of \"position\", "));
    CHECK(faults_of_collect("steps = { ledger = \"strain_energy\", take = \"max\" }") ==
          "plan.toml:5:9: collect.steps: every table has a column of this name already; take another one");
}

TEST_CASE("Damage and equivalent ranges are read with their curves", "[batch]") {
    const PlanFiles files(head + R"([vary]
"parameters.EI" = [1.0]
[collect]
steel = { history = "tip", quantity = "position", component = "x", damage = { detail = 71, factor = 1.35 } }
glass = { ledger = "strain_energy", damage = { slope = 10, second_slope = 12, cycles = 1e6, at = 30, limit = 5, ultimate = 90, from = 0.5 } }
load = { ledger = "strain_energy", range = { slope = 4, cycles = 600 } }
)");
    const std::vector<Collection> collections = files.read().collections;
    REQUIRE(collections.size() == 3);
    CHECK(collections[0].fatigue->curve->endured_cycles(71.0 / 1.35) == Approx(2e6).epsilon(1e-13));
    const FatigueCount& glass = *collections[1].fatigue;
    CHECK(glass.curve->endured_cycles(60.0) == Approx(1e6 / 1024.0).epsilon(1e-13));
    CHECK(glass.curve->endured_cycles(15.0) == Approx(1e6 * 4096.0).epsilon(1e-13));
    CHECK(std::isinf(glass.curve->endured_cycles(5.0)));
    CHECK(glass.ultimate == 90.0);
    CHECK(glass.from == 0.5);
    CHECK(!collections[2].fatigue->curve);
    CHECK(describe(collections[0]) == "damage, detail category 71, of x of position of tip");
    CHECK(describe(collections[1]) ==
          "damage from t = 0.5 on, slope 10, 1000000 cycles at 30, of strain_energy");
    CHECK(describe(collections[2]) == "equivalent range, slope 4, 600 cycles, of strain_energy");
    CHECK(faults_of_collect("a = { ledger = \"strain_energy\", damage = { detail = 71, limit = 2 } }") ==
          "plan.toml:5:57: collect.a.damage.limit: goes with slope, and this table has detail");
    CHECK(
        faults_of_collect(
            "a = { ledger = \"strain_energy\", damage = { slope = 3, second_slope = 5, cycles = 1e6, at = 3, "
            "limit = 4 } }") ==
        "plan.toml:5:103: collect.a.damage.limit: expected lines for smaller and smaller ranges, down to the "
        "limit");
    CHECK(faults_of_collect(
              "a = { ledger = \"strain_energy\", range = { slope = 4, cycles = 600, from = 2 } }") ==
          "plan.toml:5:5: collect.a.range.from: 2 is after the end, 1");
    CHECK(faults_of_collect(
              "a = { ledger = \"strain_energy\", take = \"max\", range = { slope = 4, cycles = 1 } }") != "");
}

TEST_CASE("The columns of a table are checked", "[batch]") {
    const std::string plan = head + "combine = \"table\"\ntable = \"cases.csv\"\n";
    const auto faults = [&](const std::string& table, const std::string& vary = "") {
        const PlanFiles files(plan + vary);
        if (!table.empty()) files.write("cases.csv", table);
        return files.faults();
    };
    CHECK(faults("parameters.EI,parameters.load\n1.0,2.0\n3.0,4.0\n").empty());
    CHECK(faults("stiffness,extra\n1.0,2.0\n", "[vary]\n\"parameters.EI\" = { column = \"stiffness\" }\n")
              .empty());
    CHECK(faults("") ==
          "plan.toml:3:9: table: there is no file cases.csv; it is looked for from the plan's folder");
    CHECK(faults("parameters.EI;parameters.load\n1.0;2.0\n") ==
          "cases.csv:1: has one column (columns are separated by commas, not by semicolons)");
    CHECK(faults("parameters.EI,parameters.load\n1.0,\n2.0,3.0\n") ==
          "cases.csv:2: column \"parameters.load\": \"\": the expression is empty [case 1: parameters.EI = "
          "1.0, parameters.load = ]");
    CHECK(faults("stiffness\n1.0\n2.0\n")
              .starts_with("cases.csv:1: column \"stiffness\": no key of the deck; name the "
                           "column after a key, or give it to one: [vary] "
                           "\"parameters.stiffness\" = { column = \"stiffness\" }"));
    CHECK(faults("parameters.EI\n") ==
          "cases.csv: has no rows (expected a line with the names of the columns, then a row for each case)");
    CHECK(faults("parameters.EI,parameters.load\n1.0,2.0\n\n3.0\n") ==
          "cases.csv:4: has 1 fields where the first line names 2 columns");
    CHECK(faults("parameters.EI,parameters.EI\n1.0,2.0\n") ==
          "cases.csv:1: has two columns \"parameters.EI\"");
    CHECK(faults("a b,parameters.EI\n1.0,2.0\n") ==
          "plan.toml:3:9: table: column \"a b\" is no key of a deck; [vary] can say which key takes it");
    CHECK(faults("stiff,load\n1.0,2.0\n", "[vary]\n\"parameters.EI\" = { column = \"stif\" }\n") ==
          "plan.toml:5:1: vary.\"parameters.EI\": cases.csv has no column \"stif\"; it has \"stiff\", "
          "\"load\"; did you mean \"stiff\"?");
    CHECK(faults("stiff\n1.0\n", "[vary]\n\"parameters.EI\" = [1.0]\n") ==
          "plan.toml:5:19: vary.\"parameters.EI\": with combine = \"table\" the values are in the table; "
          "expected { column = \"…\" }");
    CHECK(faults("stiff\n1.0\n", "[vary]\n\"parameters.EI\" = { from = 1, to = 2, count = 2 }\n") ==
          "plan.toml:5:19: vary.\"parameters.EI\": with combine = \"table\" the values are in the table; "
          "expected { column = \"…\" }");
}

TEST_CASE("What would be lost among keys and columns is an error", "[batch]") {
    CHECK(faults_of_vary("\"rod.r.elements\" = [2]\n\"rod.\\\"r\\\".elements\" = [3]") ==
          "plan.toml:4:1: vary.\"rod.\"r\".elements\": \"rod.r.elements\" is varied too, and has the same "
          "value");
    CHECK(
        faults_of_vary("\"load[0].force[2]\" = [1.0]\n\"load[0].force\" = [[0, 0, 1]]") ==
        "plan.toml:4:1: vary.\"load[0].force\": \"load[0].force[2]\" is varied too, and has the same value");
    CHECK(PlanFiles(
              head +
              "[vary]\ntitle = [\"a\"]\n[collect]\ntitle = { ledger = \"strain_energy\", take = \"max\" }\n")
              .faults() ==
          "plan.toml:5:9: collect.title: [vary] has a column of this name already; take another one");
}

TEST_CASE("What gxrod check calls an error is one of the plan", "[batch]") {
    std::string deck = cantilever_deck;
    const std::size_t at = deck.find("fix = ");
    deck.replace(at, deck.find('\n', at) - at, "fix = [\"x\"]");
    CHECK(PlanFiles(head + "[vary]\n\"parameters.EI\" = [1.0, 2.0]\n", deck)
              .faults()
              .starts_with("deck.toml: rod r can "));
}

TEST_CASE("A plan is distinguished from a deck", "[batch]") {
    const PlanFiles files(head + "[vary]\n\"parameters.EI\" = [1.0]\n");
    CHECK(is_plan(files.folder() / "plan.toml"));
    CHECK_FALSE(is_plan(files.folder() / "deck.toml"));
    files.write("other.toml", "title = \"Nothing\"\n");
    CHECK_THROWS_WITH(is_plan(files.folder() / "other.toml"),
                      (files.folder() / "other.toml").string() +
                          ": is neither a plan (deck, [vary]) nor a deck ([analysis])");
}

}  // namespace gxrod::test
