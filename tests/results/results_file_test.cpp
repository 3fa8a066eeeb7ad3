#include "results/results_file.hpp"

#include <chrono>
#include <fstream>
#include <thread>

#include "machine/file_error.hpp"
#include "model/version.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "results/tables/deck_reading.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using sample::Motion;

namespace {

const std::vector<double> times{0.0, 0.25, 0.5, 1.0, 2.0};

// Writes all times as steps, and every second one as a frame.
void write_sample(const std::filesystem::path& path, const Model& model) {
    ResultsFile file({path, Existing::refuse}, sample::make_deck(), model, sample::make_output());
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Motion motion(times[i]);
        file.record_step(motion.snapshot(), sample::make_ledger(times[i]), sample::make_solver(times[i]));
        if (i % 2 == 0) file.write_frame(motion.snapshot());
        if (i == 1) file.flush();
    }
    file.close(RunStatus::complete, "end_time reached");
}

std::vector<double> row(const std::vector<double>& values, std::size_t index, std::size_t width) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(index * width);
    return {first, first + static_cast<std::ptrdiff_t>(width)};
}

std::vector<double> components(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

}  // namespace

TEST_CASE("A results file says where it came from and how the run ended", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    write_sample(folder / "a.vtkhdf", model);
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.text_attribute("/", "gxrod_version") == version);
    CHECK(file.text_attribute("/", "deck_name") == "sample.toml");
    CHECK(file.text_attribute("/", "title") == "Sample");
    CHECK(file.text_attribute("/", "units") == "m kg s");
    CHECK(file.text_attribute("/", "analysis") == "dynamic");
    CHECK(file.text_attribute("/", "integrator") == "sdirk-4");
    CHECK(file.text_attribute("/histories/time", "dimension") == "time");
    CHECK(file.text_attribute("/", "status") == "complete");
    CHECK(file.text_attribute("/", "reason") == "end_time reached");
    CHECK(file.integers_attribute("/", "reason_nodes").empty());
    CHECK(file.text("/deck/text") == sample::make_deck().text);
    CHECK(file.text_attribute("/", "deck_sha256") ==
          "c1c7f3d5767ceb9512dbc81f7791fb113e3075f03cad1b0c7141ffd86fbf0550");
}

TEST_CASE("A failed run's file numbers the nodes that its reason names", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    {
        ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
        file.close(RunStatus::failed, "singular at rod.end (ry), body (x)", std::vector<std::int64_t>{2, 1});
    }
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.integers_attribute("/", "reason_nodes") == std::vector<std::int64_t>{2, 1});
}

TEST_CASE("The time of a static run is a load factor", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    DeckRecord deck = sample::make_deck();
    deck.is_static = true;
    { ResultsFile file({folder / "a.vtkhdf"}, deck, model, OutputSettings{}); }
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.text_attribute("/", "analysis") == "static");
    CHECK(file.text_attribute("/histories/time", "dimension") == "1");
    CHECK(file.text_attribute("/ledger/time", "description") ==
          "load factor at the end of each accepted step");
}

TEST_CASE("The deck and its meshes come back from a results file", "[results]") {
    const sample::ScratchFolder folder;
    DeckRecord deck = sample::make_deck();
    deck.is_static = true;
    deck.meshes = {{"meshes/a.geo", "Point(1) = {0, 0, 0};\n"}, {"other/a.geo", std::string("\0\xff", 2)}};
    const Model model = sample::make_model();
    ResultsFile({folder / "mesh"}, deck, model, sample::make_output()).close(RunStatus::complete, "");
    const DeckRecord read = read_deck_record(Hdf5Reader(folder / "mesh"));
    CHECK(read.name == deck.name);
    CHECK(read.text == deck.text);
    CHECK(read.title == deck.title);
    CHECK(read.units == deck.units);
    CHECK(read.is_static);
    REQUIRE(read.meshes.size() == 2);
    // By the names under which they are kept.
    CHECK(read.meshes[0].file == "other/a.geo");
    CHECK(read.meshes[0].bytes == deck.meshes[1].bytes);
    CHECK(read.meshes[1].file == "meshes/a.geo");
    CHECK(read.meshes[1].bytes == deck.meshes[0].bytes);
}

