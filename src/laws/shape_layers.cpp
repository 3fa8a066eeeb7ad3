#include "laws/shape_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gxrod {
namespace {

// With so many no moment or torque differs from the exact one by more than 1e-4 of it.
constexpr int layers_of_bending = 68;
constexpr int layers_of_torsion = 48;
// Of the integral by which fibres are shared out; it places layers, whose sums are exact.
constexpr int grid_size = 2048;

// Fibres by their distance from an axis, or from the centre: what those beyond it add up to.
struct Fibres {
    double innermost, outermost;
    std::function<double(double)> density;        // dA over the distance
    std::function<double(double)> second_moment;  // ∫ z² dA of those within the distance
    std::function<double(double)> first_moment;   // ∫ |z| dA of those beyond it
};

// Distances from the outermost fibre to the innermost between which the error of a layer is nearly the same:
// equal shares of ∫ √density dz (L11).
std::vector<double> share_out(const Fibres& fibres, int count) {
    const double step = (fibres.outermost - fibres.innermost) / grid_size;
    std::vector<double> sums{0.0};
    for (int i = 0; i < grid_size; ++i)
        sums.push_back(sums.back() + std::sqrt(fibres.density(fibres.outermost - (i + 0.5) * step)));
    std::vector<double> distances{fibres.outermost};
    for (int layer = 1; layer < count; ++layer) {
        const double share = sums.back() * layer / count;
        const auto above = std::ranges::upper_bound(sums, share);
        const double part = (share - *(above - 1)) / (*above - *(above - 1));
        const auto index = static_cast<double>(above - 1 - sums.begin());
        distances.push_back(fibres.outermost - (index + part) * step);
    }
    distances.push_back(fibres.innermost);
    return distances;
}

// (L10): those between two distances yield together.
void add_layers(
    StrainPart on, const Fibres& fibres, double modulus, double stress, std::vector<Layer>& layers) {
    const int count = on == StrainPart::torsion ? layers_of_torsion : layers_of_bending;
    const std::vector<double> distances = share_out(fibres, count);
    for (std::size_t i = 0; i + 1 < distances.size(); ++i) {
        const double stiffness = fibres.second_moment(distances[i]) - fibres.second_moment(distances[i + 1]);
        const double limit = fibres.first_moment(distances[i + 1]) - fibres.first_moment(distances[i]);
        layers.push_back({on, modulus * stiffness, stress * limit, 0.0});
    }
}

// Of a full circle about a diameter. With z = r sin θ the second moment is r⁴/2 (θ − sin 4θ/4).
double circle_second_moment(double radius, double z) {
    if (radius == 0.0) return 0.0;
    const double angle = std::asin(std::min(1.0, z / radius));
    return 0.5 * std::pow(radius, 4) * (angle - 0.25 * std::sin(4.0 * angle));
}
double circle_first_moment(double radius, double z) {
    return z < radius ? 4.0 / 3.0 * std::pow((radius - z) * (radius + z), 1.5) : 0.0;
}
double circle_density(double radius, double z) {
    return z < radius ? 2.0 * std::sqrt((radius - z) * (radius + z)) : 0.0;
}

Fibres make_tube_bending(double outer, double inner) {
    return {0.0,
            outer,
            [=](double z) { return circle_density(outer, z) - circle_density(inner, z); },
            [=](double z) { return circle_second_moment(outer, z) - circle_second_moment(inner, z); },
            [=](double z) { return circle_first_moment(outer, z) - circle_first_moment(inner, z); }};
}

Fibres make_tube_torsion(double outer, double inner) {
    return {inner,
            outer,
            [](double z) { return 2.0 * M_PI * z; },
            [=](double z) { return 0.5 * M_PI * (std::pow(z, 4) - std::pow(inner, 4)); },
            [=](double z) { return 2.0 / 3.0 * M_PI * (std::pow(outer, 3) - std::pow(z, 3)); }};
}

Fibres make_rectangle_bending(double across, double along) {
    const double half = 0.5 * along;
    return {0.0,
            half,
            [=](double) { return 2.0 * across; },
            [=](double z) { return 2.0 / 3.0 * across * z * z * z; },
            [=](double z) { return across * (half - z) * (half + z); }};
}

double shear_stress(const YieldingMaterial& material) { return material.yield_stress / std::sqrt(3.0); }

Layer make_tension(double area, const YieldingMaterial& material) {
    return {StrainPart::tension, material.E * area, material.yield_stress * area, 0.0};
}

}  // namespace

std::vector<Layer> make_tube_layers(double outer, double inner, const YieldingMaterial& material) {
    std::vector<Layer> layers{make_tension(M_PI * (outer - inner) * (outer + inner), material)};
    add_layers(
        StrainPart::torsion, make_tube_torsion(outer, inner), material.G, shear_stress(material), layers);
    add_layers(
        StrainPart::bending, make_tube_bending(outer, inner), material.E, material.yield_stress, layers);
    return layers;
}

// The plastic torque is twice the volume of sand heaped upon the section (Nádai), a single layer.
std::vector<Layer> make_rectangle_layers(double width,
                                         double height,
                                         double torsion_constant,
                                         const YieldingMaterial& material) {
    std::vector<Layer> layers{make_tension(width * height, material)};
    const double a = std::max(width, height);
    const double b = std::min(width, height);
    layers.push_back({StrainPart::torsion,
                      material.G * torsion_constant,
                      shear_stress(material) * b * b * (3.0 * a - b) / 6.0,
                      0.0});
    const auto bend = [&](StrainPart on, const Fibres& fibres) {
        add_layers(on, fibres, material.E, material.yield_stress, layers);
    };
    bend(StrainPart::bending_y, make_rectangle_bending(width, height));
    bend(StrainPart::bending_z, make_rectangle_bending(height, width));
    return layers;
}

}  // namespace gxrod
