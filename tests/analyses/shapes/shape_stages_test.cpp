#include <array>
#include <cmath>
#include <complex>

#include "check/shape_report.hpp"
#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Stages that find shapes: about which state, what the results hold of them, and what is reported.
using namespace gxrod;
using namespace gxrod::tools;
using test::read;

namespace {

const std::string& column = test::pressed_column_deck;

const std::string three_stages = column + R"([[stage]]
name = "bare"
kind = "modes"
count = 4
[[stage]]
name = "press"
kind = "static"
steps = 3
[[stage]]
name = "tones"
kind = "modes"
below = 20
[[stage]]
name = "more"
kind = "buckling"
count = 2
)";

const ModesRecord& modes_of(const RunSummary& summary, std::size_t i) {
    return std::get<ModesRecord>(summary.shapes.at(i).record);
}
const BucklingRecord& buckling_of(const RunSummary& summary, std::size_t i) {
    return std::get<BucklingRecord>(summary.shapes.at(i).record);
}

}  // namespace

TEST_CASE("An analysis of buckling multiplies the whole load on the reference shape", "[analyses][stages]") {
    const RunSummary summary = run_problem(read(column + "[analysis]\nkind = \"buckling\"\ncount = 2\n"));
    REQUIRE(summary.status == RunStatus::complete);
    CHECK(summary.notes.empty());
    CHECK(summary.shapes[0].stage == "buckling");
    const BucklingRecord& found = buckling_of(summary, 0);
    REQUIRE(found.factors.size() == 2);
    // P16, two independent programs.
    CHECK(found.factors[0].factor == Approx(2.4523658546).epsilon(1e-9));
    CHECK(found.factors[1].factor == Approx(4.8753789019).epsilon(1e-9));
    CHECK(found.is_complete);
}

TEST_CASE("Stages of shapes are about the state of the stage before", "[analyses][stages]") {
    const RunSummary summary = run_problem(read(three_stages));
    REQUIRE(summary.status == RunStatus::complete);
    REQUIRE(summary.shapes.size() == 3);
    CHECK(summary.notes ==
          std::vector<std::string>{"stage bare: about the reference shape, where load[0] does "
                                   "not act: put a [[stage]] of kind static before for the "
                                   "loaded one"});
    // ω² falls with the load, to 0 at the factor; by Rayleigh's quotient never below a straight line.
    const double bare = modes_of(summary, 0).modes[0].omega_squared;
    const double loaded = modes_of(summary, 1).modes[0].omega_squared;
    const double line = 1.0 - 1.0 / 2.4523658546;
    CHECK(loaded / bare > line);
    CHECK(loaded / bare < 1.1 * line);
    for (const Mode& mode : modes_of(summary, 1).modes) CHECK(mode.frequency < 20.0);
    CHECK(modes_of(summary, 1).is_complete);
    // What is still to be added: nearer to the true load (B1) than from the reference shape.
    const BucklingRecord& more = buckling_of(summary, 2);
    CHECK(more.factors[0].factor + 1.0 > 2.4523658546);
    CHECK(more.factors[0].factor + 1.0 < 2.458335976611);
    CHECK(more.load_time == 1.0);
}

TEST_CASE("Results hold the shapes of each stage, and a file of them beside", "[analyses][stages]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(three_stages);
    const RunSummary summary = run_problem(problem, folder / "c.vtkhdf");
    REQUIRE(summary.status == RunStatus::complete);
    const Hdf5Reader file(folder / "c.vtkhdf");
    CHECK(file.text_attribute("/", "status") == "complete");
    CHECK(file.text_attribute("/stages/tones", "kind") == "modes");
    CHECK(file.integer_attribute("/stages/tones", "number") == 2);
    CHECK(file.integer_attribute("/stages/tones", "complete") == 1);
    const ModesRecord& tones = modes_of(summary, 1);
    const std::vector<double> omega = file.numbers("/stages/tones/omega");
    REQUIRE(omega.size() == tones.modes.size());
    CHECK(omega[1] == tones.modes[1].omega);
    CHECK(file.size("/stages/tones/energy_share") == std::vector<hsize_t>{omega.size(), 1, 6});
    CHECK(file.texts("/stages/tones/words")[0] == "1st bending about y of column");
    CHECK(file.numbers("/stages/more/factor")[0] == buckling_of(summary, 2).factors[0].factor);

    const Hdf5Reader shapes(folder / "c.tones.vtkhdf");
    CHECK(shapes.integer_attribute("/VTKHDF/Steps", "NSteps") == static_cast<std::int64_t>(omega.size()));
    CHECK(shapes.numbers("/VTKHDF/Steps/Values")[1] == 2.0);
    const std::size_t points = problem.model.nodes.size();
    CHECK(shapes.numbers("/VTKHDF/Steps/PointDataOffsets/displacement")[2] ==
          static_cast<double>(2 * points));
    const std::vector<double> points_at = shapes.numbers("/VTKHDF/Points");
    CHECK(points_at.size() == 3 * points);
    CHECK(points_at[points_at.size() - 3] == Approx(1.0 - 1e-3).epsilon(1e-5));  // shortened by the load
    // The largest displacement is a tenth of the length; scale leads back to the shape.
    const std::vector<double> moves = shapes.numbers("/VTKHDF/PointData/displacement");
    CHECK(std::abs(moves[3 * (points - 1) + 2]) == Approx(0.1));
    CHECK(moves[3 * (points - 1) + 2] ==
          Approx(file.numbers("/stages/tones/scale")[0] * tones.modes[0].shape.nodes.back()[2]));
}

