#include "check/mesh_frequencies.hpp"

#include <Spectra/SymGEigsShiftSolver.h>
#include <Spectra/SymGEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "assembly/system.hpp"
#include "check/unsupported_motions.hpp"
#include "integrators/load_stepping.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

namespace {

// More unknowns are not examined: it would take longer than a user waits for a check.
constexpr std::int64_t most_unknowns = 100'000;

// A step's part of a vibration, in rad, that a scheme of order 4 follows.
constexpr double resolved = 2.0;

// Beyond so many the search for the lowest frequency, which passes them all, takes too long.
constexpr int most_rigid_motions = 60;

using Vector = Eigen::VectorXd;
using VectorMap = Eigen::Map<Vector>;
using ConstVectorMap = Eigen::Map<const Vector>;

// A sparse matrix and its factors, as Spectra asks for operations.
class Operation {
  public:
    using Scalar = double;

    Operation(const SparsePattern& pattern, std::vector<double> values)
        : pattern_(&pattern), values_(std::move(values)), solver_(make_general_solver(pattern)) {}

    // False if it is singular.
    bool factorize() { return solver_->factorize(values_).regular; }
    bool factorize_sum(double factor, const Operation& other) {
        std::vector<double> sum = values_;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * other.values_[i];
        return solver_->factorize(sum).regular;
    }

    Eigen::Index rows() const { return pattern_->size(); }
    Eigen::Index cols() const { return pattern_->size(); }
    void perform_op(const double* in, double* out) const {
        VectorMap(out, rows()).setZero();
        pattern_->visit_entries(
            [&](std::int64_t i, std::int64_t j, std::int64_t slot) { out[i] += values_[slot] * in[j]; });
    }
    void solve(const double* in, double* out) const {
        Vector x = ConstVectorMap(in, rows());
        solver_->solve(x);
        VectorMap(out, rows()) = x;
    }

  private:
    const SparsePattern* pattern_;
    std::vector<double> values_;
    std::unique_ptr<LinearSolver> solver_;
};

// (K − σM)⁻¹, with σ chosen beforehand.
class Inverse {
  public:
    using Scalar = double;

    explicit Inverse(const Operation& factors) : factors_(&factors) {}
    Eigen::Index rows() const { return factors_->rows(); }
    Eigen::Index cols() const { return factors_->cols(); }
    void set_shift(double) {}
    void perform_op(const double* in, double* out) const { factors_->solve(in, out); }

  private:
    const Operation* factors_;
};

constexpr double tolerance = 1e-7;  // of eigenvalues
constexpr int most_restarts = 300;

int subspace(Eigen::Index size, int wanted) {
    return static_cast<int>(std::min<Eigen::Index>(size, std::max(20, 3 * wanted)));
}

// The largest λ of K x = λ M x, M factorized.
std::optional<double> find_largest(Operation& K, Operation& M) {
    using Solver = Spectra::SymGEigsSolver<Operation, Operation, Spectra::GEigsMode::RegularInverse>;
    Solver solver(K, M, 1, subspace(K.rows(), 1));
    solver.init();
    if (solver.compute(Spectra::SortRule::LargestAlge, most_restarts, tolerance) < 1) return std::nullopt;
    return solver.eigenvalues()[0];
}

// Some λ nearest to σ; of a multiple one perhaps a single copy. Empty if they are not found.
Vector find_near(double sigma, Operation& K, Operation& M, int wanted) {
    if (!K.factorize_sum(-sigma, M)) return {};
    Inverse inverse(K);
    Spectra::SymGEigsShiftSolver<Inverse, Operation, Spectra::GEigsMode::ShiftInvert> solver(
        inverse, M, wanted, subspace(K.rows(), wanted), sigma);
    solver.init();
    if (solver.compute(Spectra::SortRule::LargestMagn, most_restarts, tolerance) < wanted) return {};
    return solver.eigenvalues();
}

// The smallest λ but `rigid` ones that vanish. `largest` is the largest.
std::optional<double> find_smallest(Operation& K, Operation& M, int rigid, double largest) {
    const int wanted = rigid + 1;
    if (rigid > most_rigid_motions || wanted >= K.rows()) return std::nullopt;
    // Near enough to the smallest, far enough from zero for K − σM to have an inverse.
    const Vector first = find_near(rigid == 0 ? 0.0 : -1e-12 * largest, K, M, wanted);
    if (first.size() == 0) return std::nullopt;
    const double guess = first.maxCoeff();
    if (rigid == 0 || guess <= 0.0) return guess;
    // So near to the rigid motions these drown the vibration in round-off; from its own distance it is as
    // large as they are.
    const Vector second = find_near(-guess, K, M, wanted);
    if (second.size() == 0) return guess;
    Eigen::Index nearest = 0;
    (second.array() - guess).abs().minCoeff(&nearest);
    return second[nearest];
}

int count_rigid_motions(const Model& model) {
    std::size_t count = 0;
    for (const ModelPart& part : find_parts(model)) {
        count += find_unsupported_motions(model, part).size();
    }
    return static_cast<int>(count);
}

// Without loads, and at rest.
Model make_bare(Model model) {
    model.loads.clear();
    model.distributed_loads.clear();
    model.gravity = TimeVector(Vec3::Zero());
    for (Node& node : model.nodes) {
        node.velocity.setZero();
        node.angular_velocity.setZero();
    }
    return model;
}

// The largest ωΔt at which runge-kutta-4 damps a vibration of frequency ω and damping ratio zeta: where its
// |1 + z + z²/2 + z³/6 + z⁴/24| reaches 1 on the ray z = λΔt.
double find_explicit_limit(double zeta) {
    using Complex = std::complex<double>;
    // The faster of two real rates, in units of ω, or the angle of two complex ones.
    const Complex direction = zeta < 1.0 ? Complex(-zeta, std::sqrt(1.0 - zeta * zeta))
                                         : Complex(-zeta - std::sqrt(zeta * zeta - 1.0), 0.0);
    const auto grows = [&](double length) {
        const Complex z = length * direction;
        const Complex growth = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
        return std::abs(growth) > 1.0 + 1e-12;
    };
    double stable = 1.0 / std::abs(direction);
    double unstable = 4.0 / std::abs(direction);
    while (unstable - stable > 1e-6 * stable) {
        const double middle = 0.5 * (stable + unstable);
        (grows(middle) ? unstable : stable) = middle;
    }
    return stable;
}

// Of a section: ζ = ½(τω + α/ω).
double compute_damping_ratio(const Section& section, double omega) {
    return 0.5 * (section.kelvin_voigt * omega + section.mass_proportional / omega);
}

}  // namespace

