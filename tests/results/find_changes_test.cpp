#include "results/find_changes.hpp"

#include <array>

#include "results/restart_table.hpp"
#include "results/resumable_file.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Nothing is told of a file as it was written", "[results]") {
    CHECK(sample::WrittenFile().changes().empty());
}

TEST_CASE("A changed bit of any row is told", "[results]") {
    for (const char* dataset : {"/histories/time",
                                "/histories/middle/position",
                                "/ledger/energy_error",
                                "/ledger/linear_momentum",
                                "/solver/newton_iterations",
                                "/solver/residual"}) {
        const sample::WrittenFile written;
        written.change_number(dataset, 4);
        CHECK(written.changes() == std::vector{sample::steps_changed});
    }
    for (const char* dataset : {"/VTKHDF/Points",
                                "/VTKHDF/PointData/axis_x",
                                "/VTKHDF/CellData/radius",
                                "/VTKHDF/Steps/Values",
                                "/VTKHDF/Steps/PointOffsets",
                                "/VTKHDF/Steps/CellDataOffsets/force"}) {
        const sample::WrittenFile written;
        written.change_number(dataset, 2);
        CHECK(written.changes() == std::vector{sample::frames_changed});
    }
    const sample::WrittenFile both;
    both.change_number("/histories/time", 0);
    both.change_number("/VTKHDF/Points", 0);
    CHECK(both.changes() == std::vector{sample::steps_changed, sample::frames_changed});
}

TEST_CASE("A changed bit of what is written once is told", "[results]") {
    for (const char* dataset : {"/VTKHDF/NumberOfCells",
                                "/VTKHDF/Connectivity",
                                "/VTKHDF/Types",
                                "/deck/meshes/cable.msh",
                                "/VTKHDF/CellData/rod",
                                "/VTKHDF/PointData/arc_length",
                                "/rods/first_cell",
                                "/rods/arc_length"}) {
        const sample::WrittenFile written;
        written.change_number(dataset, 0);
        CHECK(written.changes() == std::vector{sample::structure_changed});
    }
    const auto rename = [](const char* from, const char* to) {
        const sample::WrittenFile written;
        written.change([&](hid_t file) { H5Lmove(file, from, file, to, H5P_DEFAULT, H5P_DEFAULT); });
        return written.changes();
    };
    CHECK(rename("/histories/middle", "/histories/niddle") == std::vector{sample::structure_changed});
    CHECK(rename("/ledger/time", "/ledger/tame") == std::vector{sample::structure_changed});
    const sample::WrittenFile renamed;
    renamed.change([](hid_t file) {
        const Hdf5Handle names(H5Dopen2(file, "/rods/name", H5P_DEFAULT), H5Dclose, "opening");
        const Hdf5Handle type(H5Dget_type(names.id()), H5Tclose, "type");
        const char* name = "team";
        H5Dwrite(names.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<const void*>(&name));
    });
    CHECK(renamed.changes() == std::vector{sample::structure_changed});
    const auto rewrite = [](const char* object, const char* name, const char* text) {
        const sample::WrittenFile written;
        written.change([&](hid_t file) {
            const Hdf5Handle owner(H5Oopen(file, object, H5P_DEFAULT), H5Oclose, "opening");
            rewrite_attribute(owner.id(), name, std::string(text));
        });
        return written.changes();
    };
    CHECK(rewrite("/", "title", "Sampla") == std::vector{sample::structure_changed});
    CHECK(rewrite("/histories/middle/position", "frame", "spatiam") ==
          std::vector{sample::structure_changed});
}

TEST_CASE("A changed bit of the state to go on from is told", "[results]") {
    for (const char* table :
         {"numbers", "nodes", "sections", "algorithmic", "forces", "force_change", "movement"}) {
        const sample::WrittenFile written;
        for (const char* slot : {"/restart/a/", "/restart/b/"})
            written.change_number((std::string(slot) + table).c_str(), 0);
        CHECK(written.changes() == std::vector<std::string>{"its state is not the one that was written"});
    }
}

