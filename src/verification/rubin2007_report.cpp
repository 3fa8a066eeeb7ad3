#include "verification/rubin2007_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/rubin2007_study.hpp"

namespace gxrod::rubin2007 {

namespace {

nlohmann::ordered_json to_json(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

nlohmann::ordered_json to_json(const Row& row) {
    const auto error = [&](double Errors::*member) {
        return to_json(row.errors ? std::optional<double>((*row.errors).*member) : std::nullopt);
    };
    return {{"scheme", name_of(row.scheme)},
            {"steps", row.steps},
            {"max_theta_deg", to_json(row.max_theta_deg)},
            {"error_orientation", error(&Errors::orientation)},
            {"error_momentum", error(&Errors::momentum)},
            {"error_energy", error(&Errors::energy)},
            {"iterations_per_step", to_json(row.iterations_per_step)},
            {"diverged", row.diverged}};
}

std::string describe(const Comparison& comparison) {
    if (!comparison.reference) return "-";
    return comparison.matches ? "agrees" : "MISSED";
}

std::string to_line(const Row& row, const Comparison& comparison) {
    const std::string head = fmt::format("{:<7}{:>6}", name_of(row.scheme), row.steps);
    if (row.diverged) return fmt::format("{}  {:<61}{}\n", head, "diverges", describe(comparison));
    const auto optional = [](const std::optional<double>& value, const char* format) {
        return value ? fmt::format(fmt::runtime(format), *value) : std::string("-");
    };
    return fmt::format("{}{:>12}{:>14.6g}{:>14.6g}{:>14.6g}{:>9}  {}\n",
                       head,
                       optional(row.max_theta_deg, "{:.6g}"),
                       row.errors->orientation,
                       row.errors->momentum,
                       row.errors->energy,
                       optional(row.iterations_per_step, "{:.2f}"),
                       describe(comparison));
}

Check make_digits_check(const std::string& what, double value, double reference, int digits) {
    const double unit = half_unit(reference, digits);
    return {what, {reference}, unit, {value}, std::abs(value - reference), unit};
}

// What compare() looks at, number by number.
void add_checks(const Row& row, const Reference& reference, std::vector<Check>& checks) {
    const std::string run = fmt::format("{}, N = {}", name_of(row.scheme), row.steps);
    if (reference.diverges || row.diverged) {
        const auto number = [](bool diverged) { return diverged ? 1.0 : 0.0; };
        const double error = reference.diverges == row.diverged ? 0.0 : 1.0;
        checks.push_back(
            {run + " diverges", {number(reference.diverges)}, 0.0, {number(row.diverged)}, error, 0.5});
        return;
    }
    const Errors& known = reference.errors;
    checks.push_back(make_digits_check(
        "max E_Λ, " + run, row.errors->orientation, known.orientation, reference.orientation_digits));
    if (known.momentum > 0.0) {
        const int digits = reference.momentum_digits;
        checks.push_back(make_digits_check("max E_H, " + run, row.errors->momentum, known.momentum, digits));
        checks.push_back(make_digits_check("max E_T, " + run, row.errors->energy, known.energy, digits));
    }
    if (reference.max_theta_deg) {
        checks.push_back(
            make_digits_check("max |θ| in degrees, " + run, *row.max_theta_deg, *reference.max_theta_deg, 5));
    }
}

}  // namespace

StudyResult report(const StudyOptions& options) {
    const std::vector<long> steps =
        options.steps.empty() ? std::vector<long>{50, 100, 200, 400, 800, 1600} : options.steps;
    const std::vector<Row> rows = run_study(steps);
    StudyResult result;
    result.json = nlohmann::ordered_json::array();
    result.table = fmt::format("{:<7}{:>6}{:>12}{:>14}{:>14}{:>14}{:>9}  {}\n",
                               "scheme",
                               "N",
                               "max|θ| deg",
                               "max E_Λ ",
                               "max E_H",
                               "max E_T",
                               "it/step",
                               "reference");
    for (const Row& row : rows) {
        const Comparison comparison = compare(row);
        if (comparison.reference) add_checks(row, *comparison.reference, result.checks);
        result.table += to_line(row, comparison);
        // The paper's schemes and those of higher order; that of decks on unit quaternions is in the table
        // only.
        if (row.scheme != StudyScheme::quaternion_rk4) result.json.push_back(to_json(row));
    }
    result.table +=
        "S, I: Newmark schemes (4.7), (4.3). RK4: on the nine entries of Λ (6.20). SDIRK4, RADAU5, "
        "GAUSS4: sdirk-4, radau-5 and gauss-4 of decks.\n"
        "RK4Q: runge-kutta-4 of decks, on unit quaternions. Newton's method to 1e-12 H0.\n";
    if (!options.figures.empty()) write_figure_data(options.figures, rows);
    return result;
}

}  // namespace gxrod::rubin2007