std::optional<MeshFrequencies> find_mesh_frequencies(const Model& model) {
    const Model bare = make_bare(model);
    const System system(bare);
    const std::int64_t size = system.pattern().size();
    if (size < 2) return std::nullopt;
    const State state = system.initial_state();
    std::vector<double> values;
    system.compute_tangent(state, 0.0, mass_linearizations(state.trial.size()), values);
    Operation M(system.pattern(), values);
    if (!M.factorize()) return std::nullopt;
    std::vector<NodeLinearization> linearizations(state.trial.size());
    LoadStepping().linearize(state, {}, linearizations);
    system.compute_tangent(state, 0.0, linearizations, values);
    Operation K(system.pattern(), values);
    const std::optional<double> largest = find_largest(K, M);
    if (!largest || !(*largest > 0.0)) return std::nullopt;
    const int rigid = count_rigid_motions(bare);
    const std::optional<double> smallest = find_smallest(K, M, rigid, *largest);
    if (!smallest || !(*smallest > 0.0)) return std::nullopt;
    return MeshFrequencies{std::sqrt(*smallest), std::sqrt(*largest), rigid};
}

std::string describe_frequencies(const Model& model, const DynamicSettings& settings) {
    constexpr double cycle = 2.0 * std::numbers::pi;
    if (model.rods.empty() || 6 * model.nodes.size() > most_unknowns) return "";
    const std::optional<MeshFrequencies> found = find_mesh_frequencies(model);
    if (!found) return "";
    std::string text =
        fmt::format("frequencies of the undeformed model, cycles per time: lowest {:.4g}{}, highest {:.4g}\n",
                    found->lowest / cycle,
                    found->rigid_motions == 0
                        ? ""
                        : fmt::format(" (in addition to {} of rigid motions)", found->rigid_motions),
                    found->highest / cycle);
    const double step = settings.time_step();
    if (settings.scheme == Scheme::sdirk_4 && step * found->highest > resolved) {
        text +=
            "  sdirk-4 with these steps does not resolve the highest ones: if they are excited, reactions "
            "and accelerations lose their order and energy may grow\n";
    }
    double largest_ratio = 0.0;
    for (const Section& section : model.sections) {
        largest_ratio = std::max(largest_ratio, compute_damping_ratio(section, found->highest));
        if (section.kelvin_voigt == 0.0 && section.mass_proportional == 0.0) continue;
        text +=
            fmt::format("  damping of section {}: {:.3g} of critical at the lowest, {:.3g} at the highest\n",
                        section.name,
                        compute_damping_ratio(section, found->lowest),
                        compute_damping_ratio(section, found->highest));
    }
    if (settings.scheme != Scheme::runge_kutta_4) return text;
    const double longest = find_explicit_limit(largest_ratio) / found->highest;
    text += fmt::format("  runge-kutta-4 is stable up to time steps of {:.3g}{}\n",
                        longest,
                        step > longest ? fmt::format(": this deck's, {:.3g}, will fail", step) : "");
    return text;
}

}  // namespace gxrod
