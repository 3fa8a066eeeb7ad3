#include "verification/rod_schemes_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rotation/types.hpp"
#include "study/deck_run.hpp"
#include "verification/example_texts.hpp"

namespace gxrod::rod_schemes {

namespace {

// A deck on one mesh, so that all errors are those of time. Errors are taken at the end of the run from
// radau-5 with `reference_steps`.
struct Case {
    std::string name;
    std::string example;
    std::vector<std::string> overrides;
    std::vector<std::string> points;  // histories with position and orientation
    std::vector<long> steps;
    long reference_steps;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"free flight",
         "free_flight_smooth",
         {"rod.flyer.elements=8", "analysis.end_time=10"},
         {"loaded_end", "free_end"},
         {100, 200, 400, 800},
         1600},
        {"free flight, 100 times stiffer",
         "free_flight_smooth",
         {"rod.flyer.elements=8", "analysis.end_time=10", "parameters.stiffer=100"},
         {"loaded_end", "free_end"},
         {100, 200, 400, 800},
         3200},
        {"right angle",
         "right_angle",
         {"rod.leg.elements=4", "rod.beam.elements=4", "analysis.end_time=10"},
         {"elbow", "tip"},
         {100, 200, 400, 800},
         1600},
        {"rubber pendulum", "rubber_pendulum", {"rod.rod.elements=8"}, {"tip"}, {100, 200, 400, 800}, 3200}};
    return all;
}

const std::vector<std::string>& schemes() {
    static const std::vector<std::string> all{
        "newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5", "gauss-4"};
    return all;
}

struct SchemeRun {
    std::vector<Vec3> positions;
    std::vector<Quat> orientations;
    double energy_error = 0.0;  // the largest imbalance of the ledger, by the largest energy
    Vec3 linear_momentum;
    Vec3 angular_momentum;
    double length = 1.0;
    long newton_iterations = 0;
    double seconds = 0.0;
    bool failed = false;
};

const std::string& find_deck(const std::string& name) {
    for (const ExampleText& example : example_texts()) {
        if (example.name == name) return example.deck;
    }
    throw std::runtime_error("no example " + name);
}

SchemeRun run_case(const Case& it, const std::string& scheme, long steps) {
    std::vector<std::string> overrides = it.overrides;
    overrides.push_back("analysis.integrator=" + scheme);
    const double end_time = DeckRun(it.example, find_deck(it.example), overrides).end_time();
    overrides.push_back(fmt::format("analysis.time_step={:.17g}", end_time / static_cast<double>(steps)));
    DeckRun run(it.example, find_deck(it.example), overrides);
    SchemeRun outcome;
    outcome.length = run.analysis().system().length_scale();
    double largest_energy = 0.0;
    try {
        run.run([&] {
            const LedgerRow row = run.analysis().ledger_row();
            outcome.energy_error = std::max(outcome.energy_error, std::abs(row.energy_error));
            largest_energy = std::max(largest_energy, row.kinetic_energy + row.strain_energy);
        });
    } catch (const std::runtime_error&) {
        outcome.failed = true;
        return outcome;
    }
    outcome.energy_error /= largest_energy;
    for (const std::string& point : it.points) {
        const HistoryRow r = run.value(point, "position");
        const HistoryRow q = run.value(point, "orientation");
        outcome.positions.emplace_back(r[0], r[1], r[2]);
        outcome.orientations.emplace_back(q[0], q[1], q[2], q[3]);
    }
    const LedgerRow row = run.analysis().ledger_row();
    outcome.linear_momentum = row.linear_momentum;
    outcome.angular_momentum = row.angular_momentum;
    outcome.newton_iterations = run.newton_iterations();
    outcome.seconds = run.seconds();
    return outcome;
}

struct SchemeRow {
    std::string name;
    std::string scheme;
    long steps;
    SchemeRun outcome;
    double position = 0.0;     // by the model's length
    double orientation = 0.0;  // rad
    double momentum = 0.0;     // angular, by its own size
    double order = 0.0;        // of the orientation
};

