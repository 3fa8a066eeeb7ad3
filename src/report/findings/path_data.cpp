#include "report/findings/path_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/blocks/data_blocks.hpp"
#include "results/tables/path_table.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* load_column = "/histories/load_factor";

// Names of columns of a table, with their values as JSON.
class Table {
  public:
    Table(const Hdf5Reader& file, std::string group) : file_(file), group_(std::move(group)) {}

    std::vector<double> numbers(const char* name) const { return file_.numbers(group_ + "/" + name); }
    std::vector<std::string> texts(const char* name) const { return file_.texts(group_ + "/" + name); }

  private:
    const Hdf5Reader& file_;
    std::string group_;
};

// How many shapes a point has in the file of shapes: up to the first one of the next point that has some.
std::vector<int> count_shapes(const std::vector<double>& first_shapes,
                              const std::vector<double>& multiplicities) {
    std::vector<int> counts(first_shapes.size(), 0);
    double next = -1.0;
    for (std::size_t i = first_shapes.size(); i-- > 0;) {
        if (first_shapes[i] < 1.0) continue;
        const double count = next > 0.0 ? next - first_shapes[i] : multiplicities.at(i);
        counts[i] = static_cast<int>(std::clamp(count, 0.0, 100.0));
        next = first_shapes[i];
    }
    return counts;
}

template <class Number, class Values>
std::vector<Number> choose(const Values& values, const std::vector<std::size_t>& rows) {
    std::vector<Number> chosen;
    for (const std::size_t row : rows) chosen.push_back(static_cast<Number>(values.at(row)));
    return chosen;
}

}  // namespace

PathData::PathData(const Hdf5Reader& file,
                   const std::vector<FoundStage>& stages,
                   const std::vector<StepChart>& charts,
                   std::size_t steps,
                   std::size_t bytes)
    : file_(file) {
    if (!file.has(load_column) || steps == 0) return;
    for (const StepChart& chart : charts) {
        if (chart.group != "history") continue;
        charts_.push_back(chart);
        columns_ += chart.columns();
    }
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (stages[i].kind != "path") continue;
        const std::size_t end = i + 1 < stages.size() ? stages[i + 1].first_row : steps;
        const Stretch stretch{stages[i], std::min(stages[i].first_row, steps), std::min(end, steps)};
        if (stretch.first < stretch.end) stretches_.push_back(stretch);
    }
    if (stretches_.empty()) return;
    branches_ = file.rows("/histories/branch", 0, steps, 1);
    pivots_ = file.has("/solver/negative_pivots") ? file.rows("/solver/negative_pivots", 0, steps, 1)
                                                  : std::vector<double>(steps, -1.0);
    choose_rows(bytes);
}

std::size_t PathData::bytes_of_row() const {
    constexpr std::size_t other = 2 * sizeof(double) + 2 * sizeof(std::int32_t);
    return base64_length(other + columns_ * sizeof(float));
}

void PathData::choose_rows(std::size_t bytes) {
    for (const Stretch& stretch : stretches_) all_rows_ += stretch.end - stretch.first;
    const std::size_t most = std::max<std::size_t>(bytes / bytes_of_row(), 20);
    const std::size_t stride = all_rows_ <= most ? 1 : all_rows_ / most + 1;
    std::vector<bool> is_kept(branches_.size(), false);
    for (const Stretch& stretch : stretches_) {
        for (std::size_t row = stretch.first; row < stretch.end; ++row) {
            const bool starts = row == stretch.first || branches_[row] != branches_[row - 1];
            const bool ends = row + 1 == stretch.end || branches_[row] != branches_[row + 1];
            const bool turns = row > stretch.first && (pivots_[row] > 0.0) != (pivots_[row - 1] > 0.0);
            is_kept[row] = starts || ends || turns || (row - stretch.first) % stride == 0;
        }
        if (!stretch.stage.has(file_, critical_points_name)) continue;
        const Table points(file_, stretch.stage.group() + "/" + critical_points_name);
        for (const double row : points.numbers("row")) {
            if (row >= 0.0 && row < static_cast<double>(is_kept.size()))
                is_kept[static_cast<std::size_t>(row)] = true;
        }
    }
    for (std::size_t row = 0; row < is_kept.size(); ++row) {
        if (is_kept[row]) rows_.push_back(row);
    }
}

std::size_t PathData::count_bytes() const {
    return is_empty() ? 0 : rows_.size() * bytes_of_row() + 5 * (block_frame_bytes + 4);
}

