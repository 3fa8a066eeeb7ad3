#include "results/export/along_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"
#include "results/export/rod_line.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {
namespace {

constexpr hsize_t vector_width = 3;

// Vector fields of points, or of cells.
struct Field {
    std::string name;
    std::string path;
};

std::vector<Field> list_vectors(const Hdf5Reader& file, const std::string& group) {
    std::vector<Field> fields;
    for (const std::string& name : file.members(group)) {
        const std::string path = fmt::format("{}/{}", group, name);
        if (file.width(path) == vector_width) fields.push_back({name, path});
    }
    return fields;
}

// One frame of a field: its vectors by point or cell.
class Vectors {
  public:
    Vectors(const Hdf5Reader& file, const Field& field, hsize_t frame, hsize_t rows)
        : values_(file.rows(field.path, frame * rows, rows, vector_width)) {}

    double at(std::size_t row, std::size_t component) const {
        return values_.at(vector_width * row + component);
    }

  private:
    std::vector<double> values_;
};

using TextBuffer = fmt::memory_buffer;

void append_number(TextBuffer& text, double number) {
    fmt::format_to(std::back_inserter(text), ",{}", number);
}

// A results file and what to export of it.
class AlongTables {
  public:
    AlongTables(const Hdf5Reader& file, const std::filesystem::path& results, const AlongRod& request)
        : file_(file),
          line_(read_rod_line(file, find_rod(results, request.rod))),
          points_(static_cast<hsize_t>(file.count("/VTKHDF/NumberOfPoints"))),
          cells_(static_cast<hsize_t>(file.count("/VTKHDF/NumberOfCells"))),
          point_fields_(list_vectors(file, "/VTKHDF/PointData")),
          cell_fields_(list_vectors(file, "/VTKHDF/CellData")) {
        for (const char* name : {"wall_tension", "von_mises", "exposure"}) {
            const std::string path = std::string("/VTKHDF/CellData/") + name;
            if (file.has(path)) cell_numbers_.push_back({name, path});
        }
        point_fields_.insert(point_fields_.begin(), {"position", "/VTKHDF/Points"});
        choose_frames(results, request);
    }

    std::vector<double> chosen_times() const {
        std::vector<double> chosen;
        for (const hsize_t frame : frames_) chosen.push_back(times_[frame]);
        return chosen;
    }

    // Heading, then frame by frame.
    void write_nodes(std::ostream& out) const {
        out << time_name() << ",arc_length,element,point" << headings(point_fields_) << '\n';
        for (const hsize_t frame : frames_) {
            const std::vector<Vectors> fields = read(point_fields_, frame, points_);
            TextBuffer text;
            for (const RodLine::Node& node : line_.nodes) {
                append_place(text, {times_[frame], node.arc_length, node.element, node.point});
                for (const Vectors& field : fields) {
                    for (std::size_t i = 0; i < vector_width; ++i)
                        append_number(text, field.at(node.point, i));
                }
                text.push_back('\n');
            }
            out.write(text.data(), static_cast<std::streamsize>(text.size()));
        }
    }

    void write_elements(std::ostream& out) const {
        const std::vector<Field> interpolated{{"position", "/VTKHDF/Points"},
                                              {"displacement", "/VTKHDF/PointData/displacement"}};
        out << time_name() << ",arc_length,element,cell" << headings(interpolated) << headings(cell_fields_)
            << number_headings() << '\n';
        for (const hsize_t frame : frames_) {
            const std::vector<Vectors> at_nodes = read(interpolated, frame, points_);
            const std::vector<Vectors> fields = read(cell_fields_, frame, cells_);
            const std::vector<double> tensions =
                file_.rows("/VTKHDF/CellData/force", frame * cells_, cells_, vector_width);
            std::vector<std::vector<double>> numbers;
            for (const Field& field : cell_numbers_)
                numbers.push_back(file_.rows(field.path, frame * cells_, cells_, 1));
            TextBuffer text;
            for (std::size_t number = 0; number < line_.elements.size(); ++number) {
                const RodLine::Element& element = line_.elements[number];
                append_place(text, {times_[frame], element.middle, number, element.cell});
                for (const Vectors& field : at_nodes) append_middle(text, field, element);
                for (const Vectors& field : fields) {
                    for (std::size_t i = 0; i < vector_width; ++i)
                        append_number(text, field.at(element.cell, i));
                }
                append_number(text, tensions.at(vector_width * element.cell));
                for (const std::vector<double>& field : numbers) append_number(text, field.at(element.cell));
                text.push_back('\n');
            }
            out.write(text.data(), static_cast<std::streamsize>(text.size()));
        }
    }