TEST_CASE("What is written at the end is told, and how many rows there are", "[results]") {
    const auto after = [](const std::function<void(hid_t)>& action) {
        const sample::WrittenFile written;
        written.change(action);
        return written.changes();
    };
    const auto rewrite = [&](const char* name, const char* text) {
        return after([&](hid_t file) {
            const Hdf5Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "opening");
            rewrite_attribute(root.id(), name, std::string(text));
        });
    };
    CHECK(rewrite("status", "failed") == std::vector{sample::end_changed});
    CHECK(rewrite("reason", "") == std::vector{sample::end_changed});
    const auto resize = [&](const char* name, hsize_t rows) {
        return after([&](hid_t file) {
            const Hdf5Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose, "opening");
            H5Dset_extent(dataset.id(), &rows);
        });
    };
    CHECK(resize("/ledger/strain_energy", 6) == std::vector{sample::end_changed});
    CHECK(resize("/histories/time", 6) == std::vector<std::string>{"times of steps after t = 1 do not grow"});
    CHECK(resize("/histories/time", 4) == std::vector<std::string>{"a dataset lacks rows"});
    const auto count_frames = [&](std::int64_t frames) {
        return after([&](hid_t file) {
            const Hdf5Handle steps(H5Gopen2(file, "/VTKHDF/Steps", H5P_DEFAULT), H5Gclose, "opening");
            const Hdf5Handle count(H5Aopen(steps.id(), "NSteps", H5P_DEFAULT), H5Aclose, "opening");
            check_hdf5(H5Awrite(count.id(), H5T_NATIVE_INT64, &frames), "writing");
        });
    };
    CHECK(count_frames(2) == std::vector{sample::frames_changed});
    CHECK(count_frames(4) == std::vector{sample::end_changed});
}

TEST_CASE("A last frame that is none of the state is told when it changes", "[results]") {
    const sample::WrittenFile written;
    {
        ResultsFile file(
            sample::make_deck_with_mesh(), written.model, sample::make_output(), ResumableFile(written.path));
        sample::write_steps(file, 5, 1);
        file.write_frame(sample::Motion(1.25).snapshot());
        file.close(RunStatus::interrupted, "");
    }
    CHECK(written.changes().empty());
    written.change_number("/VTKHDF/Points", 3 * 4 * 3);  // three frames before, four points of three numbers
    CHECK(written.changes() == std::vector{sample::end_changed});
}

// As of a run that was killed in its first moments.
TEST_CASE("What is changed before there is a state is told", "[results]") {
    sample::WrittenFile written;
    const std::filesystem::path first = written.folder / "first.vtkhdf";
    ResultsFile file({first}, sample::make_deck_with_mesh(), written.model, sample::make_output());
    written.path = written.folder / "copy.vtkhdf";
    const auto copy = [&] {
        std::filesystem::copy_file(first, written.path, std::filesystem::copy_options::overwrite_existing);
    };
    copy();
    CHECK(written.changes().empty());
    written.change_number("/VTKHDF/Connectivity", 0);
    CHECK(written.changes() == std::vector{sample::structure_changed});
    const sample::Motion motion(0.0);
    file.record_step(motion.snapshot(), sample::make_ledger(0.0), sample::make_solver(0.0));
    file.flush();
    copy();
    test::break_seal(written.path);
    CHECK(written.changes() ==
          std::vector<std::string>{"its steps have no checksum, as its run was stopped while it wrote them"});
}

