#include "results/tables/link_table.hpp"

#include "results/file/hdf5_reader.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using Numbers = std::vector<double>;

// Results of a model without a step.
Hdf5Reader write_results(const sample::ScratchFolder& folder, const Model& model) {
    ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
    file.close(RunStatus::complete, "");
    return Hdf5Reader(folder / "a.vtkhdf");
}

}  // namespace

TEST_CASE("Results say what joints, springs and bushings join", "[results][joint]") {
    Model model = sample::make_model();
    model.joints.resize(2);
    Joint& joint = model.joints[1];
    joint.name = "knuckle";
    joint.kind = JointKind::universal;
    joint.a.anchor = {1, Vec3(1, 2, 3)};
    joint.b.anchor = {-1, Vec3(4, 5, 6)};
    joint.a.axes.col(0) = Vec3(0, 0, 1);
    joint.b.axes.col(0) = Vec3(0, 1, 0);
    model.springs = {Spring{}};
    model.springs[0].name = "cord";
    model.springs[0].ends = {Anchor{2, Vec3(7, 8, 9)}, Anchor{3, Vec3::Zero()}};
    model.bushings = {Bushing{}};
    model.bushings[0].name = "mount";
    model.bushings[0].ends = {Anchor{-1, Vec3(0, 0, 1)}, Anchor{2, Vec3::Zero()}};
    const sample::ScratchFolder folder;
    const Hdf5Reader file = write_results(folder, model);
    CHECK(file.texts("/joints/name") == std::vector<std::string>{"", "knuckle"});
    CHECK(file.texts("/joints/type") == std::vector<std::string>{"ball", "universal"});
    CHECK(file.numbers("/joints/point_a") == Numbers{-1, 1});
    CHECK(file.numbers("/joints/point_b") == Numbers{-1, -1});
    CHECK(file.size("/joints/arm_a") == std::vector<hsize_t>{2, 3});
    CHECK(file.numbers("/joints/arm_a") == Numbers{0, 0, 0, 1, 2, 3});
    CHECK(file.numbers("/joints/arm_b") == Numbers{0, 0, 0, 4, 5, 6});
    CHECK(file.numbers("/joints/axis_a") == Numbers{1, 0, 0, 0, 0, 1});
    CHECK(file.numbers("/joints/axis_b") == Numbers{1, 0, 0, 0, 1, 0});
    CHECK(file.texts("/springs/name") == std::vector<std::string>{"cord"});
    CHECK(file.numbers("/springs/point_a") == Numbers{2});
    CHECK(file.numbers("/springs/point_b") == Numbers{3});
    CHECK(file.numbers("/springs/arm_a") == Numbers{7, 8, 9});
    CHECK(file.numbers("/bushings/point_a") == Numbers{-1});
    CHECK(file.numbers("/bushings/arm_a") == Numbers{0, 0, 1});
    CHECK(file.numbers("/bushings/point_b") == Numbers{2});
}

TEST_CASE("Results of a model without joints have no tables of them", "[results]") {
    const sample::ScratchFolder folder;
    Model model = sample::make_model();
    model.springs.clear();
    const Hdf5Reader file = write_results(folder, model);
    for (const char* table : {"/joints", "/springs", "/bushings"}) CHECK_FALSE(file.has(table));
}
