#include "batch/collector.hpp"

#include <cmath>
#include <numbers>

#include "batch/batch.hpp"
#include "batch/plans.hpp"
#include "deck/decks.hpp"
#include "run/run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// What is taken of sin t on unequal steps from 0 to 2 pi + 1.
double take_of_sine(Take take, std::optional<double> at = {}) {
    TakenNumber number(take, at);
    constexpr int steps = 4000;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const double time = (2.0 * std::numbers::pi + 1.0) * part * (0.5 + 0.5 * part);
        number.add(time, std::sin(time));
    }
    return number.value();
}

// A pinned-free column (P16) that is pressed, its tones, its factors and its path.
std::string column_deck() {
    return "[parameters]\nload = 1.0\n" + replaced(pressed_column_deck, "[-1, 0, 0]", "[\"-load\", 0, 0]") +
           R"([[stage]]
name = "tones"
kind = "modes"
count = 2
[[stage]]
name = "bend"
kind = "buckling"
[[stage]]
name = "press"
kind = "path"
until = { t = 3 }
)";
}

std::vector<double> collect(const std::string& collect, const std::string& deck = cantilever_deck) {
    const PlanFiles files(
        "deck = \"deck.toml\"\n[vary]\n\"parameters.load\" = [2.0]\n[keep]\nresults = \"none\"\n[collect]\n" +
            collect,
        deck);
    const Plan plan = files.read();
    const CaseList cases(plan);
    std::deque<DeckTemplate> decks;
    decks.emplace_back(plan.decks[0]);
    const std::vector<MeshDigests> meshes(1);
    return run_case({plan, cases, decks, meshes, files.folder()}, 1).row.collected;
}

}  // namespace

TEST_CASE("Numbers are taken over time, whatever the steps", "[batch]") {
    const double end = 2.0 * std::numbers::pi + 1.0;
    CHECK(take_of_sine(Take::least) == Approx(-1.0).epsilon(1e-6));
    CHECK(take_of_sine(Take::largest) == Approx(1.0).epsilon(1e-6));
    CHECK(take_of_sine(Take::largest_absolute) == Approx(1.0).epsilon(1e-6));
    CHECK(take_of_sine(Take::last) == std::sin(end));
    CHECK(take_of_sine(Take::mean) == Approx((1.0 - std::cos(end)) / end).epsilon(1e-6));
    const double square = 0.5 - std::sin(2.0 * end) / (4.0 * end);
    CHECK(take_of_sine(Take::rms) == Approx(std::sqrt(square)).epsilon(1e-6));
    CHECK(take_of_sine(Take::last, 0.7) == Approx(std::sin(0.7)).epsilon(1e-6));
    CHECK(take_of_sine(Take::last, 0.0) == 0.0);
    CHECK(std::isnan(take_of_sine(Take::last, 8.0)));
}

TEST_CASE("Mean, rms and values between steps are those of straight lines", "[batch]") {
    const auto take = [](Take kind, std::optional<double> at) {
        TakenNumber number(kind, at);
        number.add(1.0, 0.0);
        number.add(2.0, 3.0);
        number.add(5.0, -3.0);
        return number.value();
    };
    CHECK(take(Take::mean, {}) == Approx(1.5 / 4.0).epsilon(1e-15));
    CHECK(take(Take::rms, {}) == Approx(std::sqrt((3.0 + 9.0) / 4.0)).epsilon(1e-15));
    CHECK(take(Take::last, 1.5) == 1.5);
    CHECK(take(Take::last, 2.0) == 3.0);
    CHECK(take(Take::last, 3.5) == Approx(0.0).margin(1e-15));
    CHECK(take(Take::last, 5.0) == -3.0);
    CHECK(take(Take::largest_absolute, {}) == 3.0);
}

TEST_CASE("Numbers of what stages find are collected", "[batch][stages]") {
    const std::vector<double> found = collect(R"(
first = { stage = "tones", found = "omega" }
second = { stage = "tones", found = "omega", number = 2 }
none = { stage = "tones", found = "omega", number = 3 }
factor = { stage = "bend", found = "factor", reference = 1.2 }
limit = { stage = "press", found = "load_factor" }
)",
                                              column_deck());
    REQUIRE(found.size() == 5);
    // A cantilever: 3.516 √(EI/ρA) less some for shear and rotary inertia.
    CHECK(found[0] == Approx(3.516015).epsilon(2e-2));
    CHECK(found[1] == Approx(std::sqrt(2.0) * 3.516015).epsilon(2e-2));
    CHECK(std::isnan(found[2]));
    // P16 and B1, for half of the load factor.
    CHECK(found[3] == Approx(2.4523658546 / 2.0 - 1.2).epsilon(1e-5));
    CHECK(found[4] == Approx(2.458335976611 / 2.0).epsilon(1e-5));
}