TEST_CASE("What a run that could not begin has written is told when it changes", "[results]") {
    const auto after = [](const std::function<void(const sample::WrittenFile&)>& action) {
        sample::WrittenFile written;
        written.path = written.folder / "failed.vtkhdf";
        {
            ResultsFile file({written.path}, sample::make_deck(), written.model, sample::make_output());
            file.write_frame(sample::Motion(0.0).snapshot());
            file.close(RunStatus::failed, "no equilibrium at the start");
        }
        action(written);
        return written.changes();
    };
    CHECK(after([](const sample::WrittenFile&) {}).empty());
    CHECK(after([](const sample::WrittenFile& written) { written.change_number("/VTKHDF/Points", 0); }) ==
          std::vector{sample::end_changed});
    CHECK(after([](const sample::WrittenFile& written) {
              written.change([](hid_t file) {
                  const Hdf5Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "opening");
                  rewrite_attribute(root.id(), "status", std::string("complete"));
              });
          }) == std::vector{sample::end_changed});
    CHECK(after([](const sample::WrittenFile& written) {
              written.change_number("/VTKHDF/NumberOfPoints", 0);
          }) == std::vector{sample::structure_changed});
}

// A run that was killed soon after it went on is no other.
TEST_CASE("What lies beyond the state may change, and nothing before it", "[results]") {
    const sample::WrittenFile written;
    {
        ResultsFile file(
            sample::make_deck_with_mesh(), written.model, sample::make_output(), ResumableFile(written.path));
        const sample::Motion motion(1.25);
        file.record_step(motion.snapshot(), sample::make_ledger(1.25), sample::make_solver(1.25));
        file.flush();
    }
    CHECK(written.changes().empty());
    test::break_seal(written.path);
    const std::vector<std::string> unchecked{
        "its steps after t = 1 have no checksum, as its run was stopped while it wrote them"};
    CHECK(written.changes() == unchecked);
    written.change_number("/ledger/energy_error", 5);
    CHECK(written.changes() == unchecked);
    CHECK_NOTHROW(ResumableFile(written.path));
    written.change_number("/ledger/energy_error", 4);
    CHECK(written.changes() == std::vector{sample::steps_changed});
}

TEST_CASE("Steps beyond the state of a run that has ended have a checksum", "[results]") {
    const sample::WrittenFile written;
    {
        ResultsFile file(
            sample::make_deck_with_mesh(), written.model, sample::make_output(), ResumableFile(written.path));
        const sample::Motion motion(1.25);
        file.record_step(motion.snapshot(), sample::make_ledger(1.25), sample::make_solver(1.25));
        file.close(RunStatus::failed, "no equilibrium");
    }
    CHECK(written.changes().empty());
    written.change_number("/ledger/energy_error", 5);
    CHECK(written.changes() == std::vector{sample::end_changed});
}

TEST_CASE("A file without checksums is told", "[results]") {
    const sample::WrittenFile written;
    written.change([](hid_t file) {
        clear_file_sums(Hdf5Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "opening"));
    });
    CHECK(written.changes() ==
          std::vector<std::string>{
              "its run was stopped before it wrote checksums, so that changes would not be told"});
    CHECK_NOTHROW(ResumableFile(written.path));
}

TEST_CASE("Steps that are no part of a state are told to have no checksum", "[results]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    ResultsFile file({folder / "a"}, sample::make_deck(), model, sample::make_output());
    CHECK(find_changes(Hdf5Reader(folder / "a")).empty());
    sample::write_steps(file, 0, 2);
    CHECK(find_changes(Hdf5Reader(folder / "a")).empty());
    const sample::Motion motion(0.5);
    file.record_step(motion.snapshot(), sample::make_ledger(0.5), sample::make_solver(0.5));
    file.flush();
    CHECK(find_changes(Hdf5Reader(folder / "a")).empty());
    test::break_seal(folder / "a");
    CHECK(find_changes(Hdf5Reader(folder / "a")) ==
          std::vector<std::string>{
              "its steps after t = 0.25 have no checksum, as its run was stopped while it wrote them"});
}

