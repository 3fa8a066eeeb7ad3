#include "verification/benchmark.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "analyses/static.hpp"
#include "deck/choices.hpp"
#include "deck/problem.hpp"
#include "results/history_point.hpp"
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

class BenchmarkRunner {
  public:
    BenchmarkRunner(const Benchmark& benchmark, const std::vector<std::string>& overrides)
        : benchmark_(benchmark),
          problem_(read_problem_text(benchmark.deck, benchmark.name + ".toml", overrides)),
          analysis_(make_analysis(problem_.model, problem_.analysis)),
          found_(benchmark.values.size(), false) {}

    BenchmarkRun run() {
        const auto start = std::chrono::steady_clock::now();
        check(analysis_->start());
        compare();
        while (!analysis_->finished()) {
            check(analysis_->advance());
            ++run_.steps;
            run_.newton_iterations += analysis_->solver_row().newton_iterations;
            compare();
        }
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (found_[i]) continue;
            const BenchmarkValue& value = benchmark_.values[i];
            throw std::runtime_error(fmt::format(
                "{}: no step ends at t = {}, where {} is known", benchmark_.name, value.time, value.source));
        }
        run_.unknowns = analysis_->system().equations().count();
        run_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return run_;
    }

  private:
    void check(const EquilibriumReport& report) const {
        if (report.converged()) return;
        throw std::runtime_error(fmt::format("{}: step from t = {}: {}",
                                             benchmark_.name,
                                             analysis_->state().time,
                                             describe(report, problem_.model)));
    }

    double end_time() const {
        const auto* dynamic = std::get_if<DynamicSettings>(&problem_.analysis);
        return dynamic == nullptr ? 1.0 : dynamic->end_time;
    }

    void compare() {
        const LedgerRow ledger = analysis_->ledger_row();
        run_.energy_error = std::max(run_.energy_error, std::abs(ledger.energy_error));
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const BenchmarkValue& value = benchmark_.values[i];
            if (std::abs(analysis_->state().time - value.time) > same_time * end_time()) continue;
            const double error = value.source == "ledger"
                                     ? distance(value.reference, ledger_value(value.quantity, ledger).data())
                                     : distance(value.reference, history_value(value).data());
            run_.error = std::max(run_.error, error / value.scale);
            found_[i] = true;
        }
    }

    HistoryPoint::Row history_value(const BenchmarkValue& value) {
        for (const HistoryRequest& request : problem_.output.histories) {
            if (request.name != value.source) continue;
            for (const Choice<Quantity>& choice : quantity_choices) {
                if (choice.word != value.quantity) continue;
                return HistoryPoint(problem_.model, request).compute(choice.value, analysis_->snapshot());
            }
        }
        throw std::runtime_error(
            fmt::format("{}: no {} of a history {}", benchmark_.name, value.quantity, value.source));
    }

    const Benchmark& benchmark_;
    Problem problem_;
    std::unique_ptr<SteppedAnalysis> analysis_;
    BenchmarkRun run_;
    std::vector<bool> found_;
};

struct Row {
    std::string refinement;
    std::string overrides;
    BenchmarkRun run;
    double order = 0.0;  // 0 for the first of a refinement
};

// log₂ of the fall of the error; refinements double elements or steps from row to row.
double find_order(const Refinement& refinement, double before, double now) {
    if (before <= refinement.floor || now <= refinement.floor) return 0.0;
    return std::log2(before / now);
}

bool add_rows(const Benchmark& benchmark, const Refinement& refinement, std::vector<Row>& rows) {
    bool matches = true;
    double before = 0.0;
    for (std::size_t i = 0; i < refinement.rows.size(); ++i) {
        Row row{refinement.name,
                fmt::format("{}", fmt::join(refinement.rows[i], " ")),
                run_benchmark(benchmark, refinement.rows[i]),
                0.0};
        if (i > 0) row.order = find_order(refinement, before, row.run.error);
        before = row.run.error;
        rows.push_back(row);
    }
    const Row& last = rows.back();
    if (refinement.tolerance > 0.0) matches = last.run.error <= refinement.tolerance;
    // The finest pair of rows above the floor shows the order.
    double order = 0.0;
    for (std::size_t i = rows.size() - refinement.rows.size(); i < rows.size(); ++i) {
        if (rows[i].order != 0.0) order = rows[i].order;
    }
    if (refinement.order > 0.0 && order != 0.0)
        matches = matches && order >= refinement.order - order_tolerance;
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
            {"order", row.order != 0.0 ? nlohmann::ordered_json(row.order) : nlohmann::ordered_json()},
            {"energy_error", row.run.energy_error}};
}

}  // namespace

BenchmarkRun run_benchmark(const Benchmark& benchmark, const std::vector<std::string>& overrides) {
    return BenchmarkRunner(benchmark, overrides).run();
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
                                    row.order != 0.0 ? fmt::format("{:.2f}", row.order) : "-",
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
