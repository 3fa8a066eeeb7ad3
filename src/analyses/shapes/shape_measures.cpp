#include "analyses/shapes/shape_measures.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/shapes/shape_words.hpp"
#include "assembly/scatter.hpp"
#include "assembly/system_values.hpp"
#include "linear/eigen/pencil.hpp"

namespace gxrod {

namespace {

// So large that what is out of balance, and other forces, vanish in its round-off.
constexpr double acceleration = 0x1p40;

Vec6 compute_rigid_direction(int axis, const Vec3& r) {
    Vec6 direction = Vec6::Zero();
    direction[axis] = 1.0;
    if (axis >= 3) direction.head<3>() = Vec3::Unit(axis - 3).cross(r);
    return direction;
}

// What a shape does most: displacing nodes, or turning them if what displacements it has are round-off.
struct Largest {
    int first = 0;  // component of displacements, 3 of rotations
    double size = 0.0;
};

Largest find_largest(const System& system, const Shape& shape) {
    double displacement = 0.0, rotation = 0.0;
    for (const Vec6& motion : shape.nodes) {
        displacement = std::max(displacement, motion.head<3>().norm());
        rotation = std::max(rotation, motion.tail<3>().norm());
    }
    if (displacement > 1e-9 * rotation * system.length_scale()) return {0, displacement};
    return {3, rotation};
}

double find_sign(const Shape& shape, const Largest& largest) {
    double component = 0.0;
    for (const Vec6& motion : shape.nodes) {
        for (int i = largest.first; i < largest.first + 3; ++i) {
            if (std::abs(motion[i]) > (1.0 + 1e-6) * std::abs(component)) component = motion[i];
        }
    }
    return component < 0.0 ? -1.0 : 1.0;
}

void scale(Shape& shape, double factor) {
    for (Vec6& motion : shape.nodes) motion *= factor;
}

}  // namespace

WholeInertia compute_whole_inertia(const System& system, const State& state, double time) {
    Residual still, accelerated;
    system.compute_residual(state, time, still);
    WholeInertia inertia;
    State moved = state;
    for (int axis = 0; axis < 6; ++axis) {
        for (std::size_t i = 0; i < state.trial.size(); ++i) {
            const Vec6 direction = compute_rigid_direction(axis, state.trial[i].r);
            moved.trial[i].a = state.trial[i].a + acceleration * direction.head<3>();
            moved.trial[i].alpha = state.trial[i].alpha + acceleration * direction.tail<3>();
        }
        system.compute_residual(moved, time, accelerated);
        for (std::size_t i = 0; i < state.trial.size(); ++i) {
            Vec6& force = accelerated.nodal[i];
            force = (force - still.nodal[i]) / acceleration;
            inertia.total[axis] += force.dot(compute_rigid_direction(axis, state.trial[i].r));
        }
        inertia.forces[axis] = gather(accelerated.nodal, system.equations(), system.team());
    }
    return inertia;
}

Shape make_shape(const System& system, const State& state, const Eigen::VectorXd& solution) {
    Shape shape;
    shape.nodes.resize(state.trial.size());
    for (std::size_t i = 0; i < shape.nodes.size(); ++i)
        shape.nodes[i] = system.equations().increment_of(static_cast<int>(i), solution);
    scale(shape, find_sign(shape, find_largest(system, shape)));
    shape.energy_shares = SystemValues(system).compute_strain_work(state, shape.nodes);
    double energy = 0.0;
    for (const Vec6& shares : shape.energy_shares) energy += shares.sum();
    for (Vec6& shares : shape.energy_shares) {
        if (energy > 0.0) shares /= energy;
    }
    shape.words = describe_shape(system, state, shape);
    return shape;
}

Shape make_unit_shape(const System& system, const State& state, const Eigen::VectorXd& solution) {
    Shape shape = make_shape(system, state, solution);
    const Largest largest = find_largest(system, shape);
    if (largest.size > 0.0) scale(shape, 1.0 / largest.size);
    return shape;
}

double measure_gap_share(const System& system, const std::vector<double>& K, const Eigen::VectorXcd& x) {
    const EquationNumbers& equations = system.equations();
    if (equations.attached_count() == 0) return 0.0;
    double gaps = 0.0;
    for (int node = 0; node < static_cast<int>(equations.node_count()); ++node) {
        const std::array<std::int64_t, 6> numbers = equations.of_node(node);
        const auto unknowns = std::ranges::count_if(numbers, [](std::int64_t one) { return one >= 0; });
        for (std::int64_t i = equations.first_of(node) + unknowns; i < equations.end_of(node); ++i) {
            const double yields = -K[static_cast<std::size_t>(system.pattern().slot(i, i))];
            gaps += std::max(yields, 0.0) * std::norm(x[i]);
        }
    }
    Eigen::VectorXd real, imaginary;
    multiply(system.pattern(), K, x.real(), real);
    multiply(system.pattern(), K, x.imag(), imaginary);
    const double energy = std::abs(real.dot(x.real()) + imaginary.dot(x.imag()));
    return energy > 0.0 ? gaps / energy : 0.0;
}

}  // namespace gxrod