TEST_CASE("A changed name or text of the states, in use or not, is told", "[results]") {
    const auto after = [](const std::function<void(hid_t)>& action) {
        const sample::WrittenFile written;
        written.change(action);
        return written.changes();
    };
    for (const std::string table :
         {"numbers", "nodes", "sections", "algorithmic", "forces", "force_change", "movement"}) {
        for (const std::string slot : {"/restart/a/", "/restart/b/"}) {
            for (const char* text : {"description", "frame"}) {
                CHECK(after([&](hid_t file) {
                          const Hdf5Handle dataset(
                              H5Dopen2(file, (slot + table).c_str(), H5P_DEFAULT), H5Dclose, "opening");
                          rewrite_attribute(dataset.id(), text, std::string("another"));
                      }) == std::vector{sample::structure_changed});
            }
        }
    }
    const auto rename = [&](const char* from, const char* to) {
        return after([&](hid_t file) { H5Lmove(file, from, file, to, H5P_DEFAULT, H5P_DEFAULT); });
    };
    const std::string unused = [] {
        const sample::WrittenFile written;
        return Hdf5Reader(written.path).integer_attribute("/restart", "slot") == 0 ? "b" : "a";
    }();
    CHECK(rename(("/restart/" + unused).c_str(), "/restart/c") == std::vector{sample::structure_changed});
    CHECK(rename(("/restart/" + unused + "/nodes").c_str(), ("/restart/" + unused + "/modes").c_str()) ==
          std::vector{sample::structure_changed});
}

TEST_CASE("A run that goes on is checked again, with other histories too", "[results][resume]") {
    const sample::WrittenFile written;
    OutputSettings output = sample::make_output();
    output.histories.front().name = "renamed";
    {
        ResultsFile file(sample::make_deck_with_mesh(), written.model, output, ResumableFile(written.path));
        sample::write_steps(file, 5, 3);
        file.close(RunStatus::complete, "");
    }
    CHECK(written.changes().empty());
    CHECK_NOTHROW(ResumableFile(written.path));
    for (const char* history : {"/histories/middle/position", "/histories/renamed/position"}) {
        written.change_number(history, 3);
        CHECK(written.changes().size() == 1);
        written.change_number(history, 3);
        CHECK(written.changes().empty());
    }
}

TEST_CASE("No run goes on from what is not as it was written", "[results][resume]") {
    const sample::WrittenFile written;
    written.change_number("/ledger/energy_error", 4);
    CHECK_THROWS_WITH(ResumableFile(written.path),
                      Catch::Contains("a.vtkhdf: cannot be resumed: " + sample::steps_changed +
                                      " (gxrod run --force begins it anew)"));
}

TEST_CASE("Of a file of another version nothing is doubted", "[results]") {
    const sample::WrittenFile written;
    written.change_number("/ledger/energy_error", 4);
    written.change([](hid_t file) {
        const Hdf5Handle group(H5Gopen2(file, "/restart", H5P_DEFAULT), H5Gclose, "opening");
        rewrite_attribute(group.id(), "version", std::array<std::int64_t, 1>{1});
    });
    CHECK(written.changes().empty());
}

TEST_CASE("Checksums that are none, and objects that no run writes, are told", "[results]") {
    const sample::WrittenFile written;
    for (const std::int64_t sum : {std::int64_t{-5}, std::int64_t{0}, std::int64_t{1} << 32}) {
        written.change([&](hid_t file) { sample::rewrite_checksum(file, "structure", sum); });
        CHECK(written.changes() == std::vector<std::string>{"/restart@structure is damaged"});
    }
    const auto with = [](hid_t type, hsize_t count) {
        const sample::WrittenFile other;
        other.change([&](hid_t file) {
            const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "space");
            H5Dclose(H5Dcreate2(file, "added", type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        });
        return other.changes();
    };
    CHECK(with(H5T_IEEE_F64LE, 3) == std::vector{sample::structure_changed});
    CHECK(with(H5T_STD_REF_OBJ, 3) == std::vector<std::string>{"a dataset is of no type that gxrod writes"});
    CHECK(with(H5T_IEEE_F64BE, 3) == std::vector<std::string>{"a dataset is of no type that gxrod writes"});
}
