#include "analyses/eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "analyses/shape_measures.hpp"
#include "analyses/shape_words.hpp"
#include "linear/eigen/pencil.hpp"
#include "linear/eigen/quadratic_pairs.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double cycle = 2.0 * std::numbers::pi;
// Of |λ|: a growth that is round-off. Of the shift: so small is λ of rigid motions.
constexpr double round_off = 1e-8, rigid = 1e-3;
// Of values λ of a problem and of its transposed.
constexpr double same = 1e-6;

class EigenvalueFinder {
  public:
    EigenvalueFinder(const System& system,
                     const State& state,
                     double time,
                     const EigenvalueSettings& settings,
                     const FrameColumns* frame)
        : system_(system), state_(state), settings_(settings) {
        StateMatrices matrices =
            frame ? frame->compute_matrices(state, time) : compute_state_matrices(system, state, time);
        problem_ = {&system.pattern(),
                    std::move(matrices.stiffness),
                    std::move(matrices.damping),
                    std::move(matrices.mass)};
        record_.time = time;
    }

    EigenvaluesRecord find() {
        const QuadraticSettings search{.wanted = settings_.count, .counts = settings_.counts};
        const auto found = find_nearest_pairs(problem_, search, system_.team());
        if (!found) {
            record_.failure = "nothing that moves has inertia";
            return record_;
        }
        pairs_ = *found;
        record_.shift = pairs_.shift;
        record_.radius = pairs_.radius;
        record_.missing = pairs_.missing;
        record_.is_complete = pairs_.missing == 0;
        record_.is_all = pairs_.is_all;
        for (const Index i : order_modes()) add_mode(i);
        if (settings_.left) add_left_vectors();
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
        solutions_.push_back(x);
        record_.modes.push_back(std::move(mode));
    }

    // Mean over a cycle.
    void add_energy(Eigenmode& mode) const {
        std::vector<Vec6>& shares = mode.shape.energy_shares;
        shares = system_.compute_strain_work(state_, mode.shape.nodes);
        const std::vector<Vec6> imaginary = system_.compute_strain_work(state_, mode.imaginary);
        double energy = 0.0;
        for (std::size_t rod = 0; rod < shares.size(); ++rod) {
            shares[rod] += imaginary[rod];
            energy += shares[rod].sum();
        }
        for (Vec6& share : shares) {
            if (energy > 0.0) share /= energy;
        }
        mode.shape.words = describe_shape(system_, state_, mode.shape);
    }

    // Those of the transposed problem that have the same λ, each once.
    void add_left_vectors() {
        const QuadraticProblem transposed = problem_.transposed();
        const QuadraticSettings search{
            .wanted = static_cast<int>(record_.modes.size()), .counts = false, .follows_growth = false};
        const auto found = find_nearest_pairs(transposed, search, system_.team());
        if (!found) return;
        std::vector<char> is_taken(static_cast<std::size_t>(found->values.size()), 0);
        for (std::size_t i = 0; i < record_.modes.size(); ++i) {
            const Complex lambda = record_.modes[i].lambda();
            Index nearest = -1;
            for (Index j = 0; j < found->values.size(); ++j) {
                if (is_taken[static_cast<std::size_t>(j)] != 0) continue;
                if (nearest < 0 ||
                    std::abs(found->values[j] - lambda) < std::abs(found->values[nearest] - lambda))
                    nearest = j;
            }
            if (nearest < 0 ||
                std::abs(found->values[nearest] - lambda) > same * std::abs(lambda - found->shift))
                continue;
            is_taken[static_cast<std::size_t>(nearest)] = 1;
            take_left_vector(found->vectors.col(nearest), solutions_[i], record_.modes[i]);
        }
    }

    void take_left_vector(Eigen::VectorXcd y, const Eigen::VectorXcd& x, Eigenmode& mode) const {
        const Eigen::VectorXcd change =
            2.0 * mode.lambda() * multiply_complex(problem_.M, x) + multiply_complex(problem_.D, x);
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
    std::vector<Eigen::VectorXcd> solutions_;
    EigenvaluesRecord record_;
};

}  // namespace

EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const FrameColumns* frame) {
    return EigenvalueFinder(system, state, time, settings, frame).find();
}

}  // namespace gxrod
