#include <algorithm>
#include <cmath>

#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "run/output_schedule.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

// Frames and samples of histories at times that a deck asks for.

namespace gxrod::test {
namespace {

using tools::resume_problem;
using tools::run_problem;

const std::string rod = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "quaternion", "moment", "acceleration"]
[[history]]
name = "root"
at = "r.start"
quantities = ["reaction_force", "force"]
)deck";

const std::string adaptive = rod + R"deck([analysis]
kind = "dynamic"
end_time = 0.5
accuracy = 1e-4
)deck";

const std::string equal_steps = rod + R"deck([analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.02
)deck";

// A load step, then time.
const std::string staged = rod + R"deck([[stage]]
name = "preload"
kind = "static"
steps = 2
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 0.25
time_step = 0.02
[[stage]]
name = "on"
kind = "dynamic"
end_time = 0.25
time_step = 0.02
)deck";

std::vector<double> multiples(double count, double denominator) {
    std::vector<double> times;
    for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(i / denominator);
    return times;
}

struct Runs {
    sample::ScratchFolder folder;

    Hdf5Reader run(const std::string& deck, const std::string& name) const {
        REQUIRE(run_problem(read(deck), folder / name).status == RunStatus::complete);
        return Hdf5Reader(folder / name);
    }
};

void check_close(const std::vector<double>& values, const std::vector<double>& expected) {
    REQUIRE(values.size() == expected.size());
    double error = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        error = std::max(error, std::abs(values[i] - expected[i]));
        scale = std::max(scale, std::abs(expected[i]));
    }
    CHECK(error < 0.03 * scale);
}

const std::string frame_times = "/VTKHDF/Steps/Values";

// Of all datasets of numbers but those that say where a run came from and how it would resume.
std::vector<std::string> names_of(const Hdf5Reader& file) {
    std::vector<std::string> names = file.datasets();
    std::erase_if(names, [](const std::string& name) {
        return name.starts_with("/restart") || name.starts_with("/deck") || name == "/rods/name" ||
               name == "/rods/section";
    });
    return names;
}

bool is_of_steps(const std::string& name) {
    return name.starts_with("/histories") || name.starts_with("/ledger") || name.starts_with("/solver");
}

}  // namespace

TEST_CASE("Frames come at the multiples of an interval, and at the end", "[analyses]") {
    const Runs runs;
    const Hdf5Reader file = runs.run(adaptive + "[output]\ninterval = 0.03\nhistory_interval = 0.01\n", "a");
    std::vector<double> expected = multiples(16, 1.0);
    for (double& time : expected) time = time * 3.0 / 100.0;
    expected.push_back(0.5);
    CHECK(file.numbers(frame_times) == expected);
    CHECK(file.numbers("/sampled/time") == multiples(50, 100.0));
    CHECK(file.size("/sampled/tip/quaternion") == std::vector<hsize_t>{51, 4});
    CHECK(file.text_attribute("/", "interpolation") ==
          "polynomials through the stages and both ends, order 4");
    // The steps are those of a run that does not write between them.
    const Hdf5Reader plain = runs.run(adaptive, "b");
    for (const std::string& name : plain.datasets()) {
        if (!is_of_steps(name)) continue;
        INFO(name);
        CHECK(plain.numbers(name) == file.numbers(name));
    }
    CHECK(!plain.has("/sampled"));
    CHECK(!plain.has_attribute("/", "interpolation"));
}

TEST_CASE("Frames come at listed times, at the start and at the end", "[analyses]") {
    const Runs runs;
    const Hdf5Reader file = runs.run(adaptive + "[output]\ntimes = [0.123, 0.3]\n", "a");
    CHECK(file.numbers(frame_times) == std::vector{0.0, 0.123, 0.3, 0.5});
    const Hdf5Reader all = runs.run(adaptive + "[output]\ntimes = [0, 0.123, 0.3, 0.5]\n", "b");
    CHECK(all.numbers(frame_times) == file.numbers(frame_times));
    CHECK(all.numbers("/VTKHDF/Points") == file.numbers("/VTKHDF/Points"));
}