std::string PathData::left_out() const {
    if (rows_.size() >= all_rows_) return "";
    return fmt::format(
        "Of {} steps along paths, charts over the load factor have {}.", all_rows_, rows_.size());
}

std::size_t PathData::place_of(double row) const {
    const auto found =
        std::lower_bound(rows_.begin(), rows_.end(), static_cast<std::size_t>(std::max(row, 0.0)));
    return static_cast<std::size_t>(std::min(found, rows_.end() - 1) - rows_.begin());
}

std::vector<std::size_t> PathData::list_rows_of_shapes(const FoundStage& stage) const {
    std::vector<std::size_t> rows_of_shapes;
    if (is_empty() || !stage.has(file_, critical_points_name)) return rows_of_shapes;
    const Table table(file_, stage.group() + "/" + critical_points_name);
    const std::vector<double> rows = table.numbers("row");
    const std::vector<int> counts = count_shapes(table.numbers("first_shape"), table.numbers("multiplicity"));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        rows_of_shapes.insert(rows_of_shapes.end(),
                              static_cast<std::size_t>(counts[i]),
                              static_cast<std::size_t>(std::max(rows.at(i), 0.0)));
    }
    return rows_of_shapes;
}

Json PathData::describe_points(const FoundStage& stage) const {
    Json list = Json::array();
    if (!stage.has(file_, critical_points_name)) return list;
    const Table table(file_, stage.group() + "/" + critical_points_name);
    const std::vector<std::string> kinds = table.texts("kind"), words = table.texts("words"),
                                   findings = table.texts("finding");
    const std::vector<double> rows = table.numbers("row"), loads = table.numbers("load_factor"),
                              branches = table.numbers("branch"), located = table.numbers("located"),
                              multiplicities = table.numbers("multiplicity"),
                              first_shapes = table.numbers("first_shape");
    const std::vector<int> counts = count_shapes(first_shapes, multiplicities);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        list.push_back({{"kind", kinds[i]},
                        {"row", place_of(rows.at(i))},
                        {"load_factor", loads.at(i)},
                        {"branch", static_cast<int>(branches.at(i))},
                        {"multiplicity", static_cast<int>(multiplicities.at(i))},
                        {"is_located", located.at(i) > 0.0},
                        {"first_shape", static_cast<int>(first_shapes.at(i)) - 1},
                        {"shapes", counts[i]},
                        {"words", words.at(i)},
                        {"finding", findings.at(i)}});
    }
    return list;
}

Json PathData::describe_paths(const FoundStage& stage) const {
    Json list = Json::array();
    if (!stage.has(file_, branches_name)) return list;
    const Table table(file_, stage.group() + "/" + branches_name);
    const std::vector<std::string> names = table.texts("name"), causes = table.texts("cause");
    const std::vector<double> parents = table.numbers("parent"), points = table.numbers("critical_point");
    for (std::size_t i = 0; i < names.size(); ++i) {
        list.push_back({{"name", names[i]},
                        {"parent", static_cast<int>(parents.at(i))},
                        {"critical_point", static_cast<int>(points.at(i))},
                        {"cause", causes.at(i)}});
    }
    return list;
}

Json PathData::describe() const {
    Json list = Json::array();
    for (const Stretch& stretch : stretches_) {
        const std::size_t first = place_of(static_cast<double>(stretch.first));
        const std::size_t last = place_of(static_cast<double>(stretch.end - 1));
        list.push_back({{"stage", stretch.stage.name},
                        {"first", first},
                        {"count", last + 1 - first},
                        {"paths", describe_paths(stretch.stage)},
                        {"points", describe_points(stretch.stage)}});
    }
    return list;
}

void PathData::write(std::ostream& out) const {
    if (is_empty()) return;
    const std::size_t steps = branches_.size();
    write_block(out, "path-times", choose<double>(file_.rows("/histories/time", 0, steps, 1), rows_));
    write_block(out, "path-loads", choose<double>(file_.rows(load_column, 0, steps, 1), rows_));
    write_block(out, "path-branches", choose<std::int32_t>(branches_, rows_));
    write_block(out, "path-pivots", choose<std::int32_t>(pivots_, rows_));
    write_block(out, "path-values", [&](Base64Writer& base64) {
        for (const StepChart& chart : charts_) write_chart_rows(file_, chart, rows_, steps, base64);
    });
}

}  // namespace gxrod
