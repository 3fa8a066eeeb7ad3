#include "analyses/shapes/response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "assembly/scatter.hpp"
#include "linear/eigen/quadratic_problem.hpp"
#include "linear/suite_sparse/complex_solver.hpp"
#include "model/ties/yielding_supports.hpp"

namespace gxrod {

namespace {

using Complex = std::complex<double>;

// Of the motion: where round-off may change it by more, it is none.
constexpr double solved = 1e-3;

QuadraticProblem make_problem(const System& system, const StateMatrices& matrices) {
    return matrices.problem_on(system.pattern());
}

Eigen::VectorXcd gather_complex(const ComplexVectors& nodal, const EquationNumbers& equations) {
    Eigen::VectorXcd vector(equations.count());
    vector.real() = gather(nodal.real, equations);
    vector.imag() = gather(nodal.imaginary, equations);
    return vector;
}

ComplexVectors spread(const Eigen::VectorXcd& solution, const EquationNumbers& equations) {
    const Eigen::VectorXd real = solution.real(), imaginary = solution.imag();
    ComplexVectors nodal;
    for (int node = 0; node < static_cast<int>(equations.node_count()); ++node) {
        nodal.real.push_back(equations.increment_of(node, real));
        nodal.imaginary.push_back(equations.increment_of(node, imaginary));
    }
    return nodal;
}

// Springs by which supports yield are left out, so that their forces are out of balance, too.
Model without_springs(Model model) {
    std::erase_if(model.bushings, is_support);
    return model;
}

class ResponseFinder {
  public:
    ResponseFinder(const System& system,
                   const State& state,
                   double time,
                   const ComplexVectors& excitation,
                   const FrameColumns* frame)
        : system_(system),
          problem_(make_problem(
              system,
              frame ? frame->compute_matrices(state, time) : compute_state_matrices(system, state, time))),
          solver_(system.pattern()),
          free_model_(without_springs(without_supports(system.model()))),
          free_system_(free_model_, system.team(), touching_groups_of(system)),
          force_(gather_complex(excitation, system.equations())),
          free_force_(gather_complex(excitation, free_system_.equations())) {
        std::optional<FrameColumns> columns;
        if (frame) columns.emplace(free_system_, frame->frame());
        free_problem_ = make_problem(free_system_,
                                     columns ? columns->compute_matrices(state, time)
                                             : compute_state_matrices(free_system_, state, time));
    }

    Response find(double omega) {
        Response response;
        response.omega = omega;
        const Complex lambda(0.0, omega);
        const std::vector<Complex> values = problem_.at(lambda);
        Eigen::VectorXcd x = force_;
        const bool is_regular = solver_.factorize(values);
        if (is_regular) {
            solver_.solve(x);
            response.error = estimate_error(values, x);
        }
        if (!is_regular || !(response.error <= solved)) {
            response.failure = "the model resonates without damping";
            return response;
        }
        response.motion = spread(x, system_.equations());
        response.reactions = find_reactions(lambda, values, x, response.motion);
        return response;
    }

  private:
    // What changes of the terms of each equation by a unit of rounding, of alternating signs, do to it.
    double estimate_error(const std::vector<Complex>& values, const Eigen::VectorXcd& x) {
        Eigen::VectorXcd change = force_.cwiseAbs().cast<Complex>();
        problem_.pattern->visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
            change[row] += std::abs(values[static_cast<std::size_t>(slot)]) * std::abs(x[column]);
        });
        double sign = std::numeric_limits<double>::epsilon();
        for (Complex& component : change) component *= (sign = -sign);
        solver_.solve(change);
        return x.isZero(0.0) ? 0.0 : change.norm() / x.norm();
    }

    // What is out of balance without the supports, in what these hold.
    ComplexVectors find_reactions(Complex lambda,
                                  const std::vector<Complex>& held_values,
                                  const Eigen::VectorXcd& solution,
                                  const ComplexVectors& motion) const {
        Eigen::VectorXcd x = gather_complex(motion, free_system_.equations());
        const std::vector<Complex> values = free_problem_.at(lambda);
        copy_multipliers(held_values, solution, values, x);
        Eigen::VectorXcd forces = -free_force_;
        free_problem_.pattern->visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
            forces[row] += values[static_cast<std::size_t>(slot)] * x[column];
        });
        ComplexVectors reactions = spread(forces, free_system_.equations());
        const EquationNumbers& equations = system_.equations();
        for (int node = 0; node < static_cast<int>(equations.node_count()); ++node) {
            if (yields_at(system_.model(), node)) continue;
            const auto numbers = equations.of_node(node);
            for (std::vector<Vec6>* part : {&reactions.real, &reactions.imaginary}) {
                Vec6& force = (*part)[static_cast<std::size_t>(node)];
                Vec6 own = equations.to_own_axes(node, force);
                for (int i = 0; i < 6; ++i) {
                    if (numbers[i] >= 0) own[i] = 0.0;
                }
                force = equations.to_global_axes(node, own);
            }
        }
        return reactions;
    }

    // Joints pull at what is supported, too. Their equations are scaled in each matrix by its own diagonal.
    void copy_multipliers(const std::vector<Complex>& held_values,
                          const Eigen::VectorXcd& solution,
                          const std::vector<Complex>& values,
                          Eigen::VectorXcd& x) const {
        const auto find_scale = [](const System& system, const std::vector<Complex>& all, std::int64_t row) {
            return all[static_cast<std::size_t>(system.pattern().slot(row, row))];
        };
        const std::vector<AttachedUnknowns>& attached = system_.joints().attached();
        for (std::size_t i = 0; i < attached.size(); ++i) {
            const std::int64_t held = system_.equations().of_attached(i);
            const std::int64_t free = free_system_.equations().of_attached(i);
            for (std::int64_t k = 0; k < attached[i].count; ++k) {
                x[free + k] = solution[held + k] * find_scale(system_, held_values, held + k) /
                              find_scale(free_system_, values, free + k);
            }
        }
    }

    const System& system_;
    QuadraticProblem problem_;
    ComplexSolver solver_;
    Model free_model_;
    System free_system_;
    QuadraticProblem free_problem_;
    Eigen::VectorXcd force_, free_force_;
};

}  // namespace

ResponseRecord find_response(const System& system,
                             const State& state,
                             double time,
                             const std::vector<double>& omegas,
                             const ComplexVectors& excitation,
                             const FrameColumns* frame) {
    ResponseRecord record;
    record.time = time;
    ResponseFinder finder(system, state, time, excitation, frame);
    for (const double omega : omegas) record.responses.push_back(finder.find(omega));
    return record;
}

}  // namespace gxrod
