#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/break_seal.hpp"
#include "results/hdf5_objects.hpp"
#include "results/list_changes.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

// A results file to be changed, and what is told of that.
namespace gxrod::sample {

inline void write_steps(ResultsFile& file, int first, int count) {
    for (int i = first; i < first + count; ++i) {
        const Motion motion(0.25 * i);
        file.record_step(motion.snapshot(), make_ledger(motion.time), make_solver(motion.time));
        if (i % 2 == 0) file.write_frame(motion.snapshot());
        file.set_restart(make_restart(motion.time));
        file.flush();
    }
}

inline DeckRecord make_deck_with_mesh() {
    DeckRecord deck = make_deck();
    deck.meshes.push_back({"cable.msh", "$MeshFormat"});
    return deck;
}

inline void rewrite_checksum(hid_t file, const char* name, std::int64_t sum) {
    const Hdf5Handle group(H5Gopen2(file, "/restart", H5P_DEFAULT), H5Gclose, "opening");
    const Hdf5Handle attribute(H5Aopen(group.id(), name, H5P_DEFAULT), H5Aclose, "opening");
    check_hdf5(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &sum), "writing a checksum");
}

// A results file of five steps, the last at t = 1, and three frames. Its seal is broken.
struct WrittenFile {
    ScratchFolder folder;
    Model model = make_model();
    std::filesystem::path path = folder / "a.vtkhdf";

    WrittenFile() {
        ResultsFile file({path}, make_deck_with_mesh(), model, make_output());
        write_steps(file, 0, 5);
        file.close(RunStatus::interrupted, "Ctrl-C");
        test::break_seal(path);
    }

    // Changes it, through HDF5.
    void change(const std::function<void(hid_t)>& action) const {
        const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "opening");
        action(file.id());
    }
    void change_number(const char* dataset, std::size_t index) const {
        change([&](hid_t file) {
            const Hdf5Handle rows(H5Dopen2(file, dataset, H5P_DEFAULT), H5Dclose, "opening");
            const Hdf5Handle form(H5Dget_type(rows.id()), H5Tclose, "type");
            const Hdf5Handle space(H5Dget_space(rows.id()), H5Sclose, "space");
            const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id()));
            const std::size_t bytes = H5Tget_size(form.id());
            std::vector<unsigned char> values(count * bytes);
            H5Dread(rows.id(), form.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
            REQUIRE(index < count);
            values[index * bytes] ^= 1U;  // the least bit
            H5Dwrite(rows.id(), form.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        });
    }
    std::vector<std::string> changes() const { return list_changes(path); }
};

inline const std::string steps_changed =
    "rows of its histories, ledger or solver's record, up to t = 1, are not those that were written";
inline const std::string frames_changed = "frames up to t = 1 are not those that were written";
inline const std::string structure_changed =
    "its names, deck, meshes or other texts are not those that were written";
inline const std::string seal_changed = "not all of its bytes are those that were written";
inline const std::string end_changed =
    "its status, its last frame or the number of its rows is not that of its end";

}  // namespace gxrod::sample