TEST_CASE("A run that was stopped finds its shapes when it goes on", "[analyses][stages]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(three_stages + "[[stage]]\nname = \"back\"\nkind = \"static\"\nsteps = 3\n");
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    const int stop = GENERATE(0, 2, 3, 5);
    INFO(stop);
    REQUIRE(run_problem(problem, folder / "part.vtkhdf", stop).status == RunStatus::interrupted);
    {
        ResumableFile resumed(folder / "part.vtkhdf");
        RunRequest request{problem, {}, &resumed};
        REQUIRE(run_analysis(request).status == RunStatus::complete);
    }
    const Hdf5Reader whole(folder / "whole.vtkhdf");
    const Hdf5Reader part(folder / "part.vtkhdf");
    CHECK(part.members("/stages") == whole.members("/stages"));
    for (const char* name :
         {"/stages/tones/omega", "/stages/more/factor", "/histories/time", "/histories/stage"})
        CHECK(part.numbers(name) == whole.numbers(name));
}

TEST_CASE("What cannot be found ends the run with a reason", "[analyses][stages]") {
    const std::string beyond = test::replaced(column, "force = [-1, 0, 0]", "force = [-3, 0, 0]");
    const std::string press = "[[stage]]\nname = \"press\"\nkind = \"static\"\n";
    const RunSummary buckling =
        run_problem(read(beyond + press + "[[stage]]\nname = \"more\"\nkind = \"buckling\"\n"));
    CHECK(buckling.status == RunStatus::failed);
    CHECK(buckling.reason == "stage more: the state is unstable as it is: its tangent has negative pivots");
    const RunSummary modes =
        run_problem(read(beyond + press + "[[stage]]\nname = \"tones\"\nkind = \"modes\"\n"));
    CHECK(modes.status == RunStatus::complete);
    CHECK(modes_of(modes, 0).unstable == 1);
    CHECK(modes_of(modes, 0).modes[0].growth > 0.0);
    CHECK(modes.warnings.back() ==
          "stage tones: the state is unstable: 1 of the modes grows instead of vibrating");
}

TEST_CASE("Shapes in sentences", "[analyses][stages]") {
    const RunSummary summary = run_problem(read(three_stages));
    const std::vector<std::string> bare = list_shapes(summary.shapes[0].record, 2);
    REQUIRE(bare.size() == 5);
    CHECK(bare[0].starts_with("4 modes below "));
    CHECK(bare[0].ends_with(" cycles per time, and no others (counted)"));
    CHECK(bare[1].ends_with("1st bending about y of column"));
    CHECK(bare[3] == "      and 2 more");
    CHECK(bare[4].starts_with("effective mass together: "));
    CHECK(list_shapes(summary.shapes[2].record, 5)[0] ==
          "2 buckling factors on the loads at t = 1, by linear theory, and none below (counted)");
    const RunSummary pulled = run_problem(
        read(test::replaced(column, "[-1, 0, 0]", "[1, 0, 0]") + "[analysis]\nkind = \"buckling\"\n"));
    CHECK(list_shapes(pulled.shapes[0].record, 5).back().starts_with("the loads turned round: 2.45"));
    const RunSummary followed = run_problem(
        read(test::replaced(column, "force = [-1, 0, 0]", "force = [-1, 0, 0]\nframe = \"follower\"") +
             "[[stage]]\nname = \"press\"\nkind = \"static\"\n" +
             "[[stage]]\nname = \"tones\"\nkind = \"modes\"\n"));
    CHECK(followed.warnings.back().find("load[0] follows its point, so the stiffness is not symmetric") !=
          std::string::npos);
}