TEST_CASE("A results file has the meshes that its deck read", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    DeckRecord deck = sample::make_deck();
    deck.meshes = {{"meshes/a.geo", "Point(1) = {0, 0, 0};\n"}, {"other/a.geo", std::string("\0\xff", 2)}};
    { ResultsFile file({folder / "a.vtkhdf"}, deck, model, OutputSettings{}); }
    const Hdf5Reader file(folder / "a.vtkhdf");
    const auto bytes = [&](const std::string& dataset) {
        std::string text;
        for (const double value : file.numbers(dataset))
            text += static_cast<char>(static_cast<unsigned char>(value));
        return text;
    };
    CHECK(bytes("/deck/meshes/a.geo") == deck.meshes[0].bytes);
    CHECK(bytes("/deck/meshes/2_a.geo") == deck.meshes[1].bytes);
    CHECK(file.text_attribute("/deck/meshes/a.geo", "file") == "meshes/a.geo");
    CHECK(file.text_attribute("/deck/meshes/2_a.geo", "file") == "other/a.geo");
    CHECK(file.text_attribute("/deck/meshes/a.geo", "sha256") ==
          "b80970af57d56e58d800d0547d318c3300f82216d6360ae6a3e55d51bbc816ad");
    CHECK(!file.text_attribute("/deck/meshes/a.geo", "description").empty());
}

TEST_CASE("Every dataset of a results file is described", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    write_sample(folder / "a.vtkhdf", model);
    const Hdf5Reader file(folder / "a.vtkhdf");
    const std::vector<std::string> datasets = file.datasets();
    CHECK(datasets.size() == 135);
    for (const std::string& dataset : datasets) {
        INFO(dataset);
        CHECK(!file.text_attribute(dataset, "description").empty());
        const std::string frame = file.text_attribute(dataset, "frame");
        CHECK((frame == "spatial" || frame == "material" || frame == "none"));
        const bool is_text = dataset == "/deck/text" || dataset == "/rods/name" || dataset == "/rods/section";
        if (!is_text) CHECK(!file.text_attribute(dataset, "dimension").empty());
    }
    CHECK(file.text_attribute("/histories/root/force", "frame") == "material");
    CHECK(file.text_attribute("/histories/root/force_spatial", "frame") == "spatial");
    CHECK(file.text_attribute("/histories/root/moment", "dimension") == "force·length");
    CHECK(file.text_attribute("/histories/root", "at") == "beam.start");
    CHECK(file.text_attribute("/VTKHDF/CellData/moment", "frame") == "material");
}

TEST_CASE("A history that is relative to a point says so", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    OutputSettings output;
    output.histories = {{.name = "seen",
                         .at = "gyro",
                         .target = WatchedBody{.index = 1, .node = 3},
                         .quantities = {"position", "orientation", "quaternion"}},
                        {.name = "seen_middle",
                         .at = "beam@0.5",
                         .target = WatchedPoint{{0, 0, 1.0}, 1},
                         .quantities = {"quaternion"}}};
    for (HistoryRequest& history : output.histories) {
        history.relative_to = "beam.start";
        history.relative_node = 0;
    }
    ResultsFile results({folder / "a.vtkhdf", Existing::refuse}, sample::make_deck(), model, output);
    results.record_step(Motion(0.5).snapshot(), {}, {});
    results.close(RunStatus::complete, "");
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.text_attribute("/histories/seen", "relative_to") == "beam.start");
    for (const char* quantity : {"position", "orientation", "quaternion"}) {
        CHECK(file.text_attribute(std::string("/histories/seen/") + quantity, "frame") ==
              "axes of beam.start");
    }
    CHECK(file.text_attribute("/histories/seen/position", "description") ==
          "position, as seen from beam.start and its axes");
    CHECK(file.text_attribute("/histories/seen/orientation", "description") ==
          "unit quaternion w x y z: body axes from the axes of beam.start");
    CHECK(file.text_attribute("/histories/seen_middle/quaternion", "description") ==
          "unit quaternion w x y z: since t = 0, as seen from the axes of beam.start");
}

