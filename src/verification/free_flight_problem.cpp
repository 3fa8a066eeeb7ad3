#include "verification/free_flight_problem.hpp"

#include <cmath>
#include <numbers>

namespace gxrod::free_flight {

namespace {

constexpr double duration = 5.0;
constexpr double amplitude = 200.0;

Section make_section() {
    Section section{"tube", Mat6::Zero(), Mat6::Zero()};
    section.stiffness.diagonal() << 1e4, 1e4, 1e4, 500.0, 500.0, 500.0;
    section.mass.diagonal() << 1.0, 1.0, 1.0, 20.0, 10.0, 10.0;
    return section;
}

// Columns x along the rod, y towards global z as far as it can be.
Quat section_axes(const Vec3& tangent) {
    Mat3 axes;
    axes << tangent, Vec3::UnitZ(), tangent.cross(Vec3::UnitZ());
    return Quat(axes);
}

}  // namespace

double load(Pulse pulse, double time) {
    if (time >= duration) return 0.0;
    if (pulse == Pulse::triangular) return amplitude * (1.0 - std::abs(time - 2.5) / 2.5);
    const double sine = std::sin(std::numbers::pi * time / duration);
    return amplitude * sine * sine;
}

Model make_model(Pulse pulse, int elements) {
    const Vec3 from(6, 0, 0);
    const Vec3 to(0, 8, 0);
    Model model;
    model.sections.push_back(make_section());
    Rod rod;
    rod.name = "flyer";
    rod.kind = ElementKind::simo;
    std::vector<double> arc_length;
    for (int i = 0; i <= elements; ++i) {
        const double fraction = static_cast<double>(i) / elements;
        model.nodes.push_back({"flyer node " + std::to_string(i), from + fraction * (to - from)});
        rod.nodes.push_back(i);
        arc_length.push_back(fraction * (to - from).norm());
    }
    const Quat triad = section_axes((to - from).normalized());
    set_line_elements(rod, arc_length, std::vector<Quat>(arc_length.size(), triad));
    model.rods.push_back(rod);
    NodalLoad pull;
    pull.key = "load[0]";
    pull.force[0] = TimeFunction([pulse](double time) { return load(pulse, time) / 10.0; });
    pull.moment[1] = TimeFunction([pulse](double time) { return -load(pulse, time) / 2.0; });
    pull.moment[2] = TimeFunction([pulse](double time) { return -load(pulse, time); });
    model.loads.push_back(pull);
    return model;
}

Reference reference(Pulse pulse) {
    if (pulse == Pulse::triangular) {
        return {{3.60683, 0.04470, -0.42726},
                {3.98176, 8.53172, -0.54047},
                {19.21360, 1.62556, -2.12724},
                {12.95300, 6.80943, 3.02877},
                724.436,
                2e-5};
    }
    return {{3.5229950, 0.2040558, -0.5968514},
            {3.1675222, 8.1848754, -0.4010940},
            {18.838055, 1.641086, -2.378193},
            {13.856509, 7.031570, 3.334713},
            764.240708,
            1.3e-7};
}

Vec3 exact_momentum() { return {50.0, 0.0, 0.0}; }

Vec3 reference_angular_momentum() { return {0.0, -309.6410438, -526.0527178}; }

}  // namespace gxrod::free_flight
