#include <fmt/format.h>
#include <hdf5.h>
#include <functional>
#include <limits>

#include "deck/problem.hpp"
#include "deck/reading/text_file.hpp"
#include "fuzz/results_sample.hpp"
#include "fuzz/scratch_folder.hpp"
#include "machine/checksum.hpp"
#include "machine/file_error.hpp"
#include "report/report.hpp"
#include "results/csv_export.hpp"
#include "results/hdf5_objects.hpp"
#include "results/hdf5_reader.hpp"
#include "results/results_file.hpp"
#include "results/resumable_file.hpp"
#include "results/series_export.hpp"
#include "tools/catch.hpp"

// What reads results of files whose objects are not what gxrod writes.

namespace gxrod::fuzz {
namespace {

// A results file in which some objects are replaced.
class Damaged {
  public:
    Damaged() : path_(folder_.write("damaged.vtkhdf", results_sample())) {
        file_ = Hdf5Handle(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "opening");
    }

    void change(const std::function<void(hid_t)>& action) { action(file_.id()); }

    void replace_attribute(const char* object,
                           const char* name,
                           std::vector<hsize_t> size,
                           double value = 0.0) {
        H5Adelete_by_name(file_.id(), object, name, H5P_DEFAULT);
        const Hdf5Handle space = make_space(size);
        const Hdf5Handle attribute(H5Acreate_by_name(file_.id(),
                                                     object,
                                                     name,
                                                     H5T_NATIVE_DOUBLE,
                                                     space.id(),
                                                     H5P_DEFAULT,
                                                     H5P_DEFAULT,
                                                     H5P_DEFAULT),
                                   H5Aclose,
                                   "creating");
        const std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())),
                                         value);
        H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, values.data());
    }

    void replace_dataset(const char* name, std::vector<hsize_t> size, double value = 0.0) {
        H5Ldelete(file_.id(), name, H5P_DEFAULT);
        const Hdf5Handle space = make_space(size);
        const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
        const bool is_huge = H5Sget_simple_extent_npoints(space.id()) > 1000000;
        if (is_huge)
            H5Pset_chunk(
                creation.id(), static_cast<int>(size.size()), std::vector<hsize_t>(size.size(), 1).data());
        const Hdf5Handle dataset(
            H5Dcreate2(
                file_.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
            H5Dclose,
            "creating");
        write_label(dataset.id(), {name, "in place of another", "none", "1"});
        if (is_huge) return;
        const std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())),
                                         value);
        H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }

    // All of them, and the checksum behind them.
    void replace_state_numbers(double value, double sum) {
        for (const char* slot : {"/restart/a/numbers", "/restart/b/numbers"}) {
            replace_dataset(slot, {state_numbers + 1, 1}, value);
            const Hdf5Handle dataset(H5Dopen2(file_.id(), slot, H5P_DEFAULT), H5Dclose, "opening");
            std::vector<double> numbers(state_numbers, value);
            numbers.push_back(sum);
            H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
        }
    }
    // Of the slot in use, if all its numbers were this one.
    double sum_of_state(double value) const {
        const Hdf5Reader file(folder_.write("sound.vtkhdf", results_sample()));
        const std::string slot =
            file.integer_attribute("/restart", "slot") == 0 ? "/restart/a/" : "/restart/b/";
        std::uint32_t sum = 0;
        for (const char* table : {"nodes", "sections", "algorithmic", "forces", "force_change", "movement"})
            sum = checksum(std::span<const double>(file.numbers(slot + table)), sum);
        return checksum(std::span<const double>(std::vector<double>(state_numbers, value)), sum);
    }

    std::string report_fault() {
        return fault([&] {
            write_report(
                {.results = path_, .page = folder_.path() / "page.html", .existing = Existing::replace});
        });
    }
    std::string csv_fault() {
        return fault([&] { export_csv(path_, folder_.path() / "csv", Existing::replace); });
    }
    std::string series_fault() {
        return fault([&] { export_series(path_, folder_.path() / "series", Existing::replace); });
    }
    std::string resume_fault() {
        return fault([&] { ResumableFile file(path_); });
    }
    std::string go_on_fault() {
        return fault([&] {
            ResumableFile file(path_);
            const Problem problem = read_resumption(file.deck(), "", {});
            ResultsFile results(problem.record, problem.model, problem.output, std::move(file));
            results.close(RunStatus::complete, "");
        });
    }

  private:
    static constexpr std::size_t state_numbers = 31;

    static Hdf5Handle make_space(const std::vector<hsize_t>& size) {
        return {H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, "dataspace"};
    }

    // What an action says of the file, without its name.
    template <class Action>
    std::string fault(Action&& action) {
        file_.reset();
        try {
            action();
        } catch (const FileError& error) {
            const std::string text = error.what();
            return text.substr(text.find(": ") + 2);
        }
        return "";
    }

    ScratchFolder folder_;
    std::filesystem::path path_;
    Hdf5Handle file_;
};

