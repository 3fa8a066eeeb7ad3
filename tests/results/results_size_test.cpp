#include "results/results_size.hpp"

#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr long steps = 2000;
constexpr long every = 4;

std::uintmax_t write_results(const std::filesystem::path& path) {
    const Model model = sample::make_model();
    ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
    for (long step = 0; step <= steps; ++step) {
        const sample::Motion motion(0.125 * static_cast<double>(step));
        file.record_step(motion.snapshot(), {}, {});
        if (step % every == 0) file.write_frame(motion.snapshot());
    }
    file.close(RunStatus::complete, "");
    return std::filesystem::file_size(path);
}

}  // namespace

TEST_CASE("The size of results is known before the run", "[results]") {
    const sample::ScratchFolder folder;
    OutputSettings output = sample::make_output();
    output.every = every;
    DynamicSettings dynamic;
    dynamic.end_time = 1.0;
    dynamic.steps = steps;
    const ResultsSize size = estimate_results_size(sample::make_model(), dynamic, output);
    CHECK(size.steps == steps);
    CHECK(size.frames == 1 + steps / every);
    const auto written = static_cast<double>(write_results(folder / "size.vtkhdf"));
    CHECK(size.bytes < written);
    // The rest is HDF5's index, which is most where rows are short.
    CHECK(size.bytes > 0.8 * written);
}

TEST_CASE("Only the size that the deck determines is estimated", "[results]") {
    const Model model = sample::make_model();
    OutputSettings output;
    DynamicSettings dynamic;
    dynamic.end_time = 1.0;
    dynamic.steps = 1000;
    const double with_frames = estimate_results_size(model, dynamic, output).bytes;
    output.compression = Compression::deflate;
    const double of_steps = estimate_results_size(model, dynamic, output).bytes;
    CHECK(of_steps < with_frames);
    CHECK(of_steps > 0.0);
    dynamic.adaptive = AdaptiveSettings{};
    CHECK(estimate_results_size(model, dynamic, output).bytes == 0.0);
    // But frames at times, and samples, do not follow the steps.
    OutputSettings by_time;
    by_time.interval = 0.1;
    const ResultsSize frames = estimate_results_size(model, dynamic, by_time);
    CHECK(frames.frames == 11.0);
    CHECK(frames.steps == 0.0);
    CHECK(frames.bytes > 0.0);
    by_time.history_interval = 1e-3;
    CHECK(estimate_results_size(model, dynamic, by_time).bytes > frames.bytes + 7999.0);
    by_time = {};
    by_time.times = {0.1, 0.7};
    CHECK(estimate_results_size(model, dynamic, by_time).frames == 4.0);
    StaticSettings load_steps;
    load_steps.steps = 9;
    output.every = 4;
    CHECK(estimate_results_size(model, load_steps, output).frames == 4.0);
}
