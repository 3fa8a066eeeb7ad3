#include "report/blocks/frame_vectors.hpp"

#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Frames read many at once are those read alone", "[report]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    constexpr std::size_t frames = 5000;  // of four nodes: more than fit into memory at once
    {
        ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
        for (std::size_t i = 0; i < frames; ++i) {
            const sample::Motion motion(0.001 * static_cast<double>(i));
            file.write_frame(motion.snapshot());
        }
        file.close(RunStatus::complete, "");
    }
    const Hdf5Reader file(folder / "a.vtkhdf");
    for (const std::size_t stride : {1, 7, 2048, 4999}) {
        FrameVectors vectors(file, "/VTKHDF/Points", 4, frames);
        bool are_equal = true;
        for (std::size_t frame = 0; frame < frames; frame += stride) {
            const std::span<const double> read = vectors.read(frame);
            const std::vector<double> alone = file.rows("/VTKHDF/Points", 4 * frame, 4);
            are_equal = are_equal && std::equal(read.begin(), read.end(), alone.begin(), alone.end());
        }
        INFO("every " << stride << "th frame");
        CHECK(are_equal);
    }
}