std::string unreadable(const std::string& why) { return "cannot be read as results of gxrod (" + why + ")"; }

}  // namespace

TEST_CASE("The sample that is damaged can be read", "[issues]") {
    CHECK(Damaged().report_fault() == "");
    CHECK(Damaged().csv_fault() == "");
    CHECK(Damaged().series_fault() == "");
    CHECK(Damaged().resume_fault() == "");
    CHECK(Damaged().go_on_fault() == "");
}

TEST_CASE("Two fields of one name make no frame", "[issues]") {
    const ScratchFolder folder;
    std::string bytes = results_sample();
    const std::size_t at = bytes.find("axis_y");
    REQUIRE(at != std::string::npos);
    bytes[at + 5] = 'x';
    const std::filesystem::path path = folder.write("damaged.vtkhdf", bytes);
    CHECK_THROWS_WITH(
        export_series(path, folder.path() / "series", Existing::replace),
        Catch::Contains("damaged_0000.hdf: cannot be made of the results (creating a dataset: "));
}

TEST_CASE("Rows of another width are an error, not what lies behind them", "[issues]") {
    for (const char* name :
         {"/VTKHDF/PointData/axis_x", "/VTKHDF/PointData/displacement", "/VTKHDF/Points"}) {
        Damaged damaged;
        damaged.replace_dataset(name, {100, 1});
        CHECK(damaged.report_fault() == unreadable(std::string(name) + " has rows of another width"));
    }
    Damaged damaged;
    damaged.replace_dataset("/histories/time", {6, 0});
    CHECK(damaged.report_fault() == unreadable("/histories/time has rows of another width"));
}

