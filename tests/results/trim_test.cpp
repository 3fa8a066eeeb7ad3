#include <csignal>
#include <filesystem>

#include "results/file/hdf5_objects.hpp"
#include "results/traced_writer.hpp"
#include "results/written_file.hpp"
#include "tools/catch.hpp"

// What becomes of steps and frames beyond the state from which a run resumes.

using namespace gxrod;

namespace {

constexpr int kept_steps = 3;
constexpr int lost_steps = 150;

OutputSettings make_output() {
    OutputSettings output = sample::make_output();
    output.compression = Compression::deflate;
    return output;
}

// As a killed writer may leave it.
void write_beyond_state(const std::filesystem::path& path, const Model& model) {
    ResultsFile file({path}, sample::make_deck(), model, make_output());
    sample::write_steps(file, 0, kept_steps);
    for (int i = kept_steps; i < kept_steps + lost_steps; ++i) {
        const sample::Motion motion(0.25 * i);
        file.record_step(
            motion.snapshot(), sample::make_ledger(motion.time), sample::make_solver(motion.time));
        file.write_frame(motion.snapshot());
    }
    file.flush();
}

void resume(const std::filesystem::path& path, const Model& model) {
    ResultsFile file(sample::make_deck(), model, make_output(), ResumableFile(path));
}

herr_t add_chunks_beyond(hid_t group, const char* name, const H5O_info_t* info, void* names) {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const Hdf5Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose, "opening");
    const Hdf5Handle properties(H5Dget_create_plist(dataset.id()), H5Pclose, "properties");
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return 0;
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose, "space");
    std::array<hsize_t, 2> size{0, 1}, chunk{1, 1};
    const int rank = H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
    H5Pget_chunk(properties.id(), rank, chunk.data());
    hsize_t chunks = 0;
    H5Dget_num_chunks(dataset.id(), space.id(), &chunks);
    if (chunks > (size[0] + chunk[0] - 1) / chunk[0])
        static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
}

// Names of datasets that have chunks beyond their last row.
std::vector<std::string> chunks_beyond(const std::filesystem::path& path) {
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening");
    std::vector<std::string> names;
    H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add_chunks_beyond, &names, H5O_INFO_BASIC);
    return names;
}

}  // namespace

TEST_CASE("A resumed run leaves no chunk beyond its rows, however often it was killed before",
          "[results][resume]") {
    const sample::ScratchFolder folder;
    const auto path = folder / "a.vtkhdf";
    const auto copy = folder / "copy.vtkhdf";
    const Model model = sample::make_model();
    write_beyond_state(path, model);
    const pid_t child = test::run_child([&] {
        if (!test::may_be_traced()) return test::exit_not_allowed;
        ::raise(SIGSTOP);
        resume(path, model);
        return 0;
    });
    int looks = 0, with_chunks_beyond = 0;
    const test::TraceEnd end = test::trace_writes(child, [&] {
        if (++looks % 2 == 0) return true;
        std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
        with_chunks_beyond += !chunks_beyond(copy).empty();
        resume(copy, model);
        INFO("killed before write " << looks);
        const std::vector<std::string> beyond = chunks_beyond(copy);
        CHECK(beyond == std::vector<std::string>());
        return beyond.empty();
    });
    if (end == test::TraceEnd::not_allowed) return;
    CHECK(end == test::TraceEnd::ended_well);
    CHECK(with_chunks_beyond > 5);
    CHECK(looks > 50);
}
