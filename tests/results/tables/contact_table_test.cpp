#include <filesystem>

#include "results/file/hdf5_reader.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

// /contacts, whose rows differ from frame to frame.

using namespace gxrod;

namespace {

Model make_touching_model() {
    Model model = sample::make_model();
    Obstacle floor;
    floor.name = "floor";
    model.contact.obstacles = {floor};
    model.contact.radii.assign(model.rods.size(), 0.1);
    model.contact.bend_radii.assign(model.rods.size(), 1.0);
    return model;
}

// As many as the frame has: 0, 1, 2, 0, 1 …
std::vector<ContactTouch> make_touches(int frame) {
    std::vector<ContactTouch> touches;
    for (int i = 0; i < frame % 3; ++i) {
        const double value = frame + 0.1 * i;
        touches.push_back({{0, i == 0 ? -1 : 0},
                           {0.01 * value, i == 0 ? 0.0 : 0.5},
                           Vec3(value, 1, 2),
                           Vec3(0, 0, value),
                           Vec3(value, 0, 0),
                           1e-3 * value,
                           i == 1});
    }
    return touches;
}

void write_frames(ResultsFile& file, int first, int end) {
    for (int frame = first; frame < end; ++frame) {
        const sample::Motion motion(0.25 * frame);
        const std::vector<ContactTouch> touches = make_touches(frame);
        std::vector<Vec6> forces(motion.nodes.size(), Vec6::Constant(frame));
        Snapshot snapshot = motion.snapshot();
        snapshot.touches = touches;
        snapshot.contact_forces = forces;
        file.record_step(snapshot, sample::make_ledger(motion.time), sample::make_solver(motion.time));
        file.write_frame(snapshot);
    }
}

void check_frames(const std::filesystem::path& path, int frames, const std::vector<double>& offsets) {
    const Hdf5Reader file(path);
    REQUIRE(file.numbers("/contacts/offsets") == offsets);
    CHECK(file.texts("/contacts/obstacle") == std::vector<std::string>{"floor"});
    std::vector<double> rods, places, points, normals, frictions, gaps, slides;
    for (int frame = 0; frame < frames; ++frame) {
        for (const ContactTouch& touch : make_touches(frame)) {
            rods.insert(rods.end(), touch.rods.begin(), touch.rods.end());
            places.insert(places.end(), touch.places.begin(), touch.places.end());
            for (int i = 0; i < 3; ++i) {
                points.push_back(touch.point[i]);
                normals.push_back(touch.normal_force[i]);
                frictions.push_back(touch.friction_force[i]);
            }
            gaps.push_back(touch.gap);
            slides.push_back(touch.slides ? 1.0 : 0.0);
        }
    }
    CHECK(file.numbers("/contacts/rods") == rods);
    CHECK(file.numbers("/contacts/places") == places);
    CHECK(file.numbers("/contacts/point") == points);
    CHECK(file.numbers("/contacts/normal_force") == normals);
    CHECK(file.numbers("/contacts/friction_force") == frictions);
    CHECK(file.numbers("/contacts/gap") == gaps);
    CHECK(file.numbers("/contacts/slides") == slides);
    const std::vector<double> forces = file.numbers("/VTKHDF/PointData/contact_force");
    REQUIRE(forces.size() == static_cast<std::size_t>(3 * 4 * frames));
    for (int frame = 0; frame < frames; ++frame)
        CHECK(forces[static_cast<std::size_t>(12 * frame + 5)] == frame);
}

}  // namespace

TEST_CASE("Contacts: each frame has its rows", "[results][touch]") {
    const sample::ScratchFolder folder;
    const Model model = make_touching_model();
    {
        ResultsFile file({folder / "r.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        write_frames(file, 0, 3);
        file.flush();
        write_frames(file, 3, 7);
        file.close(RunStatus::complete, "", {}, "");
    }
    check_frames(folder / "r.vtkhdf", 7, {0, 0, 1, 3, 3, 4, 6, 6});
}

TEST_CASE("Contacts: a run that is resumed replaces the frames beyond its state", "[results][touch]") {
    const sample::ScratchFolder folder;
    const Model model = make_touching_model();
    {
        ResultsFile file({folder / "r.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        write_frames(file, 0, 3);
        file.set_restart(sample::make_restart(0.5));
        file.flush();
        write_frames(file, 4, 600);  // other rows than those that follow
        file.flush();
    }
    {
        ResultsFile file(
            sample::make_deck(), model, sample::make_output(), ResumableFile(folder / "r.vtkhdf"));
        write_frames(file, 3, 6);
        file.close(RunStatus::complete, "", {}, "");
    }
    check_frames(folder / "r.vtkhdf", 6, {0, 0, 1, 3, 3, 4, 6});
}

TEST_CASE("Contacts: models without contact have none", "[results][touch]") {
    const sample::ScratchFolder folder;
    const Model model = sample::make_model();
    {
        ResultsFile file({folder / "r.vtkhdf"}, sample::make_deck(), model, sample::make_output());
        write_frames(file, 0, 2);
        file.close(RunStatus::complete, "", {}, "");
    }
    const Hdf5Reader file(folder / "r.vtkhdf");
    CHECK_FALSE(file.has("/contacts"));
    CHECK_FALSE(file.has("/VTKHDF/PointData/contact_force"));
}
