#include "face/fmu_run.hpp"

#include <filesystem>
#include <fstream>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string swing = R"deck(title = "A rod & its tendon"
gravity = [0, 0, -9.81]
[parameters]
EI = 6
twice = "2*EI"
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "arm.start"
fix = "all"
[input.tendon]
value = 0.5
[signal.own]
value = "t"
[[load]]
at = "arm.end"
moment = [0, "tendon", 0]
[analysis]
kind = "dynamic"
end_time = 0.2
time_step = 0.02
[[history]]
name = "tip"
at = "arm.end"
quantities = ["position", "orientation"]
)deck";

// The folder of the resources of an FMU, which is gone in the end.
struct Resources {
    std::filesystem::path folder = std::filesystem::temp_directory_path() / "gxrod_fmu_run_test";

    explicit Resources(const std::string& deck) {
        for (const auto& [name, bytes] : list_fmu_files(read(deck))) {
            std::filesystem::create_directories((folder / name).parent_path());
            std::ofstream(folder / name, std::ios::binary) << bytes;
        }
    }
    ~Resources() { std::filesystem::remove_all(folder); }
    std::filesystem::path path() const { return folder / "resources"; }
};

// References: 0 time, 1 EI, 2 tendon, 3 … 5 tip.position, 6 … 9 tip.orientation.
constexpr std::size_t EI = 1, tendon = 2, tip_z = 5;

double swing_alone(const std::string& deck, double pull) {
    Simulation run(read(deck));
    run.set("tendon", pull);
    run.advance(0.03);
    run.set("tendon", 2.0 * pull);
    run.advance(0.1);
    return run["tip"].position.z();
}

void swing_fmu(FmuRun& run, double pull) {
    run.set(tendon, pull);
    run.advance(0.03);
    run.set(tendon, 2.0 * pull);
    run.advance(0.1);
}

}  // namespace

TEST_CASE("The variables of an FMU are the parameters, inputs and histories of its deck", "[face]") {
    const std::vector<FmuVariable> variables = list_fmu_variables(read(swing));
    std::vector<std::string> names;
    for (const FmuVariable& variable : variables) names.push_back(variable.name);
    CHECK(names == std::vector<std::string>{"time",
                                            "EI",
                                            "tendon",
                                            "tip.position.x",
                                            "tip.position.y",
                                            "tip.position.z",
                                            "tip.orientation.w",
                                            "tip.orientation.x",
                                            "tip.orientation.y",
                                            "tip.orientation.z"});
    const std::string xml = describe_fmu(read(swing));
    using Catch::Matchers::Contains;
    CHECK_THAT(xml, Contains("description=\"A rod &amp; its tendon\""));
    CHECK_THAT(xml,
               Contains("<Float64 name=\"tendon\" valueReference=\"2\" causality=\"input\" "
                        "variability=\"continuous\" start=\"0.5\"/>"));
    CHECK_THAT(xml, Contains("stopTime=\"0.2\" stepSize=\"0.02\""));
    CHECK_THAT(xml, Contains("<InitialUnknown valueReference=\"9\"/>"));
    CHECK_THROWS_WITH(describe_fmu(read(swing + "[input.time]\n")), Contains("called \"time\""));
}

TEST_CASE("An FMU has the numbers of its deck", "[face]") {
    const Resources resources(swing);
    FmuRun run(resources.path());
    run.begin(0.0);
    CHECK(run.get(EI) == 6.0);
    CHECK(run.get(tendon) == 0.5);
    CHECK(run.get(3) == Approx(2.0));
    swing_fmu(run, 1.5);
    CHECK(run.time() == 0.1);
    CHECK(run.get(tip_z) == swing_alone(swing, 1.5));
    CHECK_THROWS_AS(run.set(EI, 7.0), std::invalid_argument);

    const FmuRun::State state = run.save();
    run.advance(0.18);
    const double later = run.get(tip_z);
    run.restore(state);
    CHECK(run.get(tip_z) == swing_alone(swing, 1.5));
    run.advance(0.18);
    CHECK(run.get(tip_z) == later);
    CHECK_THROWS_AS(run.advance(0.3), std::out_of_range);

    run.reset();
    run.set(EI, 9.0);
    swing_fmu(run, 1.5);
    std::string stiffer = swing;
    stiffer.replace(stiffer.find("EI = 6"), 6, "EI = 9");
    CHECK(run.get(tip_z) == swing_alone(stiffer, 1.5));
    CHECK_THROWS_AS(run.set(tip_z, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(run.get(10), std::invalid_argument);
}

TEST_CASE("An FMU begins at the time of its master", "[face]") {
    const Resources resources(swing);
    FmuRun run(resources.path());
    run.begin(5.0);
    run.set(tendon, 1.5);
    run.advance(5.03);
    run.set(tendon, 3.0);
    run.advance(5.1);
    CHECK(run.get(0) == Approx(5.1));
    CHECK(run.get(tip_z) == Approx(swing_alone(swing, 1.5)).epsilon(1e-9));
}

}  // namespace gxrod::test