TEST_CASE("What a stage cannot find is refused", "[batch][stages]") {
    const auto faults = [](const std::string& entry) {
        const PlanFiles files(
            "deck = \"deck.toml\"\n[vary]\n\"parameters.load\" = [2.0]\n[collect]\n" + entry + "\n",
            column_deck());
        const Plan plan = files.read();
        FaultList list("plan.toml", {});
        check_collections(plan.collections, read_problem(plan.decks[0]), list);
        std::string text;
        for (const DeckFault& fault : list.list()) text += fault.key + ": " + fault.message;
        return text;
    };
    CHECK(faults("a = { stage = \"tone\", found = \"omega\" }") ==
          "collect.a.stage: the deck has no stage \"tone\"; did you mean \"tones\"?");
    CHECK(faults("a = { stage = \"bend\", found = \"omega\" }") ==
          "collect.a.found: stage \"bend\" of the deck, of kind buckling, finds no omega");
    CHECK(faults("a = { stage = \"press\", found = \"load_factor\" }").empty());
    CHECK_THROWS_WITH(
        faults("a = { stage = \"bend\", found = \"factor\", take = \"max\" }"),
        Catch::Contains("collect.a.take: is for histories and the ledger, not for what a stage finds"));
}

TEST_CASE("Cycles are counted from a time on", "[batch]") {
    const std::vector<double> series{-2, 1, -3, 5, -1, 3, -4, 4, -2};  // ASTM E1049-85, figure 6
    const auto count = [&](const FatigueCount& what) {
        TakenFatigue taken(what);
        for (std::size_t i = 0; i < series.size(); ++i) taken.add(static_cast<double>(i), series[i]);
        return taken.value();
    };
    const double damage = 0.5 * 27 + 1.5 * 64 + 0.5 * 216 + 512 + 0.5 * 729;
    CHECK(count({.curve = SNCurve{{{3.0, 1.0, 1.0}}}}) == Approx(damage).epsilon(1e-14));
    CHECK(count({.slope = 3.0, .cycles = 10.0}) == Approx(std::cbrt(damage / 10.0)).epsilon(1e-14));
    CHECK(count({.slope = 3.0, .cycles = 0.5, .from = 7.0}) == Approx(6.0).epsilon(1e-14));
    CHECK(std::isnan(count({.slope = 3.0, .cycles = 0.5, .from = 9.0})));
    CHECK(std::isnan(count({.curve = SNCurve{{{3.0, 1.0, 1.0}}}, .ultimate = 1.0})));
    const FatigueCount range{.slope = 3.0, .cycles = 1.0};
    TakenFatigue broken(range);
    broken.add(0.0, std::numeric_limits<double>::quiet_NaN());
    CHECK(std::isnan(broken.value()));
}

TEST_CASE("Cycles of what has no sign, or is of no point, are refused", "[batch]") {
    const std::string deck =
        replaced(cantilever_deck,
                 "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = \"EI\", EIz = \"EI\" }\n",
                 "shape = { circle = { radius = 0.2 } }\nmaterial = { E = \"EI\", nu = 0.3 }\n") +
        "[[history]]\nname = \"worst\"\nat = \"r.start\"\n"
        "quantities = [\"stress\", \"von_mises\", \"principal_stress\", \"moment\", \"bending_moment\", "
        "\"shear_force\"]\n"
        "[[history]]\nname = \"edge\"\nat = \"r.start\"\npoint = [0, 0.2]\n"
        "quantities = [\"stress\", \"von_mises\"]\n";
    const auto faults = [&](const std::string& entry, const std::string& count = "damage = { detail = 71 }") {
        return PlanFiles("deck = \"deck.toml\"\n[vary]\n\"parameters.load\" = [2.0]\n[collect]\na = { " +
                             entry + ", " + count + " }\n",
                         deck)
            .faults();
    };
    const std::string effect =
        " has no sign: what changes its sign would count with half of its range; take ";
    const std::string stress =
        "quantity = \"stress\" and a component, such as \"xx\", of a history with point = [y, z]";
    for (const std::string history : {"worst", "edge"}) {
        CHECK(faults("history = \"" + history + "\", quantity = \"von_mises\"") ==
              "plan.toml:5:5: collect.a.quantity: von_mises" + effect + stress);
    }
    CHECK(faults("history = \"worst\", quantity = \"principal_stress\", component = \"x\"") ==
          "plan.toml:5:5: collect.a.quantity: principal_stress" + effect + stress);
    CHECK(faults("history = \"worst\", quantity = \"bending_moment\"") ==
          "plan.toml:5:5: collect.a.quantity: bending_moment" + effect +
              "quantity = \"moment\" and component \"y\" or \"z\"");
    CHECK(faults("history = \"worst\", quantity = \"shear_force\"", "range = { slope = 4, cycles = 1 }") ==
          "plan.toml:5:5: collect.a.quantity: shear_force" + effect +
              "quantity = \"force\" and component \"y\" or \"z\"");
    CHECK(faults("history = \"worst\", quantity = \"moment\", component = \"magnitude\"") ==
          "plan.toml:5:5: collect.a.component: \"magnitude\"" + effect + "\"x\", \"y\" or \"z\"");
    CHECK(faults("history = \"worst\", quantity = \"stress\", component = \"xx\"") ==
          "plan.toml:5:5: collect.a.history: \"worst\" has the stress of another point of the section at "
          "each time, "
          "the worst one, and cycles are those of one point; give the history point = [y, z]");
    CHECK(faults("history = \"edge\", quantity = \"stress\", component = \"xx\"").empty());
    CHECK(faults("history = \"worst\", quantity = \"von_mises\"", "take = \"max\"").empty());
}

