
#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "run/run.hpp"
#include "solvers/steps/step_control.hpp"
#include "tools/catch.hpp"

// A run that was stopped and resumed, against the same run in one piece: equal to the last bit.

namespace gxrod::test {
namespace {

// A bent rod that swings, twists and stretches, with a body at its end.
const std::string swinging = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[body.b]
at = "r.end"
mass = 0.5
inertia = [0.1, 0.2, 0.2]
[[support]]
at = "r.start"
fix = ["y", "z", "rx", "rz"]
move = { x = "0.1*sin(5*t)", ry = "t" }
[[load]]
at = "r.end"
force = [0, "10*t", 0]
frame = "follower"
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 0.02
[output]
every = 4
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "quaternion", "moment", "acceleration"]
)deck";

std::string loaded() {
    return replaced(
        replaced(swinging, "\"dynamic\"\nend_time = 1.0\ntime_step = 0.02", "\"static\"\nsteps = 12"),
        "move = { x = \"0.1*sin(5*t)\", ry = \"t\" }",
        "move = { x = \"0.1*t\", ry = \"t\" }");
}

// Of all datasets of numbers but those that say where a run came from and how it would resume.
std::vector<std::string> names_of(const Hdf5Reader& file) {
    std::vector<std::string> names = file.datasets();
    std::erase_if(names, [](const std::string& name) {
        return name.starts_with("/restart") || name.starts_with("/deck") || name == "/rods/name" ||
               name == "/rods/section" || name == "/bodies/name";
    });
    return names;
}

struct Runner {
    sample::ScratchFolder folder;

    // Stops after so many steps; never if negative.
    RunSummary run(const Problem& problem, const std::string& name, int most_steps = -1) const {
        RunRequest request{problem, ResultsFileOptions{folder / name}};
        int steps = 0;
        request.is_interrupted = [&] { return steps++ == most_steps; };
        return run_analysis(request);
    }
    RunSummary resume(const Problem& problem, const std::string& name, int most_steps = -1) const {
        ResumableFile file(folder / name);
        RunRequest request{problem, {}, &file};
        int steps = 0;
        request.is_interrupted = [&] { return steps++ == most_steps; };
        return run_analysis(request);
    }
    // Datasets of the second file that differ from those of the first, in names, sizes or bits.
    std::vector<std::string> differences(const std::string& first, const std::string& second) const {
        const Hdf5Reader a(folder / first);
        const Hdf5Reader b(folder / second);
        std::vector<std::string> different;
        for (const std::string& name : names_of(a)) {
            if (!b.has(name) || a.size(name) != b.size(name) || a.numbers(name) != b.numbers(name))
                different.push_back(name);
        }
        if (names_of(a) != names_of(b)) different.push_back("names");
        return different;
    }
};

std::string with_integrator(const std::string& name) {
    return replaced(swinging, "time_step = 0.02", "time_step = 0.02\nintegrator = \"" + name + "\"");
}

std::string unsupported(const std::string& deck) {
    return replaced(deck,
                    "[[support]]\nat = \"r.start\"\nfix = [\"y\", \"z\", \"rx\", \"rz\"]\n"
                    "move = { x = \"0.1*sin(5*t)\", ry = \"t\" }\n",
                    "");
}

// With velocities at the start that fit the support's.
std::string projected(const std::string& deck) {
    return replaced(deck, "time_step", "start = \"project\"\ntime_step");
}

// With a tendon that is drawn in, and seen.
std::string with_winch(const std::string& deck, const std::string& lines) {
    return replaced(deck,
                    "[body.b]",
                    "[tendon.t]\non = \"r\"\noffset = [0.05, \"0.02*s\"]\n" + lines +
                        "[[history]]\nname = \"tendon\"\nat = \"t\"\nquantities = [\"tendon_length\", "
                        "\"tendon_tension\", \"tendon_end_tension\"]\n[body.b]");
}

std::string with_law(const std::string& deck, const std::string& law) {
    return replaced(deck, "[rod.r]", "law = { " + law + " }\n[rod.r]");
}

}  // namespace

