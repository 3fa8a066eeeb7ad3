#include "analyses/shapes/gravity_excitation.hpp"

#include <cmath>

#include "assembly/system_measures.hpp"

namespace gxrod {

namespace {

// A vector that counts as one of loads, for which SystemMeasures computes forces, because it is a function.
TimeVector as_load(const Vec3& vector) {
    std::array<TimeFunction, 3> components;
    for (int i = 0; i < 3; ++i) {
        const double value = vector[i];
        components[static_cast<std::size_t>(i)] = TimeFunction([value](double) { return value; });
    }
    return TimeVector(components);
}

std::vector<Vec6> compute_forces(const System& system, const State& state, double time, const Vec3& gravity) {
    Model model = system.model();
    model.gravity = as_load(gravity);
    const System own(model, system.team(), touching_groups_of(system));
    return SystemMeasures(own).compute_load_forces(state, time);
}

}  // namespace

RevolvingLoad compute_gravity_excitation(
    const System& system, const State& state, double time, const TurningFrame& frame, const Vec3& gravity) {
    const double speed = frame.speed(time);
    const Vec3 across = gravity - frame.axis * frame.axis.dot(gravity);
    // What loads and water do without gravity is taken out.
    const std::vector<Vec6> none = compute_forces(system, state, time, Vec3::Zero());
    const auto compute = [&](const Vec3& direction) {
        std::vector<Vec6> forces = compute_forces(system, state, time, direction);
        for (std::size_t i = 0; i < forces.size(); ++i) forces[i] -= none[i];
        return forces;
    };
    return {std::abs(speed),
            {compute(across), compute(std::copysign(1.0, speed) * frame.axis.cross(across))}};
}

}  // namespace gxrod
