#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "module.hpp"
#include "numerics/sn_curve.hpp"

namespace gxrod::python {

namespace {

using nb::literals::operator""_a;

// A row (range, mean, count) each.
using Rows = std::vector<std::array<double, 3>>;

Rows count_series(const std::vector<double>& values) {
    RainflowCounter counter;
    for (const double value : values) counter.add(value);
    Rows rows;
    for (const RangeCycle& cycle : counter.cycles()) rows.push_back({cycle.range, cycle.mean, cycle.count});
    return rows;
}

std::vector<RangeCycle> cycles_of(const Rows& rows) {
    std::vector<RangeCycle> cycles;
    for (const auto& [range, mean, count] : rows) cycles.push_back({range, mean, count});
    return cycles;
}

SNCurve curve_of(const Rows& lines, double limit, double factor) {
    SNCurve curve{{}, limit, factor};
    for (const auto& [slope, cycles, at] : lines) curve.lines.push_back({slope, cycles, at});
    return curve;
}

std::pair<Rows, double> list_eurocode_lines(double category) {
    const SNCurve curve = make_eurocode_curve(category);
    Rows lines;
    for (const SNCurve::Line& line : curve.lines) lines.push_back({line.slope, line.cycles, line.at});
    return {lines, curve.limit};
}

}  // namespace

void bind_fatigue(nb::module_& module) {
    nb::class_<SNCurve>(module, "SNCurve")
        .def("find_fault", [](const SNCurve& curve) { return find_fault(curve); })
        .def("endured_cycles", &SNCurve::endured_cycles, "range"_a);
    module.def("make_curve", &curve_of, "lines"_a, "limit"_a, "factor"_a);
    module.def("list_eurocode_lines", &list_eurocode_lines, "category"_a);
    module.def("rainflow", &count_series, "values"_a, "Rows of range, mean and count.");
    module.def(
        "compute_damage",
        [](const Rows& cycles, const SNCurve& curve, double ultimate) {
            return compute_damage(cycles_of(cycles), curve, ultimate);
        },
        "cycles"_a,
        "curve"_a,
        "ultimate"_a);
    module.def(
        "compute_equivalent_range",
        [](const Rows& cycles, double slope, double number) {
            return compute_equivalent_range(cycles_of(cycles), slope, number);
        },
        "cycles"_a,
        "slope"_a,
        "number"_a);
}

}  // namespace gxrod::python
