#include <sys/resource.h>

#include <map>
#include <random>

#include "machine/file_error.hpp"
#include "results/file/file_seal.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/restart/restart_table.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "results/tables/deck_reading.hpp"
#include "results/traced_writer.hpp"
#include "tools/catch.hpp"

// What is left of a results file whose writer is killed, or whose disk is full.

using namespace gxrod;
using test::run_child, test::wait_for;

namespace {

constexpr double time_step = 0.125;  // exact in binary
constexpr std::size_t points = 4;    // of the sample

double time_of(std::size_t step) { return time_step * static_cast<double>(step); }

// Adds `count` steps from `first` on, every eighth of them as a frame too.
void write_steps(ResultsFile& file, sample::Motion& motion, std::size_t first, std::size_t count) {
    for (std::size_t step = first; step < first + count; ++step) {
        const double time = time_of(step);
        motion.time = time;
        for (NodeMotion& node : motion.nodes) node.r = Vec3(time, 2.0 * time, 3.0 * time);
        file.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
        if (step % 8 == 0) file.write_frame(motion.snapshot());
    }
}

OutputSettings make_output(Compression compression = Compression::none) {
    OutputSettings output;
    output.compression = compression;
    output.histories = {sample::make_output().histories[0]};
    output.histories[0].quantities = {"position", "quaternion"};
    return output;
}

bool is_multiple_of_time(const std::vector<double>& values,
                         std::size_t columns,
                         std::size_t rows_a_step,
                         double step) {
    if (values.size() % columns != 0) return false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double time = step * static_cast<double>(i / columns / rows_a_step);
        if (values[i] != time * static_cast<double>(i % columns + 1)) return false;
    }
    return true;
}

std::size_t counted_frames(const Hdf5Reader& file) {
    return static_cast<std::size_t>(file.integer_attribute("/VTKHDF/Steps", "NSteps"));
}

// Frames that have their time.
std::size_t timed_frames(const Hdf5Reader& file) { return file.size("/VTKHDF/Steps/Values")[0]; }

struct Survey {
    std::size_t steps = 0;
    std::size_t frames = 0;
    std::string fault;  // empty if all is well
};

// What is wrong with the state to resume from, or "". Without one there were no more than first steps.
std::string examine_restart(const Hdf5Reader& file, const Survey& found) {
    const std::optional<RestartPlace> place = read_restart(file);
    if (!place) return found.steps > 10000 ? "no restart" : "";
    const double time = place->record.steps.time;
    if (place->record.nodes.size() != points) return "restart nodes";
    for (const NodeMotion& node : place->record.nodes) {
        if (node.r != Vec3(time, 2.0 * time, 3.0 * time)) return "restart of several times";
    }
    file.rows("/histories/middle/position", 0, place->steps);
    file.rows("/VTKHDF/Points", 0, place->frames * points);
    return "";
}

// Reads as many steps and frames as the file says it has, and compares them with what was written.
Survey survey(const std::filesystem::path& path) {
    Survey found;
    try {
        const Hdf5Reader file(path);
        found.steps = file.size("/histories/time")[0];
        found.frames = timed_frames(file);
        if (found.frames > counted_frames(file)) found.fault = "more times of frames than VTK has room for";
        if (!is_multiple_of_time(file.numbers("/histories/time"), 1, 1, time_step)) found.fault = "times";
        if (!is_multiple_of_time(file.rows("/histories/middle/position", 0, found.steps), 3, 1, time_step)) {
            found.fault = "positions";
        }
        if (!is_multiple_of_time(
                file.rows("/VTKHDF/Points", 0, found.frames * points), 3, points, 8 * time_step)) {
            found.fault = "points";
        }
        if (!is_multiple_of_time(file.rows("/VTKHDF/Steps/Values", 0, found.frames), 1, 1, 8 * time_step)) {
            found.fault = "frame times";
        }
        if (const std::string fault = examine_restart(file, found); !fault.empty()) found.fault = fault;
        read_deck_record(file);
        for (const char* name : {"gxrod_version", "deck_sha256", "reason", "warnings"})
            file.text_attribute("/", name);
        file.integers_attribute("/", "reason_nodes");
        const std::string status = file.text_attribute("/", "status");
        if (status != "running" && status != "complete") found.fault = "status " + status;
    } catch (const std::exception& error) {
        found.fault = error.what();
    }
    return found;
}

