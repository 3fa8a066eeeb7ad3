#include "analyses/shapes/eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "analyses/shapes/mode_name.hpp"
#include "analyses/shapes/shape_measures.hpp"
#include "analyses/shapes/shape_words.hpp"
#include "assembly/small_motions.hpp"
#include "assembly/system_values.hpp"
#include "linear/eigen/pencil.hpp"
#include "linear/eigen/quadratic_pairs.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double cycle = 2.0 * std::numbers::pi;
// Of |λ|: a growth that is round-off. Of the shift: so small is λ of rigid motions.
constexpr double round_off = 1e-8, rigid = 1e-3;

class EigenvalueFinder {
  public:
    EigenvalueFinder(const System& system,
                     const State& state,
                     double time,
                     const EigenvalueSettings& settings,
                     const StateMatrices& matrices)
        : system_(system),
          state_(state),
          settings_(settings),
          problem_(matrices.problem_on(system.pattern())) {
        record_.time = time;
    }

    EigenvaluesRecord find() {
        const QuadraticSettings search{.wanted = settings_.count,
                                       .counts = settings_.counts,
                                       .left = settings_.left,
                                       .first_steps = settings_.first_steps};
        const auto found = find_nearest_pairs(problem_, search, system_.team());
        if (!found) {
            record_.failure = "nothing that moves has inertia";
            return record_;
        }
        if (found->values.size() == 0) record_.failure = "no eigenvalue converged";
        pairs_ = *found;
        record_.shift = pairs_.shift;
        record_.radius = pairs_.radius;
        record_.missing = pairs_.missing;
        record_.is_complete = pairs_.missing == 0;
        record_.is_all = pairs_.is_all;
        record_.steps = pairs_.steps;
        double slowest_held = std::numeric_limits<double>::infinity(), fastest = 0.0;
        for (const Index i : order_modes()) {
            const double size = std::abs(pairs_.values[i]);
            if (measure_gap_share(system_, problem_.K, pairs_.vectors.col(i)) > 0.5) {
                slowest_held = std::min(slowest_held, size);
            } else {
                fastest = std::max(fastest, size);
                add_mode(i);
            }
        }
        if (std::isfinite(slowest_held) && fastest < slowest_held) record_.is_all = true;
        if (record_.failure.empty() && record_.modes.empty())
            record_.failure = "joints and supports hold all that has inertia";
        return record_;
    }

  private:
    std::vector<Index> order_modes() const {
        std::vector<Index> order(static_cast<std::size_t>(pairs_.values.size()));
        std::iota(order.begin(), order.end(), Index{0});
        std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
            const Complex first = pairs_.values[a], second = pairs_.values[b];
            if (first.imag() != second.imag()) return first.imag() < second.imag();
            return first.real() > second.real();
        });
        return order;
    }

    Eigen::VectorXcd multiply_complex(const std::vector<double>& values, const Eigen::VectorXcd& x) const {
        Eigen::VectorXcd product(x.size());
        Eigen::VectorXd part;
        multiply(*problem_.pattern, values, x.real(), part);
        product.real() = part;
        multiply(*problem_.pattern, values, x.imag(), part);
        product.imag() = part;
        return product;
    }

    std::vector<Vec6> list_nodes(const Eigen::VectorXd& solution) const {
        std::vector<Vec6> nodes(state_.trial.size());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            nodes[i] = system_.equations().increment_of(static_cast<int>(i), solution);
        return nodes;
    }

    // Of the largest displacement, or rotation if nothing is displaced; the first of several that are as
    // large.
    Complex find_largest(const Eigen::VectorXcd& x) const {
        const std::vector<Vec6> real = list_nodes(x.real()), imaginary = list_nodes(x.imag());
        Complex displacement = 0.0, rotation = 0.0;
        const auto raise = [](Complex& largest, Complex component) {
            if (std::abs(component) > (1.0 + 1e-6) * std::abs(largest)) largest = component;
        };
        for (std::size_t i = 0; i < real.size(); ++i) {
            for (int k = 0; k < 6; ++k)
                raise(k < 3 ? displacement : rotation, Complex(real[i][k], imaginary[i][k]));
        }
        const double length = system_.length_scale();
        return std::abs(displacement) > 1e-9 * length * std::abs(rotation) ? displacement : rotation;
    }

    void add_mode(Index i) {
        const Complex lambda = pairs_.values[i];
        Eigen::VectorXcd x = pairs_.vectors.col(i);
        const Complex largest = find_largest(x);
        if (largest != 0.0) x *= std::conj(largest) / std::abs(largest);
        const double mass = x.dot(multiply_complex(problem_.M, x)).real();
        if (mass > 0.0) x /= std::sqrt(mass);
        Eigenmode mode;
        mode.growth = lambda.real();
        mode.omega = lambda.imag();
        mode.frequency = mode.omega / cycle;
        const double size = std::abs(lambda);
        if (size > 0.0) mode.damping_ratio = -lambda.real() / size;
        mode.residual = pairs_.residuals[i];
        mode.shape.nodes = list_nodes(x.real());
        mode.imaginary = list_nodes(x.imag());
        add_energy(mode);
        if (lambda.real() > std::max(round_off * size, rigid * pairs_.shift)) ++record_.unstable;
        if (settings_.left) take_left_vector(pairs_.left.col(i), x, mode);
        record_.modes.push_back(std::move(mode));
    }

    // Mean over a cycle.
    void add_energy(Eigenmode& mode) const {
        std::vector<Vec6>& shares = mode.shape.energy_shares;
        shares = SystemValues(system_).compute_strain_work(state_, mode.shape.nodes);
        const std::vector<Vec6> imaginary = SystemValues(system_).compute_strain_work(state_, mode.imaginary);
        double energy = 0.0;
        for (std::size_t rod = 0; rod < shares.size(); ++rod) {
            shares[rod] += imaginary[rod];
            energy += shares[rod].sum();
        }
        for (Vec6& share : shares) {
            if (energy > 0.0) share /= energy;
        }
        mode.shape.words = describe_shape(system_, state_, mode.shape);
        mode.shape.words = name_mode(system_, state_, mode.shape, &mode.imaginary);
    }

    void take_left_vector(Eigen::VectorXcd y, const Eigen::VectorXcd& x, Eigenmode& mode) const {
        if (y.isZero(0.0)) return;
        Eigen::VectorXcd change =
            2.0 * mode.lambda() * multiply_complex(problem_.M, x) + multiply_complex(problem_.D, x);
        for (const RelaxingMatrix& one : problem_.relaxing)
            change += one.slope(mode.lambda(), mode.lambda()) * multiply_complex(one.values, x);
        const Complex product = (y.transpose() * change)(0);
        if (std::abs(product) > 1e-12 * y.norm() * change.norm()) y /= product;
        mode.left = list_nodes(y.real());
        mode.left_imaginary = list_nodes(y.imag());
    }

    const System& system_;
    const State& state_;
    const EigenvalueSettings& settings_;
    QuadraticProblem problem_;
    QuadraticPairs pairs_;
    EigenvaluesRecord record_;
};

}  // namespace

EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const StateMatrices& matrices) {
    const SmallMotions small(system);
    return EigenvalueFinder(small.system(), state, time, settings, matrices).find();
}

EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const FrameColumns* frame) {
    const StateMatrices matrices =
        frame ? frame->compute_matrices(state, time) : compute_state_matrices(system, state, time);
    return find_eigenvalues(system, state, time, settings, matrices);
}

}  // namespace gxrod
