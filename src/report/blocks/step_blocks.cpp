#include "report/blocks/step_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "report/blocks/data_blocks.hpp"
#include "results/component_labels.hpp"
#include "results/tables/stage_table.hpp"

namespace gxrod {

namespace {

constexpr std::size_t most_rows_at_once = 4096;

// Of joints and springs, as a reader asks for them: how far, how fast, what drives, what is passed on.
constexpr std::array<std::string_view, 13> joint_quantities{"angle",
                                                            "angle_rate",
                                                            "slide",
                                                            "slide_rate",
                                                            "elongation",
                                                            "axial_force",
                                                            "drive",
                                                            "friction",
                                                            "force",
                                                            "moment",
                                                            "force_a",
                                                            "moment_a",
                                                            "gap"};

std::size_t rank_of(const std::string& quantity) {
    return static_cast<std::size_t>(std::find(joint_quantities.begin(), joint_quantities.end(), quantity) -
                                    joint_quantities.begin());
}

// Of the history of a joint or spring in that order; else as the file has them.
std::vector<std::string> list_quantities(const Hdf5Reader& file, const std::string& history) {
    std::vector<std::string> names = file.members("/histories/" + history);
    if (std::all_of(names.begin(), names.end(), [](const std::string& name) {
            return rank_of(name) < joint_quantities.size();
        })) {
        std::sort(names.begin(), names.end(), [](const std::string& one, const std::string& other) {
            return rank_of(one) < rank_of(other);
        });
    }
    return names;
}

StepChart::Source find_source(const Hdf5Reader& file, const std::string& dataset, const std::string& label) {
    const std::size_t width = file.width(dataset);
    if (width == 3 && file.text_attribute(dataset, "frame") == "joint axes of A")
        return {dataset, {"axis", "across 1", "across 2", "magnitude"}, width};
    if (width == 1) return {dataset, {label}, width};
    const std::string name = dataset.substr(dataset.rfind('/') + 1);
    std::vector<std::string> labels = list_component_labels(name, width);
    if (labels[0] == "x") labels.emplace_back("magnitude");
    return {dataset, labels, width};
}

StepChart make_chart(const Hdf5Reader& file,
                     const std::string& group,
                     const std::string& title,
                     const std::vector<std::pair<std::string, std::string>>& datasets) {
    StepChart chart{title, group, "", "", "", "", {}};
    for (const auto& [dataset, label] : datasets) chart.sources.push_back(find_source(file, dataset, label));
    const std::string& first = datasets.front().first;
    chart.description = datasets.size() == 1 ? file.text_attribute(first, "description") : "";
    chart.frame = file.text_attribute(first, "frame");
    if (file.has_attribute(first, "dimension")) chart.dimension = file.text_attribute(first, "dimension");
    return chart;
}

// Calls `add` with each row of the first `steps` of a dataset.
template <class Add>
void for_each_row(
    const Hdf5Reader& file, const std::string& dataset, std::size_t width, std::size_t steps, Add&& add) {
    for (std::size_t first = 0; first < steps; first += most_rows_at_once) {
        const std::size_t count = std::min(most_rows_at_once, steps - first);
        const std::vector<double> rows = file.rows(dataset, first, count, width);
        for (std::size_t row = 0; row < count; ++row)
            add(std::span<const double>(rows).subspan(row * width, width));
    }
}

// Calls `add` with the number of a column and its value, row after row; a vector's magnitude comes last.
template <class Add>
void for_each_value(const Hdf5Reader& file, const StepChart::Source& source, std::size_t steps, Add&& add) {
    for_each_row(file, source.dataset, source.width, steps, [&](std::span<const double> row) {
        for (std::size_t i = 0; i < row.size(); ++i) add(i, row[i]);
        if (source.labels.size() > row.size()) add(row.size(), std::hypot(row[0], row[1], row[2]));
    });
}

void write_source(const Hdf5Reader& file,
                  const StepChart::Source& source,
                  const StepThinning& thinning,
                  std::size_t steps,
                  Base64Writer& base64) {
    std::vector<ColumnThinning> columns(source.labels.size(), ColumnThinning(thinning));
    for_each_value(
        file, source, steps, [&](std::size_t column, double value) { columns[column].add(value); });
    for (const ColumnThinning& column : columns) base64.write(std::span<const float>(column.values()));
}

}  // namespace

std::size_t StepChart::columns() const {
    std::size_t count = 0;
    for (const Source& source : sources) count += source.labels.size();
    return count;
}

std::vector<StepChart> list_charts(const Hdf5Reader& file, bool is_static) {
    std::vector<StepChart> charts;
    std::vector<std::pair<std::string, std::string>> energies;
    if (!is_static) energies.emplace_back("/ledger/kinetic_energy", "kinetic");
    energies.emplace_back("/ledger/strain_energy", "strain");
    energies.emplace_back("/ledger/external_work", "external work");
    energies.emplace_back("/ledger/dissipated_energy", "dissipated");
    const std::string by_scheme = "/ledger/numerical_dissipation";  // not in older files
    if (!is_static && file.has(by_scheme)) energies.emplace_back(by_scheme, "dissipated by the scheme");
    charts.push_back(make_chart(file, "energy", "Energies", energies));
    charts.push_back(make_chart(file, "energy", "Energy imbalance", {{"/ledger/energy_error", "imbalance"}}));
    for (const std::string& name : file.members("/histories")) {
        if (!is_history_name(name)) continue;
        for (const std::string& quantity : list_quantities(file, name)) {
            const std::string dataset = fmt::format("/histories/{}/{}", name, quantity);
            charts.push_back(make_chart(file, "history", name, {{dataset, quantity}}));
            charts.back().quantity = quantity;
        }
    }
    if (!is_static) {
        charts.push_back(make_chart(file, "momentum", "Linear momentum", {{"/ledger/linear_momentum", ""}}));
        charts.push_back(
            make_chart(file, "momentum", "Angular momentum", {{"/ledger/angular_momentum", ""}}));
    }
    charts.push_back(make_chart(file, "solver", "Step size", {{"/solver/time_step", "step size"}}));
    charts.push_back(make_chart(
        file,
        "solver",
        "Newton iterations",
        {{"/solver/newton_iterations", "iterations"}, {"/solver/rejected_steps", "rejected trials"}}));
    const std::string pivots = "/solver/negative_pivots";
    if (is_static && file.has(pivots)) {
        charts.push_back(
            make_chart(file, "solver", "Negative pivots of the tangent", {{pivots, "negative pivots"}}));
    }
    return charts;
}

nlohmann::ordered_json describe_charts(const std::vector<StepChart>& charts) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const StepChart& chart : charts) {
        nlohmann::ordered_json labels = nlohmann::ordered_json::array();
        for (const StepChart::Source& source : chart.sources) {
            for (const std::string& label : source.labels) labels.push_back(label);
        }
        list.push_back({{"title", chart.title},
                        {"group", chart.group},
                        {"quantity", chart.quantity},
                        {"description", chart.description},
                        {"dimension", chart.dimension},
                        {"frame", chart.frame},
                        {"labels", labels}});
    }
    return list;
}