TEST_CASE("Where steps end, frames and samples are the states there", "[analyses]") {
    const Runs runs;
    const Hdf5Reader by_time =
        runs.run(equal_steps + "[output]\ninterval = 0.1\nhistory_interval = 0.02\n", "a");
    const Hdf5Reader by_step = runs.run(equal_steps + "[output]\nevery = 5\n", "b");
    for (const std::string& name : by_step.datasets()) {
        if (!name.starts_with("/VTKHDF")) continue;
        INFO(name);
        CHECK(by_step.numbers(name) == by_time.numbers(name));
    }
    for (const std::string& name : by_step.datasets()) {
        if (!name.starts_with("/histories")) continue;
        INFO(name);
        CHECK(by_step.numbers(name) ==
              by_time.numbers("/sampled" + name.substr(std::string("/histories").size())));
    }
}

TEST_CASE("Samples within steps are close to those of short steps", "[analyses]") {
    const Runs runs;
    const std::string scheme = GENERATE("radau-5", "sdirk-4");
    const auto with = [&](const std::string& step) {
        return replaced(
            equal_steps, "time_step = 0.02", "time_step = " + step + "\nintegrator = \"" + scheme + "\"");
    };
    const Hdf5Reader coarse = runs.run(with("0.01") + "[output]\nhistory_interval = 0.002\n", "a");
    const Hdf5Reader fine = runs.run(with("0.002"), "b");
    for (const char* name : {"/tip/position", "/tip/quaternion", "/root/reaction_force", "/root/force"}) {
        INFO(name << " of " << scheme);
        check_close(coarse.numbers("/sampled" + std::string(name)),
                    fine.numbers("/histories" + std::string(name)));
    }
}

TEST_CASE("Samples within quasi-static steps are close to those of short steps", "[analyses]") {
    const Runs runs;
    const std::string creeping = replaced(replaced(equal_steps, "\"dynamic\"", "\"quasi-static\""),
                                          "rhoIz = 0.1 }",
                                          "rhoIz = 0.1 }\ndamping = { kelvin_voigt = 0.2 }");
    const Hdf5Reader coarse = runs.run(creeping + "[output]\nhistory_interval = 0.004\n", "a");
    const Hdf5Reader fine = runs.run(replaced(creeping, "time_step = 0.02", "time_step = 0.004"), "b");
    for (const char* name : {"/tip/position", "/root/reaction_force", "/root/force"}) {
        INFO(name);
        check_close(coarse.numbers("/sampled" + std::string(name)),
                    fine.numbers("/histories" + std::string(name)));
    }
}

TEST_CASE("Times count in each stage with time; load steps have frames as without", "[analyses]") {
    const Runs runs;
    const Hdf5Reader file = runs.run(staged + "[output]\ninterval = 0.1\nhistory_interval = 0.1\n", "a");
    const std::vector<double> expected{-1.0, -0.5, 0.0, 0.1, 0.2, 0.25, 0.35, 0.45, 0.5};
    const std::vector<double> times = file.numbers(frame_times);
    REQUIRE(times.size() == expected.size());
    for (std::size_t i = 0; i < times.size(); ++i) CHECK(times[i] == Approx(expected[i]).margin(1e-15));
    CHECK(file.numbers("/sampled/time") == std::vector{0.0, 0.1, 0.2, 0.35, 0.45});
    const Hdf5Reader listed = runs.run(staged + "[output]\ntimes = [0, 0.25, 0.33]\n", "b");
    CHECK(listed.numbers(frame_times) == std::vector{-1.0, -0.5, 0.0, 0.25, 0.33, 0.5});
    CHECK(listed.text_attribute("/", "interpolation") ==
          "swing: cubic Hermite polynomials, order 4; on: cubic Hermite polynomials, order 4");
}

