#include "results/tables/frame_table.hpp"

#include <fmt/format.h>

#include "results/file/hdf5_reader.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using sample::Motion;

namespace {

const std::vector<double> times{0.0, 0.5, 2.0};
constexpr std::size_t points = 4, cells = 4;

// Frames at `times`.
Hdf5Reader write_frames(const sample::ScratchFolder& folder) {
    const Model model = sample::make_model();
    ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
    for (const double time : times) file.write_frame(Motion(time).snapshot());
    file.close(RunStatus::complete, "");
    return Hdf5Reader(folder / "a.vtkhdf");
}

Vec3 vector_at(const Hdf5Reader& file, const std::string& field, std::size_t index) {
    const std::vector<double> values = file.numbers("/VTKHDF/" + field);
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

}  // namespace

TEST_CASE("Frames have the form that VTK asks for", "[results]") {
    const sample::ScratchFolder folder;
    const Hdf5Reader file = write_frames(folder);
    const Hdf5Handle type(
        H5Aopen_by_name(file.id(), "/VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "Type");
    const Hdf5Handle string(H5Aget_type(type.id()), H5Tclose, "Type");
    CHECK(H5Tis_variable_str(string.id()) == 0);
    CHECK(H5Tget_size(string.id()) == 16);
    CHECK(H5Tget_strpad(string.id()) == H5T_STR_NULLPAD);
    CHECK(H5Tget_cset(string.id()) == H5T_CSET_ASCII);
    CHECK(file.text_attribute("/VTKHDF", "Type") == "UnstructuredGrid");
    CHECK(file.integer_attribute("/VTKHDF/Steps", "NSteps") == 3);

    using Numbers = std::vector<double>;
    CHECK(file.numbers("/VTKHDF/NumberOfPoints") == Numbers{4});
    CHECK(file.numbers("/VTKHDF/NumberOfCells") == Numbers{4});
    CHECK(file.numbers("/VTKHDF/NumberOfConnectivityIds") == Numbers{6});
    CHECK(file.numbers("/VTKHDF/Connectivity") == Numbers{0, 1, 1, 2, 2, 3});
    CHECK(file.numbers("/VTKHDF/Offsets") == Numbers{0, 2, 4, 5, 6});
    CHECK(file.numbers("/VTKHDF/Types") == Numbers{3, 3, 1, 1});
    CHECK(file.numbers("/VTKHDF/Steps/Values") == times);
    CHECK(file.numbers("/VTKHDF/Steps/PartOffsets") == Numbers{0, 0, 0});
    CHECK(file.numbers("/VTKHDF/Steps/NumberOfParts") == Numbers{1, 1, 1});
    CHECK(file.numbers("/VTKHDF/Steps/PointOffsets") == Numbers{0, 4, 8});
    for (const char* name : {"CellOffsets", "ConnectivityIdOffsets"}) {
        CHECK(file.numbers(std::string("/VTKHDF/Steps/") + name) == Numbers{0, 0, 0});
        CHECK(file.size(std::string("/VTKHDF/Steps/") + name) == std::vector<hsize_t>{3, 1});
    }
    for (const char* name :
         {"displacement", "rotation_vector", "velocity", "angular_velocity", "axis_x", "axis_y", "axis_z"}) {
        CHECK(file.numbers(std::string("/VTKHDF/Steps/PointDataOffsets/") + name) == Numbers{0, 4, 8});
        CHECK(file.size(std::string("/VTKHDF/PointData/") + name) == std::vector<hsize_t>{12, 3});
    }
    CHECK(file.numbers("/VTKHDF/Steps/PointDataOffsets/radius") == Numbers{0, 4, 8});
    CHECK(file.size("/VTKHDF/PointData/radius") == std::vector<hsize_t>{12});
    for (const char* name : {"force", "moment", "strain", "curvature", "radius"}) {
        CHECK(file.numbers(std::string("/VTKHDF/Steps/CellDataOffsets/") + name) == Numbers{0, 4, 8});
        CHECK(file.size(std::string("/VTKHDF/CellData/") + name)[0] == 12);
    }
}

TEST_CASE("Places of cells and points along rods are stored once for all frames", "[results]") {
    const sample::ScratchFolder folder;
    const Hdf5Reader file = write_frames(folder);
    using Numbers = std::vector<double>;
    CHECK(file.numbers("/VTKHDF/CellData/rod") == Numbers{0, 0, -1, -1});
    CHECK(file.numbers("/VTKHDF/CellData/element") == Numbers{0, 1, -1, -1});
    CHECK(file.numbers("/VTKHDF/CellData/arc_length") == Numbers{0.5, 1.5, 0.0, 0.0});
    CHECK(file.numbers("/VTKHDF/PointData/rod") == Numbers{0, 0, 0, -1});
    CHECK(file.numbers("/VTKHDF/PointData/element") == Numbers{0, 0, 1, -1});
    CHECK(file.numbers("/VTKHDF/PointData/arc_length") == Numbers{0.0, 1.0, 2.0, 0.0});
    for (const char* group : {"CellDataOffsets", "PointDataOffsets"}) {
        for (const char* name : {"rod", "element", "arc_length"})
            CHECK(file.numbers(fmt::format("/VTKHDF/Steps/{}/{}", group, name)) == Numbers{0, 0, 0});
    }
}

TEST_CASE("A file without rods has no table of them", "[results]") {
    const sample::ScratchFolder folder;
    Model model = sample::make_model();
    model.rods.clear();
    model.sections.clear();
    ResultsFile results({folder / "bodies.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
    results.write_frame(Motion(0.0).snapshot());
    results.close(RunStatus::complete, "");
    const Hdf5Reader file(folder / "bodies.vtkhdf");
    CHECK_FALSE(file.has("/rods"));
    CHECK(file.numbers("/VTKHDF/CellData/rod") == std::vector<double>{-1, -1});
}

TEST_CASE("The points of a frame carry their motion and axes", "[results]") {
    const sample::ScratchFolder folder;
    const Hdf5Reader file = write_frames(folder);
    const Model model = sample::make_model();
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
        const Motion motion(times[frame]);
        for (std::size_t i = 0; i < points; ++i) {
            INFO("frame " << frame << " point " << i);
            const std::size_t index = frame * points + i;
            const NodeMotion& node = motion.nodes[i];
            CHECK(vector_at(file, "Points", index) == node.r);
            CHECK(vector_at(file, "PointData/displacement", index) == node.r - model.nodes[i].position);
            CHECK((vector_at(file, "PointData/rotation_vector", index) - log(node.Lambda)).norm() < 1e-15);
            CHECK(vector_at(file, "PointData/velocity", index) == node.v);
            CHECK(vector_at(file, "PointData/angular_velocity", index) == node.omega);
            const Quat triad = i < 3 ? model.rods[0].triad_at(static_cast<int>(i)) : model.bodies[1].attitude;
            const Mat3 axes = node.Lambda.toRotationMatrix() * triad.toRotationMatrix();
            CHECK((vector_at(file, "PointData/axis_x", index) - axes.col(0)).norm() < 1e-14);
            CHECK((vector_at(file, "PointData/axis_y", index) - axes.col(1)).norm() < 1e-14);
            CHECK((vector_at(file, "PointData/axis_z", index) - axes.col(2)).norm() < 1e-14);
            const double radius = i < 3 ? 2.0 * std::sqrt(500.0 / 1e4) : 0.0;
            CHECK(file.numbers("/VTKHDF/PointData/radius")[index] == Approx(radius));
        }
    }
}

TEST_CASE("The cells of a frame carry section values, bodies do not", "[results]") {
    const sample::ScratchFolder folder;
    const Hdf5Reader file = write_frames(folder);
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
        const Motion motion(times[frame]);
        for (std::size_t i = 0; i < cells; ++i) {
            INFO("frame " << frame << " cell " << i);
            const std::size_t index = frame * cells + i;
            const bool is_element = i < 2;
            const SectionValues& section = motion.elements[is_element ? i : 0];
            CHECK(vector_at(file, "CellData/force", index) == (is_element ? section.force : Vec3::Zero()));
            CHECK(vector_at(file, "CellData/moment", index) == (is_element ? section.moment : Vec3::Zero()));
            CHECK(vector_at(file, "CellData/strain", index) == (is_element ? section.strain : Vec3::Zero()));
            CHECK(vector_at(file, "CellData/curvature", index) ==
                  (is_element ? section.curvature : Vec3::Zero()));
            const double radius = is_element ? 2.0 * std::sqrt(500.0 / 1e4) : 0.0;
            CHECK(file.numbers("/VTKHDF/CellData/radius")[index] == Approx(radius));
        }
    }
}