TEST_CASE("Counts that are none are an error", "[issues]") {
    for (const double count : {-1.0, 0.5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        Damaged damaged;
        damaged.replace_dataset("/VTKHDF/NumberOfPoints", {1}, count);
        const std::string told =
            unreadable(fmt::format("/VTKHDF/NumberOfPoints is {}, which is no count", count));
        CHECK(damaged.report_fault() == told);
        CHECK(damaged.series_fault() == told);
    }
    for (const double offset : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        Damaged damaged;
        damaged.replace_dataset("/VTKHDF/Offsets", {5}, offset);
        CHECK(damaged.report_fault() == unreadable("a cell has points that are not there"));
    }
}

TEST_CASE("A state of numbers that are none is an error", "[issues]") {
    Damaged damaged;
    damaged.replace_state_numbers(-1e300, 0.0);
    CHECK(damaged.resume_fault() == "cannot be resumed: its state is not the one that was written");
    // As nobody but a forger would write it.
    Damaged forged;
    forged.replace_state_numbers(-1e300, forged.sum_of_state(-1e300));
    CHECK(forged.resume_fault() == "cannot be resumed: its state has a count that is none");
}

TEST_CASE("A state of another version is not gone on from", "[issues]") {
    Damaged damaged;
    damaged.replace_attribute("/restart", "version", {}, 99.0);
    CHECK(damaged.resume_fault() ==
          "cannot be resumed: its state was written in another form, by another version of gxrod");
}

TEST_CASE("No other state is read where none of the two is named", "[issues]") {
    Damaged damaged;
    damaged.replace_attribute("/restart", "slot", {}, 2.0);
    CHECK(damaged.resume_fault() == "cannot be resumed: /restart@slot is damaged");
}

TEST_CASE("A list where one value belongs is an error", "[issues]") {
    Damaged slots;
    slots.replace_attribute("/restart", "slot", {1000});
    CHECK(slots.resume_fault() == "cannot be resumed: /restart@slot is not one value");
    Damaged frames;
    frames.replace_attribute("/VTKHDF/Steps", "NSteps", {1000});
    CHECK(frames.report_fault() == unreadable("/VTKHDF/Steps@NSteps is not one value"));
    Damaged number;
    number.replace_attribute("/", "title", {1});
    CHECK(number.resume_fault() == "cannot be resumed: a text is none");
    Damaged titles;
    titles.replace_attribute("/", "title", {2});
    CHECK(titles.resume_fault() == "cannot be resumed: title is not one value");
    Damaged text;
    text.replace_dataset("/deck/text", {3});
    CHECK(text.resume_fault() == "cannot be resumed: /deck/text is not one value");
}

// A run that goes on would write into them.
TEST_CASE("A file that would lead to others is an error", "[issues]") {
    const std::string told = "is damaged: where HDF5's library reads it, it would go to other files";
    Damaged linked;
    linked.change([](hid_t file) {
        H5Ldelete(file, "/solver", H5P_DEFAULT);
        H5Lcreate_external("other.vtkhdf", "/solver", file, "/solver", H5P_DEFAULT, H5P_DEFAULT);
    });
    CHECK(linked.resume_fault() == told);
    CHECK(linked.csv_fault() == told);
    const hsize_t rows = 6;
    const auto replace_residual = [&](const std::function<void(hid_t)>& set_source) {
        Damaged damaged;
        damaged.change([&](hid_t file) {
            H5Ldelete(file, "/solver/residual", H5P_DEFAULT);
            const Hdf5Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose, "dataspace");
            const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "properties");
            set_source(creation.id());
            H5Dclose(H5Dcreate2(file,
                                "/solver/residual",
                                H5T_IEEE_F64LE,
                                space.id(),
                                H5P_DEFAULT,
                                creation.id(),
                                H5P_DEFAULT));
        });
        return damaged.resume_fault();
    };
    CHECK(replace_residual([](hid_t creation) { H5Pset_external(creation, "other", 0, H5F_UNLIMITED); }) ==
          told);
    CHECK(replace_residual([&](hid_t creation) {
              const Hdf5Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose, "dataspace");
              H5Pset_virtual(creation, space.id(), "other.vtkhdf", "residual", space.id());
          }) == told);
    Damaged soft;
    soft.change([](hid_t file) { H5Lcreate_soft("/solver", file, "/again", H5P_DEFAULT, H5P_DEFAULT); });
    CHECK(soft.csv_fault() == "");
}

TEST_CASE("A dataset that the file is too small for takes no memory", "[issues]") {
    Damaged damaged;
    damaged.replace_dataset("/VTKHDF/Connectivity", {1'000'000'000'000});
    CHECK(damaged.report_fault() ==
          unreadable("/VTKHDF/Connectivity would have 8e+12 bytes, more than its file can hold"));
    CHECK(damaged.series_fault() ==
          unreadable("/VTKHDF/Connectivity would have 8e+12 bytes, more than its file can hold"));
}

TEST_CASE("Rows of more numbers than there are make no columns", "[issues]") {
    Damaged damaged;
    damaged.replace_dataset("/ledger/strain_energy", {1, 1ull << 50});
    const std::string told = unreadable("/ledger/strain_energy has rows of 1125899906842624 numbers");
    CHECK(damaged.report_fault() == told);
    CHECK(damaged.csv_fault() == told);
}

// To cut them off, HDF5 looks for each of their chunks.
TEST_CASE("A run does not go on from rows that the file is too small for", "[issues]") {
    for (const hsize_t rows : {hsize_t{1'000'000}, hsize_t{1} << 40}) {
        Damaged damaged;
        damaged.replace_dataset("/ledger/strain_energy", {rows});
        CHECK(damaged.go_on_fault() == "cannot write: strain_energy has more rows than its file can hold");
    }
}

}  // namespace gxrod::fuzz