TEST_CASE("A resumed run equals one in one piece to the last bit", "[analyses][resume]") {
    const std::string deck = GENERATE(
        as<std::string>{},
        swinging,
        with_integrator("newmark-ibrahimbegovic"),
        with_integrator("generalized-alpha"),
        with_integrator("sdirk-4"),
        unsupported(with_integrator("energy-momentum")),
        replaced(with_integrator("sdirk-4"), "time_step", "adaptive = { tolerance = 1e-5 }\ntime_step"),
        replaced(swinging, "elements = 4", "elements = 3\norder = 2\nelement = \"simo\""),
        replaced(swinging,
                 "rhoIz = 0.1 }",
                 "rhoIz = 0.1 }\ndamping = { kelvin_voigt = 1e-2, mass_proportional = 0.3 }"),
        replaced(swinging, "gravity = [0, 0, -9.81]", "gravity = [0, 0, \"-9.81*t\"]"),
        with_law(swinging, "layers = [{ on = \"bending\", stiffness = 5, limit = 0.4 }]"),
        with_law(with_integrator("sdirk-4"), "viscoelastic = { prony = [[0.5, 0.1], [0.2, 2]] }"),
        with_law(replaced(loaded(), "elements = 4", "elements = 2\norder = 2\nelement = \"simo\""),
                 "plastic = { yield = { My = 0.5, Mz = 0.5 }, kinematic = 0.3 }"),
        with_winch(projected(with_integrator("generalized-alpha")),
                   "shortening = \"0.01*sin(9*t)^2\"\nslack = false\n"),
        with_winch(projected(with_integrator("sdirk-4")),
                   "shortening = \"0.01*sin(9*t)^2\"\nslack = false\n"),
        with_winch(swinging, "shortening = \"0.01*t\"\nstiffness = 100\n"),
        with_winch(swinging, "tension = \"3*t\"\n"),
        with_winch(swinging, "tension = \"9*sin(9*t)^2\"\nfriction = 0.5\nstiffness = 50\n"),
        with_winch(with_integrator("sdirk-4"), "tension = \"9*sin(9*t)^2\"\nfriction = 0.5\n"),
        with_winch(loaded(), "tension = 3\nfriction = 0.5\n"),
        with_winch(loaded(), "shortening = 0.01\n"),
        loaded(),
        replaced(loaded(), "elements = 4", "elements = 2\norder = 3\nelement = \"simo\""));
    INFO(deck);
    const Problem problem = read(deck);
    const Runner runner;
    const RunSummary whole = runner.run(problem, "whole");
    REQUIRE(whole.status == RunStatus::complete);
    // Not where a frame is due, so that the last one has to go.
    REQUIRE(runner.run(problem, "parts", 5).status == RunStatus::interrupted);
    REQUIRE(runner.resume(problem, "parts", 2).status == RunStatus::interrupted);
    const RunSummary parts = runner.resume(problem, "parts");
    CHECK(parts.status == RunStatus::complete);
    CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
    CHECK(parts.totals.steps == whole.totals.steps);
    CHECK(parts.totals.newton_iterations == whole.totals.newton_iterations);
    CHECK(parts.totals.largest_energy_error == whole.totals.largest_energy_error);
    CHECK(Hdf5Reader(runner.folder / "parts").text_attribute("/", "status") == "complete");
}

TEST_CASE("Bodies resume to the last bit with every integrator", "[analyses][resume]") {
    const std::string scheme = GENERATE(
        "newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "runge-kutta-4");
    const Problem problem =
        read(replaced(body_deck, "steps = 10", "steps = 40\nintegrator = \"" + scheme + "\"") +
             "[[load]]\nat = \"top\"\nforce = [\"sin(9*t)\", 0, 0]\nmoment = [0, 2, \"t\"]\n");
    const Runner runner;
    runner.run(problem, "whole");
    runner.run(problem, "parts", 13);
    runner.resume(problem, "parts");
    CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
}

TEST_CASE("A run made longer equals one that was long from the start", "[analyses][resume]") {
    // 1.14 / 57 is not the double nearest to 0.02.
    const std::string end = GENERATE(as<std::string>{}, "1.7", "1.14");
    const Problem whole = read(replaced(swinging, "end_time = 1.0", "end_time = " + end));
    const Runner runner;
    runner.run(read(swinging), "longer");
    runner.run(whole, "whole");
    runner.resume(whole, "longer");
    // t = 1 was the last frame of the shorter run and is not a frame of the longer one.
    REQUIRE(Hdf5Reader(runner.folder / "longer").size("/VTKHDF/Steps/Values") ==
            std::vector<hsize_t>{end == "1.7" ? 23U : 16U});
    CHECK(runner.differences("whole", "longer") == std::vector<std::string>{});
    CHECK(Hdf5Reader(runner.folder / "longer").text("/deck/text_2") == whole.record.text);
}

TEST_CASE("Steps can be shortened where a run stopped", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    const RunSummary summary =
        runner.resume(read(replaced(swinging, "time_step = 0.02", "time_step = 0.01")), "parts");
    CHECK(summary.status == RunStatus::complete);
    CHECK(summary.totals.steps == 7 + 86);
    const std::vector<double> times = Hdf5Reader(runner.folder / "parts").numbers("/histories/time");
    CHECK(times[7] == 0.14);
    CHECK(times[8] == 0.15);
    CHECK(times.back() == 1.0);
}

TEST_CASE("A run with equal steps is resumed with steps by their error", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(with_integrator("sdirk-4")), "parts", 7);
    const std::string adaptive =
        replaced(with_integrator("sdirk-4"), "time_step", "adaptive = { tolerance = 1e-5 }\ntime_step");
    const RunSummary summary = runner.resume(read(adaptive), "parts");
    CHECK(summary.status == RunStatus::complete);
    const std::vector<double> steps = Hdf5Reader(runner.folder / "parts").numbers("/solver/time_step");
    CHECK(steps[8] > 0.002);
    CHECK(steps[8] <= 0.02);
    CHECK(summary.totals.largest_energy_error < 1e-3 * summary.totals.largest_energy);
}

