#include "results/stresses/stress_table.hpp"

#include <array>
#include <limits>
#include <stdexcept>

#include "results/stresses/cross_section_table.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {
namespace {

Hdf5Handle open_dataset(const Hdf5Handle& group, const char* name) {
    return {H5Dopen2(group.id(), name, H5P_DEFAULT), H5Dclose, "opening a dataset"};
}

template <class Number>
hid_t type_in_memory() {
    return std::is_same_v<Number, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
}

template <class Number>
void write_all(const Hdf5Handle& dataset, const std::vector<Number>& values) {
    check_hdf5(H5Dwrite(dataset.id(), type_in_memory<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "writing a dataset");
}

template <class Number>
std::vector<Number> read_all(const Hdf5Handle& dataset, std::size_t count) {
    std::size_t stored = 1;
    for (const hsize_t size : extent_of(dataset.id())) stored *= size;
    if (stored != count) throw std::runtime_error("/envelopes is of another model");
    std::vector<Number> values(count);
    check_hdf5(H5Dread(dataset.id(), type_in_memory<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "reading a dataset");
    return values;
}

}  // namespace

StressTable::StressTable(const Hdf5Handle& root,
                         const Model& model,
                         const OutputSettings& output,
                         bool has_steps)
    : watch_(std::make_unique<StressWatch>(model, output.stresses)),
      envelope_(model, *watch_, list_rod_places(output.histories).size()) {
    const bool is_resumed = has_link(root, "envelopes");
    if (has_steps && !is_resumed)
        throw std::runtime_error(
            "the file has steps without stresses; leave output.stresses out, or run anew");
    write_cross_sections(root, watch_->shapes());
    group_ = require_group(root, "envelopes");
    if (!is_resumed) {
        write_attribute(group_.id(), "criterion", output.stresses);
        write_places(model);
    } else if (read_text_attribute(group_.id(), "criterion") != output.stresses) {
        throw std::runtime_error("the file has stresses by another criterion, " +
                                 read_text_attribute(group_.id(), "criterion"));
    }
    von_mises_ = open("von_mises", "largest von Mises stress", "force/length²");
    exposure_ = open("exposure", "largest exposure; NaN without a strength", "1");
    if (!has_steps) return;
    read(von_mises_, envelope_.von_mises());
    read(exposure_, envelope_.exposure());
}

void StressTable::write_places(const Model& model) const {
    std::vector<std::int64_t> rods, elements, sections;
    std::vector<double> arc_lengths;
    for (const StressEnvelope::Place& place : envelope_.places()) {
        rods.push_back(place.at.rod);
        elements.push_back(place.at.element);
        sections.push_back(place.shapes.front().shape);
        arc_lengths.push_back(arc_length_at(model, place.at));
    }
    using Integers = std::span<const std::int64_t>;
    write_dataset(group_, {"rod", "number of the rod in /rods, from 0", "none", "1"}, Integers(rods));
    write_dataset(
        group_, {"element", "number of the element in its rod, from 0", "none", "1"}, Integers(elements));
    write_dataset(
        group_,
        {"section", "number of the section in /sections; between two stations the nearer one", "none", "1"},
        Integers(sections));
    write_dataset(group_,
                  {"arc_length", "from the start of the rod, where it is free of stress", "none", "length"},
                  std::span<const double>(arc_lengths));
}

StressTable::Measure StressTable::open(const std::string& name,
                                       const std::string& meaning,
                                       const std::string& dimension) const {
    const bool is_new = !has_link(group_, name);
    const Hdf5Handle group = require_group(group_, name);
    const hsize_t count = envelope_.places().size();
    if (is_new) {
        const std::array<hsize_t, 1> one{count};
        const std::array<hsize_t, 2> two{count, 2}, six{count, 6};
        create_dataset(
            group, {"value", meaning + " of all steps so far", "none", dimension}, H5T_IEEE_F64LE, one);
        create_dataset(group, {"time", "when it was", "none", "time"}, H5T_IEEE_F64LE, one);
        create_dataset(
            group, {"point", "where in the section, (y, z)", "material", "length"}, H5T_IEEE_F64LE, two);
        create_dataset(group, {"layer", "in which of its layers", "none", "1"}, H5T_STD_I64LE, one);
        create_dataset(group,
                       {"resultants", "N Vy Vz T My Mz then", "material", "force; force·length"},
                       H5T_IEEE_F64LE,
                       six);
    }
    return {open_dataset(group, "value"),
            open_dataset(group, "time"),
            open_dataset(group, "point"),
            open_dataset(group, "layer"),
            open_dataset(group, "resultants")};
}

void StressTable::read(const Measure& from, std::vector<WorstStress>& worst) {
    const std::size_t count = worst.size();
    const auto values = read_all<double>(from.value, count), times = read_all<double>(from.time, count);
    const auto points = read_all<double>(from.point, 2 * count);
    const auto resultants = read_all<double>(from.resultants, 6 * count);
    const auto layers = read_all<std::int64_t>(from.layer, count);
    for (std::size_t i = 0; i < count; ++i) {
        worst[i] = {.value = std::isnan(values[i]) ? 0.0 : values[i],
                    .time = times[i],
                    .at = {points[2 * i], points[2 * i + 1]},
                    .layer = static_cast<int>(layers[i]),
                    .resultants = Eigen::Map<const Vec6>(&resultants[6 * i])};
    }
}

void StressTable::write(const std::vector<WorstStress>& worst, const Measure& into) {
    std::vector<double> values, times, points, resultants;
    std::vector<std::int64_t> layers;
    for (const WorstStress& one : worst) {
        values.push_back(one.value);
        times.push_back(one.time);
        points.insert(points.end(), {one.at.x(), one.at.y()});
        layers.push_back(one.layer);
        resultants.insert(resultants.end(), one.resultants.begin(), one.resultants.end());
    }
    write_all(into.value, values);
    write_all(into.time, times);
    write_all(into.point, points);
    write_all(into.layer, layers);
    write_all(into.resultants, resultants);
}

void StressTable::flush() {
    write(envelope_.von_mises(), von_mises_);
    std::vector<WorstStress> exposure = envelope_.exposure();
    for (std::size_t i = 0; i < exposure.size(); ++i) {
        if (!watch_->stresses_of(envelope_.places()[i].shapes.front().shape).has_strength())
            exposure[i].value = std::numeric_limits<double>::quiet_NaN();
    }
    write(exposure, exposure_);
}

}  // namespace gxrod
