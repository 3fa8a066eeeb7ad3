#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/rubin2007_problem.hpp"

namespace gxrod::rubin2007 {

// The Newmark schemes (S) and (I) of Rubin (2007), (4.7) and (4.3); the classical Runge-Kutta scheme on the
// nine entries of Λ, (6.20); beyond the paper sdirk-4, radau-5, gauss-4, and the deck's runge-kutta-4 on unit
// quaternions.
enum class StudyScheme {
    newmark_simplified,
    newmark_ibrahimbegovic,
    matrix_rk4,
    sdirk_4,
    radau_5,
    gauss_4,
    quaternion_rk4
};
// Returns "S", "I", "RK4", "SDIRK4", "RADAU5", "GAUSS4" or "RK4Q".
std::string name_of(StudyScheme scheme);

// Results of a scheme over the whole cycle in a number of steps: maxima over the ends of the steps.
struct Row {
    StudyScheme scheme;
    long steps;
    bool diverged = false;                // if true, the rest is empty
    std::optional<double> max_theta_deg;  // rotation within a step; not for RK4
    std::optional<Errors> errors;
    std::optional<double> iterations_per_step;  // linear solves; implicit schemes
};

// The state at the end of one step from which errors are computed.
struct Sample {
    double time;
    Errors errors;
};
struct Trace {
    Row row;
    std::vector<Sample> samples;  // t = 0 and the end of each step
};

// Runs a scheme, with Newton's method to a residual of 1e-12 H₀.
Trace run_scheme(StudyScheme scheme, long steps);

// The results of an independent program at N steps. They must agree to 5 significant digits, or to the digits
// that the reference has or that the residual of Newton's method leaves in such small errors.
struct Reference {
    StudyScheme scheme;
    long steps;
    bool diverges;
    std::optional<double> max_theta_deg;
    Errors errors;  // a momentum error of 0 means that neither it nor the energy error was computed
    int momentum_digits = 5;
    int orientation_digits = 5;
};
const std::vector<Reference>& references();

// Computes half a unit of the last significant digit.
double half_unit(double reference, int digits);

struct Comparison {
    const Reference* reference = nullptr;  // null without one
    bool matches = true;
};
Comparison compare(const Row& row);

// Runs every scheme with every N.
std::vector<Row> run_study(const std::vector<long>& steps);

// Writes the data of Figs. 2, 3 and 4 as fig2.csv, fig3.csv (at figure_steps) and fig4.csv. Throws FileError.
void write_figure_data(const std::filesystem::path& folder, const std::vector<Row>& rows);
inline constexpr long figure_steps = 400;

}  // namespace gxrod::rubin2007