TEST_CASE("A resumed run has the same frames and samples between steps, to the last bit",
          "[analyses][resume]") {
    const std::string output = "[output]\ninterval = 0.03\nhistory_interval = 0.007\n";
    const std::string deck = GENERATE_COPY(
        as<std::string>{},
        adaptive + output,
        replaced(equal_steps, "time_step = 0.02", "time_step = 0.02\nintegrator = \"gauss-4\"") + output,
        replaced(equal_steps, "time_step = 0.02", "time_step = 0.02\nintegrator = \"generalized-alpha\"") +
            output,
        replaced(equal_steps, "elements = 4", "elements = 3\norder = 2\nelement = \"simo\"") + output,
        replaced(equal_steps,
                 "[rod.r]",
                 "law = { layers = [{ on = \"bending\", stiffness = 5, limit = 0.4 }] }\n[rod.r]") +
            output,
        // Some of them where steps end.
        equal_steps + "[output]\ninterval = 0.05\nhistory_interval = 0.01\n",
        staged + output,
        staged + "[output]\ntimes = [0.01, 0.04, 0.27, 0.31]\n");
    INFO(deck);
    const Problem problem = read(deck);
    const sample::ScratchFolder folder;
    REQUIRE(run_problem(problem, folder / "whole").status == RunStatus::complete);
    const int after = GENERATE(1, 2, 3, 6);
    run_problem(problem, folder / "parts", after);
    REQUIRE(resume_problem(problem, folder / "parts").status == RunStatus::complete);
    const Hdf5Reader whole(folder / "whole");
    const Hdf5Reader parts(folder / "parts");
    CHECK(names_of(whole) == names_of(parts));
    for (const std::string& name : names_of(whole)) {
        INFO(name);
        CHECK(whole.numbers(name) == parts.numbers(name));
    }
}

TEST_CASE("A resumed run takes up other times, and samples", "[analyses][resume]") {
    const sample::ScratchFolder folder;
    run_problem(read(equal_steps + "[output]\nevery = 5\n"), folder / "a", 6);
    const Problem other = read(equal_steps + "[output]\ninterval = 0.05\nhistory_interval = 0.1\n");
    REQUIRE(resume_problem(other, folder / "a").status == RunStatus::complete);
    const Hdf5Reader file(folder / "a");
    const std::vector<double> expected{0.0, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5};
    CHECK(file.numbers(frame_times) == expected);
    CHECK(file.numbers("/sampled/time") == std::vector{0.2, 0.3, 0.4, 0.5});
}

TEST_CASE("Each time is due in one step, whatever the rounding of its ends", "[analyses]") {
    OutputSettings output;
    output.times = {0.1, 0.3, 1.0};
    output.history_interval = 0.1;
    const OutputSchedule schedule(output, 0.0);
    const std::vector<double> ends{0.0, 0.1 * 3.0, 0.55, 0.7000000000000001, 1.0};  // 0.1·3 > 0.3
    std::vector<double> frames, samples;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const std::vector<DueOutput> due = schedule.list(ends[i - 1], ends[i]);
        CHECK(due.back().time == ends[i]);
        for (const DueOutput& each : due) {
            if (each.is_frame) frames.push_back(each.time);
            if (each.is_sample) samples.push_back(each.time);
        }
    }
    CHECK(frames == std::vector{0.1, 0.1 * 3.0, 1.0});
    CHECK(samples.size() == 10);
    CHECK(samples[2] == 0.1 * 3.0);
    CHECK(samples[6] == 0.7000000000000001);
    CHECK(!schedule.list_start().is_frame);
    CHECK(schedule.list_start().is_sample);
    CHECK(OutputSchedule().is_empty());
    // On an axis that has run on before.
    const OutputSchedule later(output, 0.2);
    CHECK(later.list(0.0, 0.1).back().is_frame);
    CHECK(!later.has_inner(0.0, 0.1));
}

}  // namespace gxrod::test
