#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "check/summaries/rod_summary.hpp"
#include "cross_section/cross_section.hpp"
#include "cross_section/stress_measures.hpp"
#include "model.hpp"
#include "model/sections/section_centres.hpp"
#include "module.hpp"
#include "report/section/section_picture.hpp"

namespace gxrod::python {

namespace {

using nb::literals::operator""_a;
using Numbers = nb::ndarray<nb::numpy, double>;

// An array that owns its numbers.
Numbers keep(std::vector<double> numbers, const std::vector<std::size_t>& shape) {
    auto* kept = new std::vector<double>(std::move(numbers));
    const nb::capsule owner(kept,
                            [](void* held) noexcept { delete static_cast<std::vector<double>*>(held); });
    return Numbers(kept->data(), shape.size(), shape.data(), owner);
}

// Entries row by row.
template <class Matrix>
void append(const Matrix& matrix, std::vector<double>& numbers) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) numbers.push_back(matrix(i, j));
    }
}

Numbers keep_matrix(const Mat6& matrix) {
    std::vector<double> numbers;
    append(matrix, numbers);
    return keep(std::move(numbers), {6, 6});
}

Numbers keep_point(const PlanePoint& point) { return keep({point.x(), point.y()}, {2}); }

// What was computed on cells; throws for a section that was not.
const CrossSection& shape_of(const Section& section) {
    if (section.shape) return *section.shape;
    throw nb::value_error("the section has no shape on cells, only its numbers");
}

Numbers list_points(const Section& section) {
    std::vector<double> numbers;
    const StressField& field = shape_of(section).stresses;
    for (const StressPoint& point : field.points) append(point.at.transpose(), numbers);
    return keep(std::move(numbers), {field.points.size(), 2});
}

Numbers list_operators(const Section& section) {
    std::vector<double> numbers;
    const StressField& field = shape_of(section).stresses;
    for (const StressPoint& point : field.points) append(point.stress_operator, numbers);
    return keep(std::move(numbers), {field.points.size(), 6, 6});
}

std::vector<std::string> list_layers(const Section& section) {
    const CrossSection& shape = shape_of(section);
    std::vector<std::string> names;
    for (const StressPoint& point : shape.stresses.points)
        names.push_back(shape.mesh.layers[static_cast<std::size_t>(point.layer)].name);
    return names;
}

std::vector<bool> list_singular(const Section& section) {
    std::vector<bool> singular;
    for (const StressPoint& point : shape_of(section).stresses.points) singular.push_back(point.is_singular);
    return singular;
}

Vec6 vector_of(const std::vector<double>& numbers) {
    if (numbers.size() != 6) throw nb::value_error("expected six resultants: N, Vy, Vz, T, My, Mz");
    return Eigen::Map<const Vec6>(numbers.data());
}

std::string draw(const Section& section, const std::optional<std::vector<double>>& resultants) {
    PictureRequest request;
    if (resultants) request.resultants = vector_of(*resultants);
    return draw_section(shape_of(section), request);
}

nb::dict list_constants(const Section& section) {
    const CrossSection& shape = shape_of(section);
    const SectionProperties& properties = shape.properties;
    nb::dict constants;
    constants["source"] = shape.source;
    constants["area"] = properties.area;
    constants["centroid"] = keep_point(properties.centroid);
    constants["second_moment_y"] = properties.second_moment_y;
    constants["second_moment_z"] = properties.second_moment_z;
    constants["product_moment"] = properties.product_moment;
    constants["warping_stiffness"] = properties.warping_stiffness;
    constants["warping_length"] = properties.warping_length();
    return constants;
}

}  // namespace

void bind_section(nb::module_& module) {
    nb::class_<Section>(module, "Section", "A section of a model, at the start of a rod.")
        .def_prop_ro("name", [](const Section& section) { return section.name; })
        .def_prop_ro(
            "stiffness",
            [](const Section& section) { return keep_matrix(section.stiffness); },
            nb::rv_policy::move)
        .def_prop_ro(
            "mass", [](const Section& section) { return keep_matrix(section.mass); }, nb::rv_policy::move)
        .def_prop_ro(
            "shear_centre",
            [](const Section& section) {
                return keep_point(SectionCentres(section.stiffness, section.mass).shear_centre());
            },
            nb::rv_policy::move)
        .def_prop_ro(
            "tension_centre",
            [](const Section& section) {
                return keep_point(SectionCentres(section.stiffness, section.mass).tension_centre());
            },
            nb::rv_policy::move)
        .def_prop_ro("has_shape", [](const Section& section) { return section.shape != nullptr; })
        .def_prop_ro("constants", &list_constants)
        .def_prop_ro("points", &list_points, nb::rv_policy::move)
        .def_prop_ro("operators", &list_operators, nb::rv_policy::move)
        .def_prop_ro("layers", &list_layers)
        .def_prop_ro("singular", &list_singular)
        .def("describe", [](const Section& section) { return describe_section(section); })
        .def("draw", &draw, "resultants"_a.none());
}

}  // namespace gxrod::python
