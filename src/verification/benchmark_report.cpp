#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "verification/benchmark.hpp"

// The refinements of a benchmark, run and held to what is asked of them.
namespace gxrod {

namespace {

constexpr double order_tolerance = 0.3;

struct CheckRow {
    std::string overrides;
    BenchmarkRun run;
    std::optional<double> order;  // not for the first of a refinement, nor below the floor
};

// log₂ of the fall of the error; refinements double elements or steps from row to row.
std::optional<double> find_order(const Refinement& refinement, double before, double now) {
    if (before <= refinement.floor || now <= refinement.floor) return std::nullopt;
    return std::log2(before / now);
}

std::vector<CheckRow> run_rows(const Benchmark& benchmark, const Refinement& refinement) {
    std::vector<CheckRow> rows;
    for (const std::vector<std::string>& overrides : refinement.rows) {
        CheckRow row{
            fmt::format("{}", fmt::join(overrides, " ")), run_benchmark(benchmark, overrides), std::nullopt};
        if (!rows.empty()) row.order = find_order(refinement, rows.back().run.error, row.run.error);
        rows.push_back(std::move(row));
    }
    return rows;
}

// The finest pair of rows above the floor shows the order.
std::optional<double> finest_order(const std::vector<CheckRow>& rows) {
    std::optional<double> order;
    for (const CheckRow& row : rows) {
        if (row.order) order = row.order;
    }
    return order;
}

std::string describe(const BenchmarkValue& value) {
    const std::string name = value.source == "ledger" ? value.quantity : value.source + " " + value.quantity;
    if (value.is_of_shapes) return name;
    if (value.where)
        return fmt::format("{} where {} = {:.10g}", name, "xyz"[value.where->component], value.where->is);
    return value.is_constant ? name + ", all times" : fmt::format("{}, t = {:.10g}", name, value.time);
}

// The order of one value's error, by the last two rows.
std::optional<double> value_order(const Refinement& refinement,
                                  const std::vector<CheckRow>& rows,
                                  std::size_t i) {
    if (rows.size() < 2 || refinement.order == 0.0) return std::nullopt;
    return find_order(refinement, (rows.end() - 2)->run.values[i].error, rows.back().run.values[i].error);
}

void add_value_checks(const Benchmark& benchmark,
                      const Refinement& refinement,
                      const std::vector<CheckRow>& rows,
                      std::vector<Check>& checks) {
    for (std::size_t i = 0; i < benchmark.values.size(); ++i) {
        const BenchmarkValue& value = benchmark.values[i];
        const FoundValue& found = rows.back().run.values[i];
        checks.push_back({describe(value) + "; " + refinement.name,
                          value.reference,
                          value.uncertainty,
                          found.value,
                          found.error,
                          refinement.tolerance,
                          value_order(refinement, rows, i)});
    }
}

bool add_checks(const Benchmark& benchmark,
                const Refinement& refinement,
                const std::vector<CheckRow>& rows,
                StudyResult& result) {
    std::vector<Check> checks;
    if (refinement.tolerance > 0.0) add_value_checks(benchmark, refinement, rows, checks);
    const std::optional<double> order = finest_order(rows);
    if (refinement.order > 0.0 && order)
        checks.push_back(make_order_check(refinement.name, refinement.order, *order, order_tolerance));
    result.checks.insert(result.checks.end(), checks.begin(), checks.end());
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed(); });
}

nlohmann::ordered_json to_json(const std::string& refinement, const CheckRow& row) {
    return {{"refinement", refinement},
            {"set", row.overrides},
            {"unknowns", row.run.unknowns},
            {"steps", row.run.steps},
            {"newton_iterations", row.run.newton_iterations},
            {"seconds", row.run.seconds},
            {"error", row.run.error},
            {"order", row.order ? nlohmann::ordered_json(*row.order) : nlohmann::ordered_json()},
            {"energy_error", row.run.energy_error}};
}

std::string to_line(const std::string& refinement, const CheckRow& row) {
    return fmt::format("{:>9}{:>7}{:>8}{:>11.2e}{:>7}  {}: {}\n",
                       row.run.unknowns,
                       row.run.steps,
                       row.run.newton_iterations,
                       row.run.error,
                       row.order ? fmt::format("{:.2f}", *row.order) : "-",
                       refinement,
                       row.overrides);
}

}  // namespace

StudyResult report_benchmark(const Benchmark& benchmark) {
    StudyResult result;
    result.json = nlohmann::ordered_json::array();
    result.table = fmt::format(
        "{:>9}{:>7}{:>8}{:>11}{:>7}  {}\n", "unknowns", "steps", "Newton", "error", "order", "refinement");
    for (const Refinement& refinement : benchmark.refinements) {
        const std::vector<CheckRow> rows = run_rows(benchmark, refinement);
        const bool matches = add_checks(benchmark, refinement, rows, result);
        for (const CheckRow& row : rows) {
            const bool is_missed = !matches && &row == &rows.back();
            const std::string name = refinement.name + (is_missed ? " MISSED" : "");
            result.json.push_back(to_json(name, row));
            result.table += to_line(name, row);
        }
    }
    return result;
}

}  // namespace gxrod