TEST_CASE("A stage of eigenvalues finds what loads that follow do", "[analyses][stages]") {
    const std::string beck = R"(plane = "xy"
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1, rhoJ = 1e-4, rhoIy = 1e-4, rhoIz = 1e-4 }
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 16
order = 4
[[support]]
at = "column.start"
fix = "all"
[[load]]
at = "column.end"
force = ["-19*t", 0, 0]
frame = "follower"
[[stage]]
name = "press"
kind = "static"
[[stage]]
name = "flutter"
kind = "eigenvalues"
count = 2
)";
    const RunSummary below = run_problem(read(beck));
    const auto& found = std::get<EigenvaluesRecord>(below.shapes.at(0).record);
    // P9a, two independent programs.
    CHECK(found.modes.at(0).omega == Approx(8.9726419193).epsilon(1e-9));
    CHECK(found.modes.at(1).omega == Approx(13.1176119729).epsilon(1e-9));
    CHECK(found.unstable == 0);
    const std::vector<std::string> lines = list_shapes(below.shapes[0].record, 5);
    CHECK(lines[0] == "2 eigenvalues, and none missed nearer to 0 (counted)");
    CHECK(lines[1].find("Re λ 0 ") != std::string::npos);

    const sample::ScratchFolder folder;
    const Problem beyond = read(test::replaced(beck, "-19*t", "-19.9366107373*t"));
    const RunSummary flutter = run_problem(beyond, folder / "beck.vtkhdf");
    const auto& modes = std::get<EigenvaluesRecord>(flutter.shapes.at(0).record).modes;
    CHECK(modes.at(0).growth == Approx(.30638645).epsilon(1e-7));
    CHECK(modes.at(1).growth == Approx(-.30638645).epsilon(1e-7));
    CHECK(modes.at(1).omega == Approx(10.96715131).epsilon(1e-8));
    CHECK(flutter.warnings.back().starts_with(
        "stage flutter: the state is unstable by flutter: 1 motion grows, "
        "at most as exp(0.3064 t), with ω = 10.967"));
    const Hdf5Reader file(folder / "beck.vtkhdf");
    CHECK(file.text_attribute("/stages/flutter", "kind") == "eigenvalues");
    CHECK(file.numbers("/stages/flutter/growth")[1] == modes[1].growth);
    const Hdf5Reader shapes(folder / "beck.flutter.vtkhdf");
    const double scale = file.numbers("/stages/flutter/scale")[1];
    const std::size_t last = 2 * beyond.model.nodes.size() - 1;
    CHECK(shapes.numbers("/VTKHDF/PointData/displacement_imaginary")[3 * last + 1] ==
          scale * modes[1].imaginary.back()[1]);
}

namespace {

const std::string blade = R"([rotation]
through = [0, 0, 0]
speed = 10
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 0.8, EIy = 1, EIz = 4 }
inertia = { rhoA = 1, rhoJ = 5e-4, rhoIy = 1e-4, rhoIz = 4e-4 }
[rod.blade]
section = "s"
line = { from = [0.2, 0, 0], to = [1.2, 0, 0] }
y_axis = [0, 1, 0]
elements = 16
order = 4
[[support]]
at = "blade.start"
fix = "all"
[[stage]]
name = "turn"
kind = "steady"
steps = 2
newton = { tolerance = 1e-11 }
[[stage]]
name = "tones"
kind = "eigenvalues"
count = 6
)";

}  // namespace

TEST_CASE("A blade turns steadily, and vibrates about that", "[analyses][stages]") {
    const RunSummary summary = run_problem(read(blade));
    REQUIRE(summary.status == RunStatus::complete);
    CHECK(summary.warnings.empty());
    const auto& modes = std::get<EigenvaluesRecord>(summary.shapes.at(0).record).modes;
    // P10a at Ω = 10, two independent programs.
    const std::array<double, 6> omega{
        9.7069294310, 12.4532489861, 35.8726186568, 50.4144878005, 63.3082244628, 76.8081776936};
    REQUIRE(modes.size() >= omega.size());
    for (std::size_t i = 0; i < omega.size(); ++i) CHECK(modes[i].omega == Approx(omega[i]).epsilon(1e-9));
    // What turns it does the work that it takes.
    CHECK(summary.totals.largest_energy_error == 0.0);
    CHECK(summary.totals.largest_energy == Approx(29.0340097).epsilon(1e-6));
}

TEST_CASE("A blade that was turning goes on from there", "[analyses][stages]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(test::replaced(blade, "steps = 2", "steps = 4"));
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    REQUIRE(run_problem(problem, folder / "part.vtkhdf", 2).status == RunStatus::interrupted);
    {
        ResumableFile resumed(folder / "part.vtkhdf");
        RunRequest request{problem, {}, &resumed};
        REQUIRE(run_analysis(request).status == RunStatus::complete);
    }
    const Hdf5Reader whole(folder / "whole.vtkhdf");
    const Hdf5Reader part(folder / "part.vtkhdf");
    for (const char* name : {"/stages/tones/omega", "/ledger/external_work", "/VTKHDF/Points"})
        CHECK(part.numbers(name) == whole.numbers(name));
}

