#include "verification/free_flight_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "analyses/dynamic.hpp"

namespace gxrod::free_flight {

namespace {

constexpr double order_tolerance = 0.25;

struct Row {
    std::string study;
    std::string scheme;
    int elements;
    long steps;
    double error;
    double order;  // 0 for the first of a series
    Flight flight;
};

nlohmann::ordered_json to_json(const Row& row) {
    return {{"study", row.study},
            {"scheme", row.scheme},
            {"elements", row.elements},
            {"steps", row.steps},
            {"error", row.error},
            {"order", row.order > 0.0 ? nlohmann::ordered_json(row.order) : nlohmann::ordered_json()},
            {"energy", row.flight.energy},
            {"iterations_per_step", row.flight.iterations_per_step}};
}

double largest_distance(const Flight& flight, const Flight& other) {
    return std::max({(flight.loaded_early - other.loaded_early).norm(),
                     (flight.free_early - other.free_early).norm(),
                     (flight.loaded - other.loaded).norm(),
                     (flight.free - other.free).norm()});
}

void add_row(std::vector<Row>& rows, Row row) {
    const bool continues = !rows.empty() && rows.back().study == row.study;
    row.order = continues ? std::log2(rows.back().error / row.error) : 0.0;
    rows.push_back(row);
}

std::vector<Row> refine_mesh_and_step() {
    std::vector<Row> rows;
    for (const Pulse pulse : {Pulse::triangular, Pulse::smooth}) {
        const std::string name = pulse == Pulse::triangular ? "triangular pulse" : "smooth pulse";
        for (const int elements : {10, 20, 40}) {
            const Flight flight = fly(pulse, Scheme::newmark_simplified, elements, 25L * elements);
            add_row(rows,
                    {name,
                     "newmark-simplified",
                     elements,
                     25L * elements,
                     compute_error(flight, reference(pulse)),
                     0.0,
                     flight});
        }
    }
    return rows;
}

std::vector<Row> refine_step() {
    constexpr int elements = 20;
    std::vector<Row> rows;
    Flight coarse = fly(Pulse::smooth, Scheme::sdirk_4, elements, 200);
    for (const long steps : {200L, 400L}) {
        const Flight fine = fly(Pulse::smooth, Scheme::sdirk_4, elements, 2 * steps);
        add_row(rows,
                {"step alone", "sdirk-4", elements, steps, largest_distance(coarse, fine), 0.0, coarse});
        coarse = fine;
    }
    return rows;
}

bool has_order(const std::vector<Row>& rows, double order) {
    return std::abs(rows.back().order - order) <= order_tolerance;
}

}  // namespace

Flight fly(Pulse pulse, Scheme scheme, int elements, long steps) {
    const Model model = make_model(pulse, elements);
    DynamicSettings settings;
    settings.end_time = 5.0;
    settings.steps = steps;
    settings.scheme = scheme;
    settings.newton.tolerance = 1e-10;
    DynamicAnalysis analysis(model, settings);
    EquilibriumReport equilibrium = analysis.start();
    Flight flight{};
    while (equilibrium.converged() && !analysis.finished()) {
        equilibrium = analysis.advance();
        flight.iterations_per_step += analysis.solver_row().newton_iterations / static_cast<double>(steps);
        const auto& nodes = analysis.state().trial;
        if (2 * analysis.steps().steps_done() == steps) {
            flight.loaded_early = nodes.front().r;
            flight.free_early = nodes.back().r;
        }
    }
    if (!equilibrium.converged()) throw std::runtime_error("free_flight: " + describe(equilibrium, model));
    const LedgerRow ledger = analysis.ledger_row();
    flight.loaded = analysis.state().trial.front().r;
    flight.free = analysis.state().trial.back().r;
    flight.energy = ledger.kinetic_energy + ledger.strain_energy;
    flight.energy_error = ledger.energy_error;
    flight.linear_momentum = ledger.linear_momentum;
    flight.angular_momentum = ledger.angular_momentum;
    return flight;
}

double compute_error(const Flight& flight, const Reference& reference) {
    return std::max({(flight.loaded_early - reference.loaded_early).norm(),
                     (flight.free_early - reference.free_early).norm(),
                     (flight.loaded - reference.loaded_late).norm(),
                     (flight.free - reference.free_late).norm()});
}

StudyResult report(const StudyOptions&) {
    std::vector<Row> rows = refine_mesh_and_step();
    const std::vector<Row> triangular(rows.begin(), rows.begin() + 3);
    StudyResult result;
    result.matches = has_order(triangular, 2.0) && has_order(rows, 2.0);
    const std::vector<Row> in_time = refine_step();
    result.matches = result.matches && has_order(in_time, 4.0);
    rows.insert(rows.end(), in_time.begin(), in_time.end());
    result.json = nlohmann::ordered_json::array();
    result.table = fmt::format("{:<18}{:<20}{:>9}{:>7}{:>12}{:>7}{:>12}{:>9}\n",
                               "study",
                               "scheme",
                               "elements",
                               "steps",
                               "error",
                               "order",
                               "energy",
                               "it/step");
    for (const Row& row : rows) {
        result.json.push_back(to_json(row));
        result.table += fmt::format("{:<18}{:<20}{:>9}{:>7}{:>12.3e}{:>7}{:>12.5f}{:>9.2f}\n",
                                    row.study,
                                    row.scheme,
                                    row.elements,
                                    row.steps,
                                    row.error,
                                    row.order > 0.0 ? fmt::format("{:.2f}", row.order) : "-",
                                    row.flight.energy,
                                    row.flight.iterations_per_step);
    }
    result.table += fmt::format(
        "error: largest distance of a tip from its reference at t = 2.5 and 5; of \"step alone\", from half "
        "the step.\n"
        "Orders asked: 2, 2 and 4 within {}.\n",
        order_tolerance);
    return result;
}

}  // namespace gxrod::free_flight
