#include "tools/free_flight.hpp"

#include <cmath>
#include <numbers>

namespace gxrod::tools {

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

double load(double time) {
    if (time >= duration) return 0.0;
    const double sine = std::sin(std::numbers::pi * time / duration);
    return amplitude * sine * sine;
}

}  // namespace

Model make_free_flight(int elements) {
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
    pull.force[0] = TimeFunction([](double time) { return load(time) / 10.0; });
    pull.moment[1] = TimeFunction([](double time) { return -load(time) / 2.0; });
    pull.moment[2] = TimeFunction([](double time) { return -load(time); });
    model.loads.push_back(pull);
    return model;
}

}  // namespace gxrod::tools