TEST_CASE("Histories, ledger and solver record have a row for each step", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    write_sample(folder / "a.vtkhdf", model);
    const Hdf5Reader file(folder / "a.vtkhdf");
    for (const char* name : {"/histories/time", "/ledger/time", "/solver/time"})
        CHECK(file.numbers(name) == times);

    const hsize_t steps = times.size();
    CHECK(file.size("/histories/gyro/position") == std::vector<hsize_t>{steps, 3});
    CHECK(file.size("/histories/gyro/quaternion") == std::vector<hsize_t>{steps, 4});
    CHECK(file.size("/ledger/angular_momentum") == std::vector<hsize_t>{steps, 3});
    CHECK(file.size("/solver/newton_iterations") == std::vector<hsize_t>{steps});
    for (std::size_t i = 0; i < times.size(); ++i) {
        INFO("step " << i);
        const LedgerRow ledger = sample::make_ledger(times[i]);
        CHECK(file.numbers("/ledger/kinetic_energy")[i] == ledger.kinetic_energy);
        CHECK(file.numbers("/ledger/strain_energy")[i] == ledger.strain_energy);
        CHECK(file.numbers("/ledger/external_work")[i] == ledger.external_work);
        CHECK(file.numbers("/ledger/work_uncertainty")[i] == ledger.work_uncertainty);
        CHECK(file.numbers("/ledger/dissipated_energy")[i] == ledger.dissipated_energy);
        CHECK(file.numbers("/ledger/numerical_dissipation")[i] == ledger.numerical_dissipation);
        CHECK(file.numbers("/ledger/fluid_work")[i] == ledger.fluid_work);
        CHECK(file.numbers("/ledger/energy_error")[i] == ledger.energy_error);
        CHECK(row(file.numbers("/ledger/linear_momentum"), i, 3) == components(ledger.linear_momentum));
        CHECK(row(file.numbers("/ledger/angular_momentum"), i, 3) == components(ledger.angular_momentum));
        const SolverRow solver = sample::make_solver(times[i]);
        CHECK(file.numbers("/solver/time_step")[i] == solver.time_step);
        CHECK(file.numbers("/solver/newton_iterations")[i] == solver.newton_iterations);
        CHECK(file.numbers("/solver/residual")[i] == solver.residual);
        CHECK(file.numbers("/solver/rejected_steps")[i] == solver.rejected_steps);
        const Motion motion(times[i]);
        CHECK(row(file.numbers("/histories/gyro/velocity"), i, 3) == components(motion.nodes[3].v));
        CHECK(row(file.numbers("/histories/middle/position"), i, 3) == components(motion.nodes[1].r));
        CHECK(row(file.numbers("/histories/middle/moment"), i, 3) == components(motion.points[0].moment));
    }
}

TEST_CASE("A results file that is not closed is readable and says running", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    {
        ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        const Motion motion(0.5);
        file.record_step(motion.snapshot(), sample::make_ledger(0.5), sample::make_solver(0.5));
    }
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.text_attribute("/", "status") == "running");
    CHECK(file.text_attribute("/", "reason").empty());
    CHECK(file.numbers("/histories/time") == std::vector<double>{0.5});
}

TEST_CASE("A results file can be read while it is being written", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, sample::make_output());
    for (const double time : times) {
        const Motion motion(time);
        file.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
        file.flush();
        CHECK(Hdf5Reader(folder / "a.vtkhdf").numbers("/histories/time").back() == time);
    }
}

TEST_CASE("After a while, or with much to write, a flush is due", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, sample::make_output());
    const Motion motion(0.0);
    CHECK(!file.is_flush_due());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    CHECK(file.is_flush_due());
    file.flush();
    CHECK(!file.is_flush_due());
    for (int i = 0; i < 50000; ++i) {
        file.record_step(motion.snapshot(), sample::make_ledger(0.0), sample::make_solver(0.0));
    }
    CHECK(file.is_flush_due());
}

TEST_CASE("Two results files can be open at once", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    {
        ResultsFile first({folder / "a.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        ResultsFile second({folder / "b.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        for (const double time : times) {
            const Motion motion(time);
            first.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
            second.record_step(motion.snapshot(), sample::make_ledger(time), sample::make_solver(time));
            second.write_frame(motion.snapshot());
        }
        first.close(RunStatus::complete, "");
        second.close(RunStatus::failed, "");
    }
    const Hdf5Reader first(folder / "a.vtkhdf"), second(folder / "b.vtkhdf");
    CHECK(first.numbers("/histories/time") == times);
    CHECK(second.numbers("/histories/time") == times);
    CHECK(first.integer_attribute("/VTKHDF/Steps", "NSteps") == 0);
    CHECK(second.integer_attribute("/VTKHDF/Steps", "NSteps") == 5);
}

TEST_CASE("Equal runs write equal results files", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    write_sample(folder / "a.vtkhdf", model);
    write_sample(folder / "b.vtkhdf", model);
    const auto read = [](const std::filesystem::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    CHECK(read(folder / "a.vtkhdf") == read(folder / "b.vtkhdf"));
}

TEST_CASE("A model without histories, rods or bodies of one kind writes results too", "[results]") {
    const sample::ScratchFolder folder;
    Model model = sample::make_model();
    model.rods.clear();
    Motion motion(1.0);
    motion.elements.clear();
    {
        ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
        file.record_step(motion.snapshot(), sample::make_ledger(1.0), sample::make_solver(1.0));
        file.write_frame(motion.snapshot());
        file.close(RunStatus::interrupted, "Ctrl-C");
    }
    const Hdf5Reader file(folder / "a.vtkhdf");
    CHECK(file.text_attribute("/", "status") == "interrupted");
    CHECK(file.numbers("/VTKHDF/Types") == std::vector<double>{1, 1});
    CHECK(file.size("/VTKHDF/CellData/force") == std::vector<hsize_t>{2, 3});
}
