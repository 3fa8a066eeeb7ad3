#include "verification/benchmark.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "verification/deck_run.hpp"
#include "verification/example_texts.hpp"

namespace gxrod {

namespace {

constexpr double order_tolerance = 0.3;
constexpr double same_time = 1e-9;  // relative to the end of the run

double distance(const std::vector<double>& reference, const double* values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!std::isnan(reference[i])) sum += (values[i] - reference[i]) * (values[i] - reference[i]);
    }
    return std::sqrt(sum);
}

// A value of the ledger, three numbers or one.
Vec3 ledger_value(const std::string& quantity, const LedgerRow& row) {
    if (quantity == "linear_momentum") return row.linear_momentum;
    if (quantity == "angular_momentum") return row.angular_momentum;
    if (quantity == "energy") return {row.kinetic_energy + row.strain_energy, 0.0, 0.0};
    if (quantity == "strain_energy") return {row.strain_energy, 0.0, 0.0};
    if (quantity == "external_work") return {row.external_work, 0.0, 0.0};
    if (quantity == "energy_less_work") {
        return {row.kinetic_energy + row.strain_energy - row.external_work, 0.0, 0.0};
    }
    throw std::runtime_error("the ledger has no " + quantity);
}

// The error of a value now; nothing if its time is another.
std::optional<double> find_error(const BenchmarkValue& value, DeckRun& run) {
    if (std::abs(run.analysis().state().time - value.time) > same_time * run.end_time()) return std::nullopt;
    const double error =
        value.source == "ledger"
            ? distance(value.reference, ledger_value(value.quantity, run.analysis().ledger_row()).data())
            : distance(value.reference, run.value(value.source, value.quantity).data());
    return error / value.scale;
}

struct Row {
    std::string refinement;
    std::string overrides;
    BenchmarkRun run;
    std::optional<double> order;  // none of the first of a refinement, nor below the floor
};

// log₂ of the fall of the error; refinements double elements or steps from row to row.
std::optional<double> find_order(const Refinement& refinement, double before, double now) {
    if (before <= refinement.floor || now <= refinement.floor) return std::nullopt;
    return std::log2(before / now);
}

bool add_rows(const Benchmark& benchmark, const Refinement& refinement, std::vector<Row>& rows) {
    bool matches = true;
    double before = 0.0;
    for (std::size_t i = 0; i < refinement.rows.size(); ++i) {
        Row row{refinement.name,
                fmt::format("{}", fmt::join(refinement.rows[i], " ")),
                run_benchmark(benchmark, refinement.rows[i]),
                std::nullopt};
        if (i > 0) row.order = find_order(refinement, before, row.run.error);
        before = row.run.error;
        rows.push_back(row);
    }
    const Row& last = rows.back();
    if (refinement.tolerance > 0.0) matches = last.run.error <= refinement.tolerance;
    // The finest pair of rows above the floor shows the order.
    std::optional<double> order;
    for (std::size_t i = rows.size() - refinement.rows.size(); i < rows.size(); ++i) {
        if (rows[i].order) order = rows[i].order;
    }
    if (refinement.order > 0.0 && order) matches = matches && *order >= refinement.order - order_tolerance;
    return matches;
}

nlohmann::ordered_json to_json(const Row& row) {
    return {{"refinement", row.refinement},
            {"set", row.overrides},
            {"unknowns", row.run.unknowns},
            {"steps", row.run.steps},
            {"newton_iterations", row.run.newton_iterations},
            {"seconds", row.run.seconds},
            {"error", row.run.error},
            {"order", row.order ? nlohmann::ordered_json(*row.order) : nlohmann::ordered_json()},
            {"energy_error", row.run.energy_error}};
}

}  // namespace

BenchmarkRun run_benchmark(const Benchmark& benchmark, const std::vector<std::string>& overrides) {
    DeckRun run(benchmark.name, benchmark.deck, overrides);
    BenchmarkRun result;
    std::vector<bool> found(benchmark.values.size(), false);
    run.run([&] {
        result.energy_error =
            std::max(result.energy_error, std::abs(run.analysis().ledger_row().energy_error));
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::optional<double> error = find_error(benchmark.values[i], run);
            if (!error) continue;
            result.error = std::max(result.error, *error);
            found[i] = true;
        }
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i]) continue;
        throw std::runtime_error(fmt::format(
            "{}: no step ends at t = {}, where a value is known", benchmark.name, benchmark.values[i].time));
    }
    result.unknowns = run.analysis().system().equations().count();
    result.steps = run.steps();
    result.newton_iterations = run.newton_iterations();
    result.seconds = run.seconds();
    return result;
}

StudyResult report_benchmark(const Benchmark& benchmark) {
    StudyResult result;
    result.json = nlohmann::ordered_json::array();
    std::vector<Row> rows;
    for (const Refinement& refinement : benchmark.refinements) {
        const bool matches = add_rows(benchmark, refinement, rows);
        if (!matches) rows.back().refinement += " MISSED";
        result.matches = result.matches && matches;
    }
    result.table = fmt::format(
        "{:>9}{:>7}{:>8}{:>11}{:>7}  {}\n", "unknowns", "steps", "Newton", "error", "order", "refinement");
    for (const Row& row : rows) {
        result.json.push_back(to_json(row));
        result.table += fmt::format("{:>9}{:>7}{:>8}{:>11.2e}{:>7}  {}: {}\n",
                                    row.run.unknowns,
                                    row.run.steps,
                                    row.run.newton_iterations,
                                    row.run.error,
                                    row.order ? fmt::format("{:.2f}", *row.order) : "-",
                                    row.refinement,
                                    row.overrides);
    }
    return result;
}

const std::vector<Benchmark>& benchmarks() {
    static const std::vector<Benchmark> all = [] {
        std::vector<Benchmark> read;
        for (const ExampleText& example : example_texts()) {
            read.push_back(read_benchmark(example.name, example.deck, example.reference));
        }
        return read;
    }();
    return all;
}

}  // namespace gxrod