TEST_CASE("A damped cantilever answers to a force that swings", "[analyses][stages]") {
    const std::string deck = R"(plane = "xy"
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 1, EIy = 1, EIz = 1 }
inertia = { rhoA = 1, rhoJ = 1e-4, rhoIy = 1e-4, rhoIz = 1e-4 }
damping = { kelvin_voigt = 2e-3, mass_proportional = 0.2 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 16
order = 4
[[support]]
at = "beam.start"
fix = "all"
[analysis]
kind = "response"
omega = { values = [1, 3.5, 10, 21.9, 60] }
excite = [{ at = "beam.end", force = [0, 1, 0] }]
[[history]]
name = "tip"
at = "beam.end"
quantities = "displacement"
[[history]]
name = "root"
at = "beam.start"
quantities = "reaction_moment"
)";
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(read(deck), folder / "shake.vtkhdf");
    REQUIRE(summary.status == RunStatus::complete);
    CHECK(list_shapes(summary.shapes.at(0).record, 5) ==
          std::vector<std::string>{"the answer at 5 frequencies, ω from 1 to 60",
                                   "   1  tip: largest amplitude 5.04803, at ω = 3.5",
                                   "   2  root: largest amplitude 0, at ω = 1"});
    const Hdf5Reader file(folder / "shake.vtkhdf");
    const std::vector<double> tip = file.numbers("/stages/response/histories/tip/displacement");
    REQUIRE(tip.size() == 5 * 3 * 2);
    // P14, 40 digits.
    const std::array<std::complex<double>, 5> known{{{.362007553023, -.00699954964397},
                                                     {.598289070683, -5.01245392834},
                                                     {-.033541491529, -.00151909162518},
                                                     {-.00397379657242, -.156320615066},
                                                     {.00010679361073, -.00826718031826}}};
    for (std::size_t i = 0; i < known.size(); ++i) {
        const std::complex<double> found{tip[6 * i + 2], tip[6 * i + 3]};
        CHECK(std::abs(found - known[i]) < 1e-8 * std::abs(known[i]));
    }
    const std::vector<double> root = file.numbers("/stages/response/histories/root/reaction_moment");
    CHECK(std::hypot(root[10], root[11]) == Approx(std::hypot(2.047754625, 17.59198733)).epsilon(1e-8));
    CHECK_FALSE(std::filesystem::exists(folder / "shake.response.vtkhdf"));
}

TEST_CASE("Modes after slow motion are those about the same static state", "[analyses][stages]") {
    const std::string tones = "[[stage]]\nname = \"tones\"\nkind = \"modes\"\ncount = 3\n";
    const auto of = [&](const std::string& stage) {
        const std::string press =
            "[[stage]]\nname = \"press\"\n" + stage + "newton = { tolerance = 1e-12 }\n";
        return run_problem(
            read(test::replaced(column, "[-1, 0, 0]", "[\"-min(t, 1)\", 0, 0]") + press + tones));
    };
    // Undamped, it stands still once the load does.
    const RunSummary slow = of("kind = \"quasi-static\"\nend_time = 2\nsteps = 8\n");
    const RunSummary at_once = of("kind = \"static\"\nsteps = 2\n");
    REQUIRE(slow.status == RunStatus::complete);
    CHECK(slow.warnings.empty());
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(modes_of(slow, 0).modes[i].omega == Approx(modes_of(at_once, 0).modes[i].omega).epsilon(1e-9));
}

TEST_CASE("Slow motion is resumed to the last bit", "[analyses][stages]") {
    const sample::ScratchFolder folder;
    const Problem problem =
        read(test::replaced(column, "rhoIz = 2e-4 }", "rhoIz = 2e-4 }\ndamping = { kelvin_voigt = 0.5 }") +
             "[analysis]\nkind = \"quasi-static\"\nend_time = 2\nsteps = 9\n"
             "[[history]]\nname = \"tip\"\nat = \"column.end\"\nquantities = [\"position\"]\n");
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    REQUIRE(run_problem(problem, folder / "part.vtkhdf", 4).status == RunStatus::interrupted);
    REQUIRE(resume_problem(problem, folder / "part.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader whole(folder / "whole.vtkhdf"), part(folder / "part.vtkhdf");
    for (const char* name : {"/histories/tip/position", "/ledger/dissipated_energy", "/ledger/external_work"})
        CHECK(whole.numbers(name) == part.numbers(name));
}
