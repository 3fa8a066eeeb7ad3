#include <fcntl.h>
#include <unistd.h>

#include <new>

#include "machine/file_error.hpp"
#include "results/file/hdf5_objects.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/file/ordered_driver.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

// Results files that others take away, and files whose writer has to give up.

using namespace gxrod;

namespace {

void write_step(ResultsFile& file) {
    const sample::Motion motion(0.0);
    file.record_step(motion.snapshot(), sample::make_ledger(0.0), sample::make_solver(0.0));
}

}  // namespace

TEST_CASE("A results file that was removed takes no more", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "a.vtkhdf";
    ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
    write_step(file);
    file.flush();
    CHECK(file.is_sound());
    std::filesystem::remove(path);
    CHECK_THROWS_AS(file.flush(), WriteError);
    CHECK(!file.is_sound());
}

TEST_CASE("A results file that was removed is not reported as complete", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "a.vtkhdf";
    ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
    write_step(file);
    std::filesystem::remove(path);
    CHECK_THROWS_WITH(file.close(RunStatus::complete, ""),
                      Catch::Contains("cannot write: it was removed while the run wrote it"));
}

TEST_CASE("A results file that was moved is complete and reported", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    const auto path = folder / "a.vtkhdf";
    ResultsFile file({path}, sample::make_deck(), model, sample::make_output());
    write_step(file);
    std::filesystem::rename(path, folder / "b.vtkhdf");
    CHECK_THROWS_WITH(
        file.close(RunStatus::complete, ""),
        Catch::Contains("was moved while the run wrote it (it is complete, under its new name)"));
    const Hdf5Reader moved(folder / "b.vtkhdf");
    CHECK(moved.text_attribute("/", "status") == "complete");
}

TEST_CASE("An ordered file that is given up keeps what was committed, and HDF5 closes it", "[results]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a";
    {
        const auto file = std::make_shared<OrderedFile>(::open(path.c_str(), O_RDWR | O_CREAT, 0600));
        Hdf5Handle hdf5 = create_hdf5(*file);
        require_group(hdf5, "kept");
        check_hdf5(H5Fflush(hdf5.id(), H5F_SCOPE_LOCAL), "flushing");
        file->commit();
        require_group(hdf5, "lost");
        file->abandon();
        CHECK(H5Fflush(hdf5.id(), H5F_SCOPE_LOCAL) >= 0);
        CHECK_THROWS_AS(file->commit(), std::bad_alloc);
        CHECK(hdf5.reset() >= 0);
    }
    const Hdf5Reader file(path);
    CHECK(file.has("/kept"));
    CHECK(!file.has("/lost"));
}
