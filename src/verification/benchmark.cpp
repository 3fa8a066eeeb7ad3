#include "verification/benchmark.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "check/findings/found_values.hpp"
#include "study/deck_run.hpp"
#include "verification/example_texts.hpp"

namespace gxrod {

namespace {

constexpr double same_time = 1e-9;  // relative to the end of the run

double distance(const std::vector<double>& reference, const std::vector<double>& values) {
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
    if (quantity == "dissipated_energy") return {row.dissipated_energy, 0.0, 0.0};
    if (quantity == "contact_loss") return {row.contact_loss, 0.0, 0.0};
    if (quantity == "external_work") return {row.external_work, 0.0, 0.0};
    if (quantity == "energy_less_work") {
        return {row.kinetic_energy + row.strain_energy - row.external_work, 0.0, 0.0};
    }
    throw std::runtime_error("the ledger has no " + quantity);
}

// What the stage has found.
std::vector<double> list_found(const BenchmarkValue& value, const DeckRun& run) {
    for (const FoundShapes& shapes : run.shapes()) {
        if (shapes.stage != value.source) continue;
        const auto* sweep = std::get_if<SweepRecord>(&shapes.record);
        return sweep != nullptr && value.at ? list_values_at(*sweep, value.quantity, *value.at)
                                            : list_found_values(shapes.record, value.quantity);
    }
    for (const PathRecord& record : run.paths()) {
        if (record.front().name == value.source) return list_found_values(record, value.quantity);
    }
    return {};
}

FoundValue find_shape_value(const BenchmarkValue& value, const DeckRun& run) {
    FoundValue found{list_found(value, run)};
    if (found.value.size() < value.reference.size()) {
        throw std::runtime_error(fmt::format(
            "no {} values {} of a stage {}", value.reference.size(), value.quantity, value.source));
    }
    found.value.resize(value.reference.size());
    for (std::size_t i = 0; i < value.reference.size(); ++i) {
        if (std::isnan(value.reference[i])) continue;
        found.error = std::fmax(found.error, std::abs(found.value[i] / value.reference[i] - 1.0));
    }
    return found;
}

bool is_there(const PlaceOnPath& place, DeckRun& run) {
    constexpr double same_place = 1e-9;
    if (place.history.empty()) {
        return (place.stage.empty() || place.stage == run.stage()) &&
               std::abs(run.analysis().state().time - place.is) <=
                   same_place * std::max(1.0, std::abs(place.is));
    }
    const HistoryRow row = run.value(place.history, "displacement");
    const double value = row.at(static_cast<std::size_t>(place.component));
    return std::abs(value - place.is) <= same_place * std::max(1.0, std::abs(place.is));
}

bool is_due(const BenchmarkValue& value, DeckRun& run) {
    if (value.is_of_shapes) return false;
    if (value.where) return is_there(*value.where, run);
    return value.is_constant || std::abs(run.time() - value.time) <= same_time * run.end_time();
}

FoundValue find_value(const BenchmarkValue& value, DeckRun& run) {
    FoundValue found;
    if (value.source == "ledger") {
        const Vec3 row = ledger_value(value.quantity, run.analysis().ledger_row());
        found.value.assign(row.begin(), row.end());
    } else if (value.quantity == "load_factor") {
        found.value = {run.analysis().state().time};
    } else if (value.quantity == "limit_load_factor") {
        found.value = {run.limit_load_factor()};
    } else {
        const HistoryRow row = run.value(value.source, value.quantity);
        found.value.assign(row.begin(), row.end());
    }
    found.value.resize(value.reference.size());
    found.error = distance(value.reference, found.value) / value.scale;
    // Of a quaternion, both signs are the same rotation.
    if (value.reference.size() == 4) {
        std::vector<double> other = found.value;
        for (double& component : other) component = -component;
        const double error = distance(value.reference, other) / value.scale;
        if (error < found.error) found = {other, error};
    }
    return found;
}

}  // namespace

BenchmarkRun run_benchmark(const Benchmark& benchmark, const std::vector<std::string>& overrides) {
    DeckRun run(benchmark.name, benchmark.deck, overrides);
    BenchmarkRun result;
    result.values.resize(benchmark.values.size());
    std::vector<bool> found(benchmark.values.size(), false);
    run.run([&] {
        result.energy_error =
            std::max(result.energy_error, std::abs(run.analysis().ledger_row().energy_error));
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (!is_due(benchmark.values[i], run)) continue;
            FoundValue now = find_value(benchmark.values[i], run);
            // Of several equilibria of a path the nearest counts, of all steps the worst.
            const bool is_nearer = now.error < result.values[i].error;
            if (!found[i] || is_nearer == benchmark.values[i].where.has_value())
                result.values[i] = std::move(now);
            found[i] = true;
        }
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i]) continue;
        if (benchmark.values[i].is_of_shapes) {
            result.values[i] = find_shape_value(benchmark.values[i], run);
            continue;
        }
        if (benchmark.values[i].where) {
            throw std::runtime_error(fmt::format(
                "{}: the path has no equilibrium where {} is {}",
                benchmark.name,
                benchmark.values[i].where->history.empty() ? "t" : benchmark.values[i].where->history,
                benchmark.values[i].where->is));
        }
        throw std::runtime_error(fmt::format(
            "{}: no step ends at t = {}, where a value is known", benchmark.name, benchmark.values[i].time));
    }
    for (const FoundValue& value : result.values) result.error = std::fmax(result.error, value.error);
    result.unknowns = run.analysis().system().equations().count();
    result.steps = run.steps();
    result.newton_iterations = run.newton_iterations();
    result.seconds = run.seconds();
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
