#include "results/tables/shape_table.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace gxrod {
namespace {

class Writer {
  public:
    Writer(const Hdf5Handle& group, const Model& model) : group_(group), model_(model) {}

    void operator()(const ModesRecord& record) {
        const auto column =
            [&](const char* name, const char* description, const char* dimension, auto member) {
                write_column(record.modes, {name, description, "none", dimension}, member);
            };
        column("frequency", "cycles per time; 0 of a mode that grows", "1/time", &Mode::frequency);
        column("omega", "2 pi times the frequency", "angle/time", &Mode::omega);
        column("growth", "rate of a mode that grows instead of vibrating", "1/time", &Mode::growth);
        column("residual",
               "some eigenvalue lies so near to omega squared, relative to its distance from the shift",
               "1",
               &Mode::residual);
        std::vector<double> masses;
        for (const Mode& mode : record.modes)
            masses.insert(masses.end(), mode.effective_mass.begin(), mode.effective_mass.end());
        const std::array<hsize_t, 2> size{record.modes.size(), 6};
        write_dataset(group_,
                      {"effective_mass",
                       "met by motions of the whole model along x, y, z and about them through the origin",
                       "spatial",
                       "mass; mass·length²"},
                      size,
                      masses);
        write_dataset(group_,
                      {"total_mass", "of the model, in the same directions", "spatial", "mass; mass·length²"},
                      std::span<const double>(record.total_mass.data(), 6));
        write_number("time", record.time);
        write_number("limit", record.limit);
        write_count("counted_below_limit", record.counted);
        write_count("found_below_limit", record.found);
        write_count("complete", record.is_complete ? 1 : 0);
        write_count("unstable", record.unstable);
        write_number("unsymmetry", record.unsymmetry);
    }

    void operator()(const BucklingRecord& record) {
        std::vector<double> factors, residuals;
        for (const auto* list : {&record.factors, &record.reversed}) {
            for (const BucklingFactor& one : *list) {
                factors.push_back(one.factor);
                residuals.push_back(one.residual);
            }
        }
        write_dataset(group_,
                      {"factor",
                       "on the loads; positive ones rising, then those of the loads turned round",
                       "none",
                       "1"},
                      factors);
        write_dataset(group_, {"residual", "relative error of the factor", "none", "1"}, residuals);
        write_number("load_time", record.load_time);
        write_number("limit", record.limit);
        write_count("counted_positive", record.counted_positive);
        write_count("counted_negative", record.counted_negative);
        write_count("complete", record.is_complete ? 1 : 0);
    }

    void operator()(const EigenvaluesRecord& record) {
        const auto column =
            [&](const char* name, const char* description, const char* dimension, auto member) {
                write_column(record.modes, {name, description, "none", dimension}, member);
            };
        column("growth", "real part of the eigenvalue", "1/time", &Eigenmode::growth);
        column("omega", "its imaginary part", "angle/time", &Eigenmode::omega);
        column("frequency", "cycles per time", "1/time", &Eigenmode::frequency);
        column("damping_ratio", "-Re / |eigenvalue|", "1", &Eigenmode::damping_ratio);
        column("residual", "of the eigenvalue problem, relative to the shape", "1", &Eigenmode::residual);
        write_number("time", record.time);
        write_number("shift", record.shift);
        write_number("radius", record.radius);
        write_count("missing", record.missing);
        write_count("complete", record.is_complete || record.is_all ? 1 : 0);
        write_count("unstable", record.unstable);
    }

    void operator()(const ResponseRecord& record) {
        std::vector<double> omegas, frequencies, errors;
        for (const Response& response : record.responses) {
            omegas.push_back(response.omega);
            frequencies.push_back(response.omega / (2.0 * std::numbers::pi));
            errors.push_back(response.error);
        }
        write_dataset(group_, {"omega", "of the forces", "none", "angle/time"}, omegas);
        write_dataset(group_, {"frequency", "cycles per time", "none", "1/time"}, frequencies);
        write_dataset(group_, {"error", "relative, of the motion, by round-off", "none", "1"}, errors);
        write_number("time", record.time);
        const Hdf5Handle histories = require_group(group_, "histories");
        for (const ResponsePoint& point : record.points) {
            const Hdf5Handle own = require_group(histories, point.name);
            const auto write = [&](const char* name, const char* dimension, auto vectors, int first) {
                write_answer(own, {name, complex, "spatial", dimension}, record, point.node, vectors, first);
            };
            write("displacement", "length", &Response::motion, 0);
            write("rotation_vector", "angle", &Response::motion, 3);
            write("reaction_force", "force", &Response::reactions, 0);
            write("reaction_moment", "force·length", &Response::reactions, 3);
        }
    }

