#include "check/static_scale.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "assembly/scatter.hpp"
#include "assembly/system.hpp"
#include "check/motions/free_parts.hpp"
#include "integrators/load_stepping.hpp"
#include "linear/linear_solver.hpp"
#include "model/evaluation_error.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

// More unknowns are not examined: it would take longer than a user waits for a check.
constexpr std::int64_t most_unknowns = 100'000;
constexpr int most_times = 50;
// Of a linear answer: soft structures that turn by large angles are below these, units that differ are far
// above.
constexpr double largest_strain = 2.0;
constexpr double largest_displacement = 100.0;

// At rest: what is out of balance are gravity and loads. Obstacles that come nearer push as hard as is
// needed.
Model make_resting(Model model) {
    model.contact = {};
    for (Node& node : model.nodes) {
        node.velocity.setZero();
        node.angular_velocity.setZero();
    }
    return model;
}

// The forces at the time at which they are largest; empty without any.
Eigen::VectorXd find_largest_forces(const System& system, const State& state, double end, double& time) {
    Eigen::VectorXd largest;
    double norm = 0.0;
    for (int i = 0; i <= most_times; ++i) {
        const double at = end * i / most_times;
        Residual residual;
        try {
            system.compute_residual(state, at, residual);
        } catch (const EvaluationError&) {
            continue;  // between steps, where no function need have a value
        }
        const Eigen::VectorXd forces = -gather(residual.nodal, system.equations());
        if (!(forces.norm() > norm)) continue;
        norm = forces.norm();
        largest = forces;
        time = at;
    }
    return largest;
}

// Strains of an element between two of its nodes, to first order in small displacements and turns.
double compute_strain(const Model& model, const Rod& rod, std::size_t entry, const std::vector<Vec6>& moved) {
    const int first = rod.element_nodes[entry];
    const int last = rod.element_nodes[entry + 1];
    const double length = rod.arc_length[entry + 1] - rod.arc_length[entry];
    const Vec3 chord = model.nodes[last].position - model.nodes[first].position;
    const Vec3 turn = 0.5 * (moved[first].tail<3>() + moved[last].tail<3>());
    const Vec3 stretch = (moved[last].head<3>() - moved[first].head<3>() - turn.cross(chord)) / length;
    const Vec3 bend =
        rod.triads[entry].conjugate() * ((moved[last].tail<3>() - moved[first].tail<3>()) / length);
    // Radii of gyration: the strains of a section's edge are about these times the curvature.
    const Mat6& C = model.sections[rod.section].stiffness;
    const Vec3 radii = (C.diagonal().tail<3>() / C(0, 0)).cwiseSqrt();
    return std::max(stretch.norm(), radii.cwiseProduct(bend).norm());
}

void find_largest(const Model& model, const std::vector<Vec6>& moved, StaticScale& scale) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    const double size = box.diagonal().norm();
    for (std::size_t node = 0; node < moved.size(); ++node) {
        const double displacement = moved[node].head<3>().norm() / size;
        if (!(displacement > scale.displacement)) continue;
        scale.displacement = displacement;
        scale.node = static_cast<int>(node);
    }
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        const Rod& rod = model.rods[r];
        const auto per_element = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t i = 0; i + 1 < rod.element_nodes.size(); ++i) {
            if ((i + 1) % per_element == 0) continue;
            const double strain = compute_strain(model, rod, i, moved);
            if (!(strain > scale.strain)) continue;
            scale.strain = strain;
            scale.rod = static_cast<int>(r);
        }
    }
}

}  // namespace

std::optional<StaticScale> find_static_scale(const Model& model, const AnalysisSettings& analysis) {
    if (model.rods.empty() || 6 * static_cast<std::int64_t>(model.nodes.size()) > most_unknowns ||
        count_free_motions(model) > 0) {
        return std::nullopt;
    }
    const Model resting = make_resting(model);
    const System system(resting);
    const State state = system.initial_state();
    StaticScale scale;
    Eigen::VectorXd solution = find_largest_forces(system, state, end_of(analysis), scale.time);
    if (solution.size() == 0) return std::nullopt;
    std::vector<NodeLinearization> linearizations(state.trial.size());
    LoadStepping().linearize(state, {}, linearizations);
    std::vector<double> values;
    system.compute_tangent(state, 0.0, linearizations, values);
    const std::unique_ptr<LinearSolver> solver = make_general_solver(system.pattern());
    if (!solver->factorize(values).regular) return std::nullopt;
    solver->solve(solution);
    std::vector<Vec6> moved(model.nodes.size());
    for (std::size_t node = 0; node < moved.size(); ++node) {
        moved[node] = system.equations().increment_of(static_cast<int>(node), solution);
    }
    find_largest(model, moved, scale);
    return scale;
}

std::string describe_static_scale(const Model& model, const AnalysisSettings& analysis) {
    const std::optional<StaticScale> scale = find_static_scale(model, analysis);
    if (!scale) return "";
    std::string what;
    if (scale->strain > largest_strain) {
        what = fmt::format("strain rod {} by {:.3g}", model.rods[scale->rod].name, scale->strain);
    } else if (scale->displacement > largest_displacement) {
        what = fmt::format(
            "move {} by {:.3g} times the model's size", model.nodes[scale->node].name, scale->displacement);
    } else {
        return "";
    }
    return fmt::format(
        "at t = {:.6g} gravity and loads would {}, if the model answered linearly; are moduli, masses and "
        "lengths in one set of units (pascals with metres)?",
        scale->time,
        what);
}

}  // namespace gxrod
