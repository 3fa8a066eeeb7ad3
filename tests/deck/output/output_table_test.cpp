#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Lines 1 to 27: at rest for a load step, then 1 and 2 of time with a load step between.
std::string staged() {
    return replaced(rod_deck, "[analysis]\nkind = \"dynamic\"\nend_time = 1.0\nsteps = 10\n", "") +
           R"([[support]]
at = "r.start"
fix = "all"
[[stage]]
name = "preload"
kind = "static"
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 1
steps = 10
[[stage]]
name = "hold"
kind = "static"
[[stage]]
name = "release"
kind = "dynamic"
end_time = 2
steps = 10
)";
}

std::string faults_with(const std::string& lines) { return faults_of(body_deck + "[output]\n" + lines); }

}  // namespace

TEST_CASE("Frames come every so many steps, at an interval or at times", "[deck]") {
    CHECK(faults_with("interval = 0.25\nhistory_interval = 0.1\n").empty());
    CHECK(faults_with("times = [0, 0.25, 1]\n").empty());
    CHECK(faults_with("every = 2\ninterval = 0.1\n") ==
          "x.toml:10:1: output.interval: every is given too; only one of them can be");
    CHECK(faults_with("interval = 0.1\ntimes = [0.5]\n") ==
          "x.toml:10:1: output.times: interval is given too; only one of them can be");
    CHECK(faults_with("intervall = 0.1\n") ==
          "x.toml:9:1: output.intervall: unknown key; did you mean \"interval\"?");
}

TEST_CASE("Times of output are positive, in order and within the analysis", "[deck]") {
    CHECK(faults_with("interval = 0\n") ==
          "x.toml:9:12: output.interval: expected a number greater than 0, found 0");
    CHECK(faults_with("history_interval = -1\n") ==
          "x.toml:9:20: output.history_interval: expected a number greater than 0, found -1");
    CHECK(faults_with("interval = 1e-13\n") ==
          "x.toml:9:12: output.interval: goes 1e+13 times into the time of a stage");
    CHECK(faults_with("times = [-1, 0]\n") ==
          "x.toml:9:9: output.times: expected times that are not negative, found -1");
    CHECK(faults_with("times = [0.5, 0.5]\n") ==
          "x.toml:9:9: output.times: expected times in order; 0.5 follows 0.5");
    CHECK(faults_with("times = [0.5, 1.5]\n") ==
          "x.toml:9:9: output.times: 1.5 is after the end of the analysis, 1");
}

TEST_CASE("Output at times needs a stage with time", "[deck]") {
    CHECK(faults_of(static_rod_deck + "[output]\ninterval = 0.1\nhistory_interval = 0.1\n") ==
          "x.toml:12:12: output.interval: only a dynamic or quasi-static analysis has time between its "
          "steps; every = … counts steps\n"
          "x.toml:13:20: output.history_interval: only a dynamic or quasi-static analysis has time between "
          "its steps");
    CHECK(faults_of(staged() + "[output]\ninterval = 0.1\n").empty());
    CHECK(faults_of(staged() + "[output]\ntimes = [0.5, 1, 2, 3.5, 4]\n").empty());
    CHECK(faults_of(staged() + "[output]\ntimes = [0.5, 1.5]\n") ==
          "x.toml:29:9: output.times: 1.5 lies in stage hold, which has no time");
    CHECK(faults_of(staged() + "[output]\ntimes = [4.5]\n") ==
          "x.toml:29:9: output.times: 4.5 is after the end of the analysis, 4");
    const std::string with_path = replaced(staged(),
                                           "name = \"preload\"\nkind = \"static\"",
                                           "name = \"preload\"\nkind = \"path\"\nuntil = { t = 1 }");
    CHECK(faults_of(with_path + "[output]\ntimes = [0.5]\n") ==
          "x.toml:30:9: output.times: where stages begin after a path is not known beforehand; "
          "output.interval needs no such times");
    CHECK(faults_of(with_path + "[output]\ninterval = 0.5\n").empty());
}

}  // namespace gxrod::test