    void operator()(const SweepRecord& record) {
        std::vector<std::string> words;
        std::vector<double> values, speeds, growths, omegas, corruption, largest;
        for (const SweepRecord::Point& point : record.points) {
            values.push_back(point.value);
            speeds.push_back(point.speed);
            largest.push_back(point.failure.empty() ? point.growth : std::nan(""));
            for (std::size_t i = 0; i < record.words.size(); ++i) {
                const bool is_known = i < point.lambda.size();
                growths.push_back(is_known ? point.lambda[i].real() : std::nan(""));
                omegas.push_back(is_known ? point.lambda[i].imag() : std::nan(""));
                corruption.push_back(is_known ? point.corruption[i] : std::nan(""));
                words.push_back(is_known ? point.words[i] : "");
            }
        }
        write_dataset(group_, {sweep_values_name, "of " + record.key, "none", "as in the deck"}, values);
        write_dataset(group_, {"speed", "at which the state turns", "none", "angle/time"}, speeds);
        const std::array<hsize_t, 2> size{values.size(), record.words.size()};
        write_dataset(
            group_, {"omega", "imaginary part, a column for each mode", "none", "angle/time"}, size, omegas);
        write_dataset(group_, {"growth", "real part, likewise", "none", "1/time"}, size, growths);
        write_dataset(group_,
                      {"corruption",
                       "how much each mode has of another one of the value before, compared with its own",
                       "none",
                       "1"},
                      size,
                      corruption);
        write_dataset(
            group_, {"largest_growth", "largest real part of all found", "none", "1/time"}, largest);
        write_dataset(group_,
                      {shape_words_name, "each mode in words, at the first value", "none", "none"},
                      record.words);
        write_dataset(
            group_, {sweep_words_name, "the same at each value, value by value", "none", "none"}, words);
        write_onsets(record.onsets);
        write_attribute(group_.id(), "key", record.key);
    }

    void write_onsets(const std::vector<Onset>& onsets) {
        if (onsets.empty()) return;
        std::vector<double> values, omegas;
        std::vector<std::int64_t> begins;
        std::vector<std::string> kinds;
        for (const Onset& onset : onsets) {
            values.push_back(onset.value);
            omegas.push_back(onset.omega);
            begins.push_back(onset.begins ? 1 : 0);
            kinds.emplace_back(name_kind(onset));
        }
        const Hdf5Handle own = require_group(group_, onsets_name);
        write_dataset(
            own, {"value", "where motions begin to grow, or cease to", "none", "as in the deck"}, values);
        write_dataset(own, {"omega", "of the motion; 0 of divergence", "none", "angle/time"}, omegas);
        write_dataset(
            own, {"begins", "1 if it begins as the value goes on, 0 if it ends", "none", "1"}, begins);
        write_dataset(own, {"kind", "flutter or divergence", "none", "none"}, kinds);
    }

    void write_shapes(const std::vector<const Shape*>& shapes, std::span<const double> scales) {
        std::vector<double> shares;
        std::vector<std::string> words;
        for (const Shape* shape : shapes) {
            words.push_back(shape->words);
            for (const Vec6& of_rod : shape->energy_shares)
                shares.insert(shares.end(), of_rod.begin(), of_rod.end());
        }
        const std::array<hsize_t, 3> size{shapes.size(), model_.rods.size(), 6};
        write_dataset(group_,
                      {"energy_share",
                       "of extension, shear along y and z, torsion, bending about y and z of each rod in the "
                       "strain energy of the shape",
                       "material",
                       "1"},
                      size,
                      shares);
        write_scales(scales);
        write_dataset(group_, {shape_words_name, "the shape in words", "none", "none"}, words);
    }