SchemeRow compare(const Case& it, const std::string& scheme, long steps, const SchemeRun& reference) {
    SchemeRow row{it.name, scheme, steps, run_case(it, scheme, steps)};
    if (row.outcome.failed) return row;
    for (std::size_t i = 0; i < reference.positions.size(); ++i) {
        row.position = std::max(
            row.position, (row.outcome.positions[i] - reference.positions[i]).norm() / row.outcome.length);
        row.orientation =
            std::max(row.orientation, row.outcome.orientations[i].angularDistance(reference.orientations[i]));
    }
    row.momentum = (row.outcome.angular_momentum - reference.angular_momentum).norm() /
                   reference.angular_momentum.norm();
    return row;
}

std::vector<SchemeRow> compute_rows() {
    std::vector<SchemeRow> rows;
    for (const Case& it : cases()) {
        const SchemeRun reference = run_case(it, "radau-5", it.reference_steps);
        if (reference.failed)
            throw std::runtime_error("rod_schemes: the reference of " + it.name + " failed");
        for (const std::string& scheme : schemes()) {
            double before = 0.0;
            for (const long steps : it.steps) {
                SchemeRow row = compare(it, scheme, steps, reference);
                if (before > 0.0 && row.orientation > 0.0) row.order = std::log2(before / row.orientation);
                before = row.orientation;
                rows.push_back(row);
            }
        }
    }
    return rows;
}

std::string to_line(const SchemeRow& row) {
    if (row.outcome.failed) {
        return fmt::format("{:<32}{:<24}{:>6}  did not converge\n", row.name, row.scheme, row.steps);
    }
    return fmt::format("{:<32}{:<24}{:>6}{:>11.2e}{:>11.2e}{:>7}{:>11.2e}{:>11.2e}{:>8}{:>8.3f}\n",
                       row.name,
                       row.scheme,
                       row.steps,
                       row.position,
                       row.orientation,
                       row.order != 0.0 ? fmt::format("{:.2f}", row.order) : "-",
                       row.outcome.energy_error,
                       row.momentum,
                       row.outcome.newton_iterations,
                       row.outcome.seconds);
}

// The schemes' orders show on the finest pair of the first case, whose error is all of smooth time.
std::vector<Check> check_orders(const std::vector<SchemeRow>& rows) {
    std::vector<Check> checks;
    for (const SchemeRow& row : rows) {
        if (row.name != cases().front().name || row.steps != cases().front().steps.back()) continue;
        const bool is_fourth = row.scheme == "sdirk-4" || row.scheme == "gauss-4";
        const double order = row.scheme == "radau-5" ? 5.0 : is_fourth ? 4.0 : 2.0;
        checks.push_back(
            make_order_check(row.name + ", " + row.scheme, order, row.order, order > 2.0 ? 0.5 : 0.2));
    }
    return checks;
}

}  // namespace

StudyResult report(const StudyOptions&) {
    const std::vector<SchemeRow> rows = compute_rows();
    StudyResult result;
    result.checks = check_orders(rows);
    result.json = nlohmann::ordered_json::array();
    result.table = fmt::format("{:<32}{:<24}{:>6}{:>11}{:>11}{:>7}{:>11}{:>11}{:>8}{:>8}\n",
                               "case",
                               "scheme",
                               "steps",
                               "position",
                               "rotation",
                               "order",
                               "energy",
                               "momentum",
                               "Newton",
                               "s");
    for (const SchemeRow& row : rows) {
        result.table += to_line(row);
        result.json.push_back({{"case", row.name},
                               {"scheme", row.scheme},
                               {"steps", row.steps},
                               {"converged", !row.outcome.failed},
                               {"position_error", row.position},
                               {"rotation_error", row.orientation},
                               {"energy_error", row.outcome.energy_error},
                               {"momentum_error", row.momentum},
                               {"newton_iterations", row.outcome.newton_iterations},
                               {"seconds", row.outcome.seconds}});
    }
    result.table +=
        "position: by the model's length; rotation: rad; both at the end, from radau-5 with many more "
        "steps on the same mesh.\nenergy: largest imbalance by the largest energy; momentum: angular, "
        "relative, at the end.\n";
    return result;
}

}  // namespace gxrod::rod_schemes