TEST_CASE("A run of no step, or one, collects what there is", "[batch]") {
    CHECK(std::isnan(TakenNumber(Take::mean, {}).value()));
    TakenNumber mean(Take::mean, {});
    mean.add(0.0, -2.0);
    CHECK(mean.value() == -2.0);
    TakenNumber rms(Take::rms, {});
    rms.add(0.0, -2.0);
    CHECK(rms.value() == 2.0);
}

TEST_CASE("Collected numbers are those of histories and ledger", "[batch]") {
    const std::vector<double> numbers = collect(R"(
x = { history = "tip", quantity = "position", component = "x", take = "final" }
z = { history = "tip", quantity = "position", component = "z", take = "final" }
length = { history = "tip", quantity = "position", component = "magnitude", take = "final" }
off = { history = "tip", quantity = "position", component = "z", take = "final", reference = 100.0 }
half = { history = "tip", quantity = "position", component = "z", at = 0.5 }
quarter = { history = "tip", quantity = "position", component = "z", at = 0.25 }
w = { history = "tip", quantity = "quaternion", component = "w", take = "final" }
qx = { history = "tip", quantity = "quaternion", component = "x", take = "final" }
qy = { history = "tip", quantity = "quaternion", component = "y", take = "final" }
qz = { history = "tip", quantity = "quaternion", component = "z", take = "final" }
strain = { ledger = "strain_energy", take = "max" }
kinetic = { ledger = "kinetic_energy", take = "max" }
work = { ledger = "external_work", take = "final" }
lost = { ledger = "dissipated_energy", take = "final" }
error = { ledger = "energy_error", take = "max_abs" }
px = { ledger = "linear_momentum", component = "x", take = "max" }
lx = { ledger = "angular_momentum", component = "x", take = "max" }
)");
    REQUIRE(numbers.size() == 17);
    const double x = numbers[0];
    const double z = numbers[1];
    // A cantilever of n linear elements bends under an end load P by P L^3 / (3 EI) (1 - 1/(4 n^2)) + P L /
    // GAz, a little less at large ones.
    CHECK(z == Approx(2.0 * 1000.0 / 1500.0 * (1.0 - 1.0 / 16.0) + 2.0 * 10.0 / 3e4).epsilon(0.02));
    CHECK(x < 10.0);
    CHECK(numbers[2] == Approx(std::hypot(x, z)).epsilon(1e-15));
    CHECK(numbers[3] == Approx(100.0 - z).epsilon(1e-15));
    CHECK(numbers[4] == Approx(z / 2.0).epsilon(0.02));
    CHECK(numbers[5] == Approx(numbers[4] / 2.0).epsilon(1e-14));
    // Turned about -y by some P L^2 / (2 EI) = 0.2.
    CHECK(numbers[6] == Approx(std::cos(0.1)).epsilon(2e-3));
    CHECK(numbers[7] == Approx(0.0).margin(1e-14));
    CHECK(numbers[8] == Approx(-std::sin(0.1)).epsilon(0.05));
    CHECK(numbers[9] == Approx(0.0).margin(1e-14));
    CHECK(numbers[10] == Approx(2.0 * z / 2.0).epsilon(0.02));
    for (const std::size_t none : {11, 13, 15, 16}) CHECK(numbers[none] == 0.0);
    CHECK(numbers[12] == Approx(numbers[10]).epsilon(0.02));
    CHECK(numbers[14] < 0.02 * numbers[10]);
}

TEST_CASE("What a column holds is said in words", "[batch]") {
    Collection collection;
    collection.history = "tip";
    collection.quantity = "position";
    collection.component = Component::z;
    collection.take = Take::largest;
    CHECK(describe(collection) == "largest z of position of tip");
    collection.at = 2.5;
    collection.reference = 3.0;
    CHECK(describe(collection) == "z of position of tip at t = 2.5, distance from 3");
    Collection energy;
    energy.ledger = &ledger_columns.front();
    energy.take = Take::largest_absolute;
    CHECK(describe(energy) == "largest absolute kinetic_energy");
}

}  // namespace gxrod::test