    void write_scales(std::span<const double> scales) {
        write_dataset(
            group_, {"scale", "what the shape is multiplied by in its own file", "none", "1"}, scales);
    }

  private:
    static constexpr const char* complex =
        "amplitude about the state: of each component real and imaginary part, the motion is Re(amplitude "
        "exp(i omega t))";

    static void write_answer(const Hdf5Handle& group,
                             const DatasetLabel& label,
                             const ResponseRecord& record,
                             int node,
                             ComplexVectors Response::*vectors,
                             int first) {
        std::vector<double> values;
        for (const Response& response : record.responses) {
            const ComplexVectors& found = response.*vectors;
            for (int i = first; i < first + 3; ++i) {
                const bool is_known = response.failure.empty();
                values.push_back(is_known ? found.real[node][i] : std::nan(""));
                values.push_back(is_known ? found.imaginary[node][i] : std::nan(""));
            }
        }
        const std::array<hsize_t, 3> size{record.responses.size(), 3, 2};
        write_dataset(group, label, size, values);
    }

    template <class Row>
    void write_column(const std::vector<Row>& rows, const DatasetLabel& label, double Row::*member) {
        std::vector<double> values;
        for (const Row& row : rows) values.push_back(row.*member);
        write_dataset(group_, label, values);
    }
    void write_number(const char* name, double value) { write_attribute(group_.id(), name, value); }
    void write_count(const char* name, std::int64_t value) {
        write_attribute(group_.id(), name, std::span(&value, 1));
    }

    const Hdf5Handle& group_;
    const Model& model_;
};

}  // namespace

void write_shape_table(const Hdf5Handle& group,
                       const Model& model,
                       const ShapesRecord& record,
                       std::span<const double> scales) {
    Writer writer(group, model);
    std::visit(std::ref(writer), record);
    if (has_shapes(record)) {
        writer.write_shapes(list_shapes_of(record), scales);
    } else if (!scales.empty()) {
        writer.write_scales(scales);
    }
}

std::vector<const Shape*> list_shapes_of(const ShapesRecord& record) {
    std::vector<const Shape*> shapes;
    if (const auto* modes = std::get_if<ModesRecord>(&record)) {
        for (const Mode& mode : modes->modes) shapes.push_back(&mode.shape);
        return shapes;
    }
    if (const auto* found = std::get_if<EigenvaluesRecord>(&record)) {
        for (const Eigenmode& mode : found->modes) shapes.push_back(&mode.shape);
        return shapes;
    }
    if (const auto* sweep = std::get_if<SweepRecord>(&record)) {
        for (const SweepRecord::Point& point : sweep->points) {
            for (const Eigenmode& mode : point.modes) shapes.push_back(&mode.shape);
        }
        return shapes;
    }
    if (!has_shapes(record)) return shapes;
    const auto& buckling = std::get<BucklingRecord>(record);
    for (const auto* list : {&buckling.factors, &buckling.reversed}) {
        for (const BucklingFactor& one : *list) shapes.push_back(&one.shape);
    }
    return shapes;
}

std::vector<const std::vector<Vec6>*> list_imaginary_parts(const ShapesRecord& record) {
    std::vector<const std::vector<Vec6>*> parts;
    if (const auto* found = std::get_if<EigenvaluesRecord>(&record)) {
        for (const Eigenmode& mode : found->modes) parts.push_back(&mode.imaginary);
    }
    if (const auto* sweep = std::get_if<SweepRecord>(&record)) {
        for (const SweepRecord::Point& point : sweep->points) {
            for (const Eigenmode& mode : point.modes) parts.push_back(&mode.imaginary);
        }
    }
    return parts;
}

std::vector<std::span<const NodeMotion>> list_equilibria_of(const ShapesRecord& record,
                                                            std::span<const NodeMotion> own) {
    const auto* sweep = std::get_if<SweepRecord>(&record);
    if (sweep == nullptr) return {own};
    std::vector<std::span<const NodeMotion>> equilibria;
    for (const SweepRecord::Point& point : sweep->points)
        equilibria.insert(equilibria.end(), point.modes.size(), point.nodes);
    return equilibria;
}

}  // namespace gxrod