TEST_CASE("A failed run is resumed as if it had been run so from the start", "[analyses][resume]") {
    const Runner runner;
    SECTION("Newton had too few iterations") {
        const std::string strict =
            replaced(loaded(), "steps = 12", "steps = 12\nnewton = { max_iterations = 1 }");
        REQUIRE(runner.run(read(strict), "parts").status == RunStatus::failed);
        CHECK(runner.resume(read(loaded()), "parts").status == RunStatus::complete);
        runner.run(read(loaded()), "whole");
        CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
    }
    SECTION("The error could not be kept") {
        const std::string adaptive =
            replaced(with_integrator("sdirk-4"), "time_step", "adaptive = { tolerance = 1e-5 }\ntime_step");
        const std::string strict =
            replaced(adaptive, "tolerance = 1e-5", "tolerance = 1e-14, min_step = 1e-3");
        REQUIRE(runner.run(read(strict), "parts").status == RunStatus::failed);
        CHECK(runner.resume(read(adaptive), "parts").status == RunStatus::complete);
        runner.run(read(adaptive), "whole");
        CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
    }
}

TEST_CASE("After a failure within a step a whole one is tried first", "[analyses][resume]") {
    StepControl control(1.0, 10);
    control.accept();
    while (control.reject()) {
    }
    control.accept();
    while (control.reject()) {
    }
    StepControl next(1.0, 10);
    REQUIRE(next.resume(control.memory()));
    CHECK(next.time() == control.time());
    CHECK(next.next_time() == 0.2);
    REQUIRE(next.reject());
    CHECK(next.next_time() < 0.2);
    next.accept();
    while (!next.finished()) next.accept();
    CHECK(next.time() == 1.0);
}

TEST_CASE("Another linear solver takes over", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(replaced(swinging, "time_step", "linear_solver = \"klu\"\ntime_step")), "parts", 7);
    const RunSummary summary = runner.resume(
        read(replaced(swinging, "time_step", "linear_solver = \"umfpack\"\ntime_step")), "parts");
    CHECK(summary.status == RunStatus::complete);
    CHECK(summary.totals.largest_energy_error < 0.01 * summary.totals.largest_energy);
}

TEST_CASE("A run that was not closed at its end is closed", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    CHECK(!ResumableFile(runner.folder / "parts").is_complete());
    const Problem ended = read(replaced(swinging, "end_time = 1.0", "end_time = 0.14"));
    CHECK(runner.resume(ended, "parts").status == RunStatus::complete);
    CHECK(ResumableFile(runner.folder / "parts").is_complete());
    runner.run(ended, "whole");
    CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
}

TEST_CASE("A history that comes back has its point", "[analyses][resume]") {
    const Runner runner;
    const std::string none = swinging.substr(0, swinging.find("[[history]]"));
    const std::string moved =
        replaced(swinging, "at = \"r.end\"\nquantities", "at = \"r.start\"\nquantities");
    runner.run(read(swinging), "parts", 3);
    runner.resume(read(none), "parts", 3);
    CHECK_THROWS_WITH(runner.resume(read(moved), "parts"),
                      Catch::Contains("its history tip is of another point"));
    CHECK(runner.resume(read(swinging), "parts").status == RunStatus::complete);
    const std::vector<double> x = Hdf5Reader(runner.folder / "parts").numbers("/histories/tip/position");
    CHECK(!std::isnan(x[3 * 3]));
    CHECK(std::isnan(x[3 * 5]));
    CHECK(!std::isnan(x[3 * 7]));
}

TEST_CASE("A run is not resumed between the steps of another grid", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    const std::string other = GENERATE(as<std::string>{}, "time_step = 0.03", "steps = 7");
    const Problem problem = read(replaced(swinging, "time_step = 0.02", other));
    CHECK_THROWS_WITH(runner.resume(problem, "parts"),
                      Catch::Contains("do not meet t = 0.14, where it stopped") &&
                          Catch::Contains("take a step that goes into this time"));
    CHECK(Hdf5Reader(runner.folder / "parts").text_attribute("/", "status") == "interrupted");
}