void write_step_blocks(const Hdf5Reader& file,
                       const std::vector<StepChart>& charts,
                       const StepThinning& thinning,
                       std::size_t steps,
                       std::ostream& out) {
    std::vector<double> times;
    const std::vector<std::size_t> kept = thinning.steps();
    std::size_t step = 0;
    auto next = kept.begin();
    for_each_row(file, "/histories/time", 1, steps, [&](std::span<const double> row) {
        for (; next != kept.end() && *next == step; ++next) times.push_back(row[0]);
        ++step;
    });
    write_block(out, "step-times", times);
    write_block(out, "steps", [&](Base64Writer& base64) {
        for (const StepChart& chart : charts) {
            for (const StepChart::Source& source : chart.sources) {
                write_source(file, source, thinning, steps, base64);
            }
        }
    });
}

void write_chart_rows(const Hdf5Reader& file,
                      const StepChart& chart,
                      const std::vector<std::size_t>& rows,
                      std::size_t steps,
                      Base64Writer& base64) {
    for (const StepChart::Source& source : chart.sources) {
        std::vector<std::vector<float>> columns(source.labels.size());
        std::size_t row = 0;
        auto next = rows.begin();
        for_each_value(file, source, steps, [&](std::size_t column, double value) {
            if (next != rows.end() && *next == row) columns[column].push_back(static_cast<float>(value));
            if (column + 1 < columns.size()) return;
            if (next != rows.end() && *next == row) ++next;
            ++row;
        });
        for (const std::vector<float>& column : columns) base64.write(std::span<const float>(column));
    }
}

EnergySurvey survey_energy(const Hdf5Reader& file, bool is_static, std::size_t steps) {
    const std::string uncertainty = "/ledger/work_uncertainty";
    EnergySurvey survey;
    // Files of older versions do not have it; their jumps are unknown.
    survey.is_static = is_static;
    const bool finds_jumps = is_static && file.has(uncertainty);
    const std::string branch_column = "/histories/branch";
    EnergyPoint before;
    double branch_before = 0.0;
    bool has_point = false;
    for (std::size_t first = 0; first < steps; first += most_rows_at_once) {
        const std::size_t count = std::min(most_rows_at_once, steps - first);
        const auto read = [&](const std::string& name) { return file.rows(name, first, count, 1); };
        const std::vector<double> kinetic = read("/ledger/kinetic_energy");
        const std::vector<double> strain = read("/ledger/strain_energy");
        const std::vector<double> work = read("/ledger/external_work");
        const std::vector<double> error = read("/ledger/energy_error");
        std::vector<double> times, uncertain, branches(count);
        // What is stored or lost in addition to the strain energy; files of older versions lack some of it.
        std::vector<double> others(count);
        for (const char* name : {"dissipated_energy", "contact_energy", "contact_loss"}) {
            const std::string column = std::string("/ledger/") + name;
            if (!finds_jumps || !file.has(column)) continue;
            const std::vector<double> values = read(column);
            for (std::size_t i = 0; i < count; ++i) others[i] += values[i];
        }
        if (file.has(branch_column)) branches = read(branch_column);
        if (finds_jumps) {
            times = read("/histories/time");
            uncertain = read(uncertainty);
        }
        for (std::size_t i = 0; i < count; ++i) {
            survey.largest = std::max({survey.largest, kinetic[i] + strain[i], std::abs(work[i])});
            survey.largest_error = std::max(survey.largest_error, std::abs(error[i]));
            // What keeps a model turning does work that no load does.
            if (!finds_jumps || kinetic[i] != 0.0) {
                has_point = false;
                continue;
            }
            const EnergyPoint point{times[i], strain[i] + others[i], work[i], uncertain[i]};
            // The books of a branch start anew.
            const bool has_before = has_point && branches[i] == branch_before;
            const auto jump = has_before ? find_jump(before, point, survey.largest) : std::nullopt;
            if (jump) add_jump(*jump, survey.jumps);
            before = point;
            has_point = true;
            branch_before = branches[i];
        }
    }
    return survey;
}

}  // namespace gxrod