  private:
    struct Place {
        double time, arc_length;
        std::size_t element, row;
    };

    std::size_t find_rod(const std::filesystem::path& results, const std::string& name) const {
        const std::vector<std::string> names = read_rod_names(file_);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
        if (names.empty() && file_.has("/VTKHDF/CellData/arc_length"))
            throw FileError(results, "has no rods");
        if (names.empty()) {
            throw FileError(results,
                            "does not say where its rods are: an earlier version of gxrod wrote it",
                            "run it again with gxrod run");
        }
        constexpr std::size_t most_named = 20;
        const std::size_t named = std::min(names.size(), most_named);
        const std::string more =
            named < names.size() ? fmt::format(" and {} more", names.size() - named) : "";
        throw FileError(results,
                        "has no rod " + name,
                        fmt::format("it has {}{}",
                                    fmt::join(names.begin(), names.begin() + static_cast<long>(named), ", "),
                                    more));
    }

    void choose_frames(const std::filesystem::path& results, const AlongRod& request) {
        times_ = file_.numbers("/VTKHDF/Steps/Values");
        if (times_.empty()) throw FileError(results, "has no frame yet");
        if (request.all_frames) {
            for (hsize_t frame = 0; frame < times_.size(); ++frame) frames_.push_back(frame);
            return;
        }
        const double time = request.time.value_or(times_.back());
        if (!(time >= times_.front() && time <= times_.back())) {
            throw FileError(
                results,
                fmt::format("has no frame near t = {:.10g}", time),
                fmt::format("its frames are from t = {:.10g} to {:.10g}", times_.front(), times_.back()));
        }
        const auto nearest = std::min_element(times_.begin(), times_.end(), [&](double a, double b) {
            return std::abs(a - time) < std::abs(b - time);
        });
        frames_.push_back(static_cast<hsize_t>(nearest - times_.begin()));
    }

    std::string time_name() const {
        const bool is_static = file_.text_attribute("/histories/time", "dimension") == "1";
        return is_static ? "load_factor" : "time";
    }

    static std::string headings(const std::vector<Field>& fields) {
        std::string text;
        for (const Field& field : fields) {
            for (const char* component : {"x", "y", "z"})
                text += fmt::format(",{}_{}", field.name, component);
        }
        return text;
    }

    std::string number_headings() const {
        std::string text = ",effective_tension";
        for (const Field& field : cell_numbers_) text += "," + field.name;
        return text;
    }

    std::vector<Vectors> read(const std::vector<Field>& fields, hsize_t frame, hsize_t rows) const {
        std::vector<Vectors> read;
        for (const Field& field : fields) read.emplace_back(file_, field, frame, rows);
        return read;
    }

    static void append_place(TextBuffer& text, const Place& place) {
        fmt::format_to(
            std::back_inserter(text), "{},{},{},{}", place.time, place.arc_length, place.element, place.row);
    }

    static void append_middle(TextBuffer& text, const Vectors& field, const RodLine::Element& element) {
        const std::vector<double>& weights = middle_weights(element.points.size());
        for (std::size_t i = 0; i < vector_width; ++i) {
            double value = 0.0;
            for (std::size_t j = 0; j < weights.size(); ++j)
                value += weights[j] * field.at(element.points[j], i);
            append_number(text, value);
        }
    }

    const Hdf5Reader& file_;
    RodLine line_;
    hsize_t points_ = 0, cells_ = 0;
    std::vector<Field> point_fields_, cell_fields_;
    std::vector<Field> cell_numbers_;  // wall tension and stresses, if the file has them
    std::vector<double> times_;
    std::vector<hsize_t> frames_;
};

template <class Write>
void write_file(const std::filesystem::path& path, Write&& write) {
    std::ofstream out(path, std::ios::binary);
    write(out);
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

}  // namespace

AlongExport export_along(const std::filesystem::path& results,
                         const std::filesystem::path& folder,
                         const AlongRod& request,
                         Existing existing) {
    AlongExport done;
    done.files = {folder / fmt::format("along_{}_nodes.csv", request.rod),
                  folder / fmt::format("along_{}_elements.csv", request.rod)};
    read_results(results, [&](const Hdf5Reader& file) {
        const AlongTables tables(file, results, request);
        prepare_export(folder, done.files, existing);
        existing = Existing::replace;  // a second attempt finds our own files
        done.times = tables.chosen_times();
        write_file(done.files[0], [&](std::ostream& out) { tables.write_nodes(out); });
        write_file(done.files[1], [&](std::ostream& out) { tables.write_elements(out); });
    });
    return done;
}

}  // namespace gxrod