TEST_CASE("A run is not resumed after its end", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    CHECK_THROWS_WITH(runner.resume(read(replaced(swinging, "end_time = 1.0", "end_time = 0.1")), "parts"),
                      Catch::Contains("it is at t = 0.14 already, after the end, 0.1"));
    CHECK_THROWS_AS(
        runner.resume(
            read(replaced(with_integrator("sdirk-4"), "end_time = 1.0", "adaptive = { }\nend_time = 0.1")),
            "parts"),
        FileError);
}

TEST_CASE("A run is not resumed with another model", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    const std::string other = GENERATE(replaced(swinging, "elements = 4", "elements = 5"),
                                       replaced(swinging, "elements = 4", "elements = 4\nelement = \"simo\""),
                                       with_integrator("generalized-alpha"));
    CHECK_THROWS_WITH(runner.resume(read(other), "parts"), Catch::Contains("belongs to another model"));
}

TEST_CASE("Histories that come and go are NaN where they were not recorded", "[analyses][resume]") {
    const Runner runner;
    const std::string without = replaced(swinging, "\"moment\", ", "");
    runner.run(read(swinging), "whole");
    runner.run(read(swinging), "parts", 7);
    runner.resume(
        read(without + "[[history]]\nname = \"top\"\nat = \"r.start\"\nquantities = [\"velocity\"]\n"),
        "parts");
    const Hdf5Reader whole(runner.folder / "whole");
    const Hdf5Reader parts(runner.folder / "parts");
    const std::vector<double> moment = parts.numbers("/histories/tip/moment");
    const std::vector<double> velocity = parts.numbers("/histories/top/velocity");
    const std::vector<double> quaternion = parts.numbers("/histories/tip/quaternion");
    REQUIRE(parts.size("/histories/tip/moment") == std::vector<hsize_t>{51, 3});
    REQUIRE(parts.size("/histories/top/velocity") == std::vector<hsize_t>{51, 3});
    for (std::size_t i = 0; i < moment.size(); ++i) {
        const bool is_later = i >= 3 * 8;
        CHECK(std::isnan(moment[i]) == is_later);
        if (!is_later) CHECK(moment[i] == whole.numbers("/histories/tip/moment")[i]);
        CHECK(std::isnan(velocity[i]) == !is_later);
    }
    CHECK(quaternion == whole.numbers("/histories/tip/quaternion"));
    CHECK(parts.text_attribute("/histories/top", "at") == "r.start");
}

TEST_CASE("Quaternions keep their sign where a run is resumed", "[analyses][resume]") {
    // Two turns and more: w changes its sign.
    const Problem problem =
        read(replaced(body_deck, "inertia = [1, 1, 1]", "inertia = [1, 1, 1]\nangular_velocity = [0, 0, 9]") +
             "[[history]]\nname = \"q\"\nat = \"top\"\nquantities = [\"quaternion\", \"orientation\"]\n");
    const Runner runner;
    runner.run(problem, "whole");
    runner.run(problem, "parts", 6);
    runner.resume(problem, "parts");
    CHECK(Hdf5Reader(runner.folder / "whole").numbers("/histories/q/quaternion")[6 * 4] < 0.0);
    CHECK(runner.differences("whole", "parts") == std::vector<std::string>{});
}

TEST_CASE("Two processes do not write one file", "[analyses][resume]") {
    const Runner runner;
    runner.run(read(swinging), "parts", 7);
    const ResumableFile writer(runner.folder / "parts");
    CHECK_THROWS_WITH(ResumableFile(runner.folder / "parts"),
                      Catch::Contains("another process is writing it"));
}

TEST_CASE("What cannot be resumed is reported", "[analyses][resume]") {
    const Runner runner;
    CHECK_THROWS_WITH(ResumableFile(runner.folder / "none"), Catch::Contains("there is no such file"));
    CHECK_THROWS_WITH(ResumableFile(runner.folder.path()), Catch::Contains("is a folder"));
    const ScratchFile text("text.vtkhdf", "no HDF5");
    CHECK_THROWS_WITH(ResumableFile(text.path()), Catch::Contains("cannot be resumed: "));
    { const ResultsFile empty({runner.folder / "empty"}, sample::make_deck(), sample::make_model(), {}); }
    CHECK_THROWS_WITH(ResumableFile(runner.folder / "empty"),
                      Catch::Contains("it has no state to resume from"));
}

}  // namespace gxrod::test