// Every dataset holds at least the rows that the counts promise.
bool is_complete(const std::filesystem::path& path) {
    const Hdf5Reader file(path);
    const std::size_t steps = file.size("/histories/time")[0];
    const std::size_t frames = counted_frames(file);
    for (const std::string& dataset : file.datasets()) {
        const bool is_step_row = dataset.starts_with("/histories") || dataset.starts_with("/ledger") ||
                                 dataset.starts_with("/solver");
        // Places of cells and points along rods are stored once.
        const std::string name = dataset.substr(dataset.rfind('/') + 1);
        if (!dataset.starts_with("/VTKHDF/Steps") &&
            (name == "rod" || name == "element" || name == "arc_length"))
            continue;
        const bool is_point_row = dataset.starts_with("/VTKHDF/PointData") ||
                                  dataset.starts_with("/VTKHDF/CellData") || dataset == "/VTKHDF/Points";
        const bool is_frame_row = dataset.starts_with("/VTKHDF/Steps");
        const std::size_t rows = is_step_row                         ? steps
                                 : dataset == "/VTKHDF/Steps/Values" ? 0
                                 : is_point_row                      ? frames * points
                                 : is_frame_row                      ? frames
                                                                     : 0;
        if (rows > 0) file.rows(dataset, 0, rows);
    }
    return true;
}

}  // namespace

TEST_CASE("A killed writer leaves a file with everything that it had flushed", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    std::mt19937 random(7);
    std::size_t most_steps = 0;
    for (int attempt = 0; attempt < 40; ++attempt) {
        const Compression compression = attempt % 2 == 0 ? Compression::none : Compression::deflate;
        const auto path = folder / ("killed" + std::to_string(attempt));
        int flushed[2];
        REQUIRE(::pipe(flushed) == 0);
        const pid_t child = run_child([&] {
            ResultsFile file({path}, sample::make_deck(), model, make_output(compression));
            sample::Motion motion(0.0);
            for (std::size_t step = 0;; step += 37) {
                write_steps(file, motion, step, 37);
                file.flush();
                const std::size_t done = step + 37;
                if (::write(flushed[1], &done, sizeof done) < 0) return 1;
            }
        });
        ::close(flushed[1]);
        std::size_t done = 0;
        REQUIRE(::read(flushed[0], &done, sizeof done) == sizeof done);
        ::usleep(std::uniform_int_distribution<unsigned>(0, 40000)(random));
        ::kill(child, SIGKILL);
        CHECK(WIFSIGNALED(wait_for(child)));
        while (::read(flushed[0], &done, sizeof done) == sizeof done) {
        }
        ::close(flushed[0]);

        const Survey found = survey(path);
        INFO("attempt " << attempt << " steps " << found.steps << " flushed " << done);
        CHECK(found.fault == "");
        CHECK(found.steps >= done);
        CHECK(is_complete(path));
        most_steps = std::max(most_steps, found.steps);
    }
    CHECK(most_steps > 10 * 37);
}

namespace {

// What a writer's file was like before each of its writes.
struct Watch {
    std::size_t checks = 0;
    std::map<SealState, int> seals;
    Survey last;
    test::TraceEnd end = test::TraceEnd::left_off;
};

// Counts can fall once, to no less than what a run resumes from.
Watch watch_writes(pid_t child, const std::filesystem::path& path, const Survey& least) {
    Watch watch;
    // With nothing to resume from, none must be lost.
    int step_falls = least.steps > 0 ? 0 : 1;
    int frame_falls = step_falls;
    watch.end = test::trace_writes(child, [&] {
        Survey found = survey(path);
        if (watch.checks % 8 == 0) ++watch.seals[look_at_seal(path)];
        if (found.steps < least.steps || found.frames < least.frames) found.fault = "too few steps";
        step_falls += found.steps < watch.last.steps;
        frame_falls += found.frames < watch.last.frames;
        if (step_falls > 1 || frame_falls > 1) found.fault = "fewer steps than before";
        watch.last = found;
        if (++watch.checks % 50 == 0) CHECK(is_complete(path));
        return watch.last.fault.empty();
    });
    return watch;
}

void check_watch(const Watch& watch,
                 const std::filesystem::path& path,
                 std::size_t last_step,
                 std::size_t least_checks) {
    INFO("after " << watch.checks << " writes and " << watch.last.steps << " steps");
    CHECK(watch.last.fault == "");
    CHECK(watch.end == test::TraceEnd::ended_well);
    CHECK(watch.last.steps == last_step);
    CHECK(watch.checks > least_checks);
    CHECK(is_complete(path));
    CHECK(survey(path).fault == "");
    CHECK(watch.seals.size() == 2);
    CHECK(watch.seals.at(SealState::open) > 10);
    CHECK(watch.seals.at(SealState::kept) > 0);
    CHECK(look_at_seal(path) == SealState::kept);
}

}  // namespace

