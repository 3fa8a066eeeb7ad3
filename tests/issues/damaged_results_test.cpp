#include <fmt/format.h>
#include <hdf5.h>

#include <functional>
#include <random>

#include "deck/problem.hpp"
#include "deck/text/text_file.hpp"
#include "fuzz/scratch_folder.hpp"
#include "issues/results_sample.hpp"
#include "machine/file_error.hpp"
#include "report/report.hpp"
#include "results/export/csv_export.hpp"
#include "results/export/series_export.hpp"
#include "results/file/guarded_reading.hpp"
#include "results/file/hdf5_objects.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/results_file.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"

// What reads results of files whose objects are not what gxrod writes.

namespace gxrod::test {
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

    // What is in one of those that follow each other at a place.
    void change_number(const char* name, std::size_t at) {
        const Hdf5Handle dataset(H5Dopen2(file_.id(), name, H5P_DEFAULT), H5Dclose, "opening");
        const hsize_t count = H5Dget_storage_size(dataset.id()) / sizeof(double);
        std::vector<double> numbers(count);
        H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
        numbers.at(at) += 1.0;
        H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    }
    // As if the run had been killed while it wrote.
    void open_seal() {
        file_.reset();
        sample::open_seal(path_);
    }

    std::string report_fault() {
        return fault([&] {
            write_report(
                {.results = path_, .page = folder_.path() / "page.html", .existing = Existing::replace});
        });
    }
    std::string csv_fault() {
        return reading_fault([&] { export_csv(path_, folder_.path() / "csv", Existing::replace); });
    }
    std::string series_fault() {
        return reading_fault([&] { export_series(path_, folder_.path() / "series", Existing::replace); });
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

    // The same of what reads it as gxrod's verbs do.
    template <class Action>
    std::string reading_fault(Action&& action) {
        return fault([&] {
            GuardedReading(path_).read([&] {
                action();
                return std::string();
            });
        });
    }

    fuzz::ScratchFolder folder_;
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

TEST_CASE("Rows of another width are an error", "[issues]") {
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

TEST_CASE("Invalid counts are an error", "[issues]") {
    for (const double count : {-1.0, 0.5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        Damaged damaged;
        damaged.replace_dataset("/VTKHDF/NumberOfPoints", {1}, count);
        const std::string told =
            unreadable(fmt::format("/VTKHDF/NumberOfPoints is {}, which is not a count", count));
        CHECK(damaged.report_fault() == told);
        CHECK(damaged.series_fault() == told);
    }
    for (const double offset : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        Damaged damaged;
        damaged.replace_dataset("/VTKHDF/Offsets", {5}, offset);
        CHECK(damaged.report_fault() == unreadable("a cell has points that are not there"));
    }
}

TEST_CASE("A dataset that the file is too small for takes no memory", "[issues]") {
    Damaged damaged;
    damaged.replace_dataset("/VTKHDF/Connectivity", {1'000'000'000'000});
    const std::string told =
        unreadable("/VTKHDF/Connectivity would have 8e+12 bytes, more than its file can hold");
    CHECK(damaged.report_fault() == told);
    CHECK(damaged.series_fault() == told);
}

TEST_CASE("A state has a checksum of its own, for files of runs that were killed in a write", "[issues]") {
    for (const char* table : {"nodes", "numbers"}) {
        Damaged damaged;
        for (const char* slot : {"/restart/a/", "/restart/b/"})
            damaged.change_number((std::string(slot) + table).c_str(), 3);
        damaged.open_seal();
        CHECK(damaged.resume_fault() ==
              "cannot be resumed: its state does not have the checksum that was written with it (if its "
              "run was stopped before it first wrote, gxrod run --force starts it again)");
    }
}

TEST_CASE("A state of another version is not resumed", "[issues]") {
    Damaged damaged;
    damaged.replace_attribute("/restart", "version", {}, 99.0);
    damaged.open_seal();
    CHECK(damaged.resume_fault() ==
          "cannot be resumed: its state was written by another version of gxrod, in another form (if its run "
          "was stopped before it first wrote, gxrod run --force starts it again)");
}

// Over some of these HDF5's library breaks down, or does not come back.
TEST_CASE("Whatever is damaged ends in an error or is read, and leaves the program alone", "[issues]") {
    const fuzz::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "damaged.vtkhdf";
    std::mt19937 random(11);
    int read = 0, refused = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::string bytes = results_sample();
        // Structures of HDF5's lie between rows, all over the file.
        for (int change = 0; change < 8; ++change) {
            const std::size_t at = seal_block_bytes + random() % (bytes.size() - seal_block_bytes);
            const std::size_t count = std::min<std::size_t>(bytes.size() - at, 1 + random() % 16);
            bytes.replace(at, count, std::string(count, static_cast<char>(random())));
        }
        sample::write_bytes(path, bytes);
        if (trial % 2 == 0) sample::open_seal(path);
        INFO("trial " << trial);
        try {
            if (trial % 3 == 0) {
                write_report(
                    {.results = path, .page = folder.path() / "page.html", .existing = Existing::replace});
            } else if (trial % 3 == 1) {
                GuardedReading(path).read([&] {
                    export_csv(path, folder.path() / "csv", Existing::replace);
                    return std::string();
                });
            } else {
                const ResumableFile file(path);
            }
            ++read;
        } catch (const FileError&) {
            ++refused;
        }
    }
    CHECK(read > 0);
    CHECK(refused > 10);
}

}  // namespace gxrod::test
