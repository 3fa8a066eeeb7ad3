#include "results/export/rod_line.hpp"

#include <cmath>

#include "results/file/hdf5_objects.hpp"
#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// A frame of a model; its results, to be read.
Hdf5Reader write_frame(const sample::ScratchFolder& folder, const Model& model) {
    const std::vector<NodeMotion> nodes(model.nodes.size());
    ResultsFile file({folder / "a.vtkhdf"}, sample::make_deck(), model, OutputSettings{});
    file.write_frame({0.0, nodes, {}, {}});
    file.close(RunStatus::complete, "");
    return Hdf5Reader(folder / "a.vtkhdf");
}

Model make_two_rods(int order) {
    Model model;
    const int count = 2 * order + 1;
    for (int i = 0; i < 2 * count - 1; ++i) model.nodes.push_back({std::to_string(i), Vec3::Zero()});
    model.sections = {{"tube", Mat6::Identity(), Mat6::Identity()}};
    std::vector<double> arc_length;
    for (int i = 0; i < count; ++i) arc_length.push_back(0.5 * i * i);
    for (const int first : {0, count - 1}) {  // the second begins where the first ends
        Rod rod;
        rod.name = first == 0 ? "first" : "second";
        rod.order = order;
        for (int i = 0; i < count; ++i) rod.nodes.push_back(first + i);
        set_line_elements(rod, arc_length, std::vector(arc_length.size(), Quat::Identity()));
        rod.length = arc_length.back();
        model.rods.push_back(rod);
    }
    return model;
}

}  // namespace

TEST_CASE("A file says where its rods lie", "[results]") {
    const int order = GENERATE(1, 2, 3, 4);
    CAPTURE(order);
    const sample::ScratchFolder folder;
    const Model model = make_two_rods(order);
    const Hdf5Reader file = write_frame(folder, model);
    CHECK(read_rod_names(file) == std::vector<std::string>{"first", "second"});
    CHECK(file.texts("/rods/section") == std::vector<std::string>{"tube", "tube"});
    CHECK(file.numbers("/rods/length") == std::vector(2, model.rods[0].length));
    for (std::size_t rod = 0; rod < 2; ++rod) {
        const RodLine line = read_rod_line(file, rod);
        REQUIRE(line.elements.size() == 2);
        REQUIRE(line.nodes.size() == model.rods[rod].nodes.size());
        for (std::size_t i = 0; i < line.nodes.size(); ++i) {
            CAPTURE(rod, i);
            CHECK(line.nodes[i].point == static_cast<std::size_t>(model.rods[rod].nodes[i]));
            CHECK(line.nodes[i].arc_length == 0.5 * static_cast<double>(i * i));
            CHECK(line.nodes[i].element == (i > static_cast<std::size_t>(order) ? 1 : 0));
        }
        for (std::size_t element = 0; element < 2; ++element) {
            const double start = 0.5 * std::pow(order * static_cast<double>(element), 2);
            const double end = 0.5 * std::pow(order * static_cast<double>(element + 1), 2);
            CHECK(line.elements[element].cell == 2 * rod + element);
            CHECK(line.elements[element].middle == 0.5 * (start + end));
            CHECK(line.elements[element].points.size() == static_cast<std::size_t>(order) + 1);
        }
    }
}

TEST_CASE("A table of rods that does not fit its frames is reported", "[results]") {
    const sample::ScratchFolder folder;
    CHECK_THROWS_AS(read_rod_line(write_frame(folder, make_two_rods(2)), 2), std::runtime_error);
    const char* const dataset = GENERATE("/rods/first_cell", "/rods/elements", "/VTKHDF/Offsets");
    CAPTURE(dataset);
    {
        const Hdf5Handle changed(
            H5Fopen((folder / "a.vtkhdf").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "opening");
        const Hdf5Handle numbers(H5Dopen2(changed.id(), dataset, H5P_DEFAULT), H5Dclose, "opening");
        const std::vector<std::int64_t> wrong(extent_of(numbers.id()).at(0), 7);
        H5Dwrite(numbers.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, wrong.data());
    }
    CHECK_THROWS_AS(read_rod_line(Hdf5Reader(folder / "a.vtkhdf"), 1), std::runtime_error);
}

TEST_CASE("The weights of an element's middle are exact for polynomials of its order", "[results]") {
    const std::size_t nodes = GENERATE(2, 3, 4, 5);
    // Where Gauss-Lobatto points are: the ends, and the roots of the derivative of Legendre's polynomial.
    const std::vector<std::vector<double>> inner{
        {}, {0.0}, {-std::sqrt(0.2), std::sqrt(0.2)}, {-std::sqrt(3.0 / 7.0), 0.0, std::sqrt(3.0 / 7.0)}};
    std::vector<double> points{-1.0, 1.0};
    points.insert(points.end(), inner[nodes - 2].begin(), inner[nodes - 2].end());
    const std::vector<double>& weights = middle_weights(nodes);
    REQUIRE(weights.size() == nodes);
    for (std::size_t power = 0; power < nodes; ++power) {
        double value = 0.0;
        for (std::size_t i = 0; i < nodes; ++i)
            value += weights[i] * std::pow(points[i], static_cast<double>(power));
        CHECK(value == Approx(power == 0 ? 1.0 : 0.0).margin(1e-15));
    }
}