TEST_CASE("Between any two system calls of its writer the file is whole", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "traced";
    constexpr std::size_t last_step = 21500;
    const pid_t child = run_child([&] {
        if (!test::may_be_traced()) return test::exit_not_allowed;
        ResultsFile file({path}, sample::make_deck(), model, make_output());
        ::raise(SIGSTOP);
        // The leaps come just before B-trees split: at the root after 64 chunks, below it after about 120.
        sample::Motion motion(0.0);
        for (std::size_t step = 0; step < last_step;) {
            const std::size_t count = step == 1000 ? 9000 : step == 11500 ? 8500 : 500;
            write_steps(file, motion, step, count);
            file.set_restart(sample::make_restart(time_of(step)));
            file.flush();
            step += count;
        }
        file.close(RunStatus::complete, "end_time reached", std::vector<std::int64_t>{2, 0, 1});
        return 0;
    });

    const Watch watch = watch_writes(child, path, {});
    if (watch.end == test::TraceEnd::not_allowed) {
        WARN("skipped: processes may not be traced here");
        return;
    }
    check_watch(watch, path, last_step, 1000);
}

TEST_CASE("Between any two system calls of a resumed writer the file is whole", "[results][resume]") {
    const Compression compression = GENERATE(Compression::none, Compression::deflate);
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "traced";
    constexpr std::size_t first_steps = 1200;
    constexpr std::size_t lost_steps = 400;
    constexpr std::size_t last_step = 1600;
    {
        ResultsFile file({path}, sample::make_deck(), model, make_output(compression));
        sample::Motion motion(0.0);
        write_steps(file, motion, 0, first_steps);
        file.set_restart(sample::make_restart(time_of(first_steps - 1)));
        file.flush();
        // As a killed writer can leave it: more steps and frames than the run resumes from.
        write_steps(file, motion, first_steps, lost_steps);
        file.flush();
    }
    const pid_t child = run_child([&] {
        if (!test::may_be_traced()) return test::exit_not_allowed;
        ResumableFile resumed(path);
        DeckRecord deck = sample::make_deck();
        deck.text += "# another one, long enough for a place of its own" + std::string(5000, '!') + "\n";
        OutputSettings output = make_output(compression);
        // So many new groups that the trees and heaps of the group grow.
        for (int i = 0; i < 30; ++i) {
            output.histories.push_back(output.histories[0]);
            output.histories.back().name = "later_history_" + std::to_string(i);
        }
        ::raise(SIGSTOP);
        ResultsFile file(deck, model, output, std::move(resumed));
        // Frames that are compressed to another length than those that they replace.
        sample::Motion motion(0.0);
        for (NodeMotion& node : motion.nodes) node.v = Vec3(0.1, 0.7, 1.3) / (1.0 + node.v.norm());
        for (std::size_t step = first_steps; step < last_step; step += 400) {
            write_steps(file, motion, step, 400);
            file.set_restart(sample::make_restart(time_of(step)));
            file.flush();
        }
        file.close(RunStatus::complete, "end_time reached", std::vector<std::int64_t>{2, 0, 1});
        return 0;
    });
    const Watch watch = watch_writes(child, path, {first_steps, first_steps / 8, ""});
    if (watch.end == test::TraceEnd::not_allowed) return;
    check_watch(watch, path, last_step, 200);
}

TEST_CASE("A full disk is an error, and what was written before stays", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "full";
    const pid_t child = run_child([&] {
        try {
            ResultsFile file({path}, sample::make_deck(), model, make_output());
            const rlimit limit{3000000, RLIM_INFINITY};
            ::setrlimit(RLIMIT_FSIZE, &limit);
            sample::Motion motion(0.0);
            for (std::size_t step = 0; step < 100000; step += 500) {
                write_steps(file, motion, step, 500);
                file.flush();
            }
        } catch (const FileError& error) {
            const bool names_file = std::string(error.what()).find(path.string()) != std::string::npos;
            return names_file ? 0 : 2;
        }
        return 1;
    });
    const int status = wait_for(child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    const Survey found = survey(path);
    CHECK(found.fault == "");
    CHECK(found.steps > 500);
    CHECK(is_complete(path));
}

TEST_CASE("A results file that the disk has no space for is removed", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "full";
    const pid_t child = run_child([&] {
        const rlimit limit{1000, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            ResultsFile file({path}, sample::make_deck(), model, make_output());
        } catch (const FileError&) {
            return 0;
        }
        return 1;
    });
    const int status = wait_for(child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(!std::filesystem::exists(path));
}
