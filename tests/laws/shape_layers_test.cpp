#include "laws/shape_layers.hpp"

#include <cmath>

#include "laws/law_path.hpp"
#include "tools/catch.hpp"

// Against the exact curves of elastic, perfectly plastic material, integrated over fibres.
namespace gxrod::test {
namespace {

constexpr YieldingMaterial steel{.E = 200.0, .G = 80.0, .yield_stress = 0.3};

// ∫ σ(κ z) z dA over the distance, by midpoints.
template <class Density>
double integrate_stress(
    double curvature, double from, double to, double modulus, double limit, const Density& density) {
    constexpr int cells = 20000;
    double sum = 0.0;
    const double step = (to - from) / cells;
    for (int i = 0; i < cells; ++i) {
        const double z = from + (i + 0.5) * step;
        sum += std::min(modulus * curvature * z, limit) * z * density(z) * step;
    }
    return sum;
}

double half_width(double radius, double z) { return z < radius ? std::sqrt(radius * radius - z * z) : 0.0; }

// The largest difference between the law of some layers and a curve, relative.
template <class Curve>
double find_largest_error(const std::vector<Layer>& layers, int entry, double at_yield, const Curve& curve) {
    const LayeredLaw law(Mat6::Zero(), layers);
    double largest = 0.0;
    const double limit = curve(1e4 * at_yield);
    for (double k = 0.1; k < 300.0; k *= 1.02) {
        LawPath path(law);
        const double resultant = path.go(strain_along(entry, k * at_yield), 1.0).resultants[entry];
        const double exact = curve(k * at_yield);
        if (k < 1.0) CHECK(resultant == Approx(exact).epsilon(1e-6));
        largest = std::max(largest, std::abs(resultant - exact) / exact);
    }
    LawPath path(law);
    CHECK(path.go(strain_along(entry, 1e6 * at_yield), 1.0).resultants[entry] == Approx(limit).epsilon(1e-4));
    return largest;
}

}  // namespace

// M/My = 3/2 − (κy/κ)²/2.
TEST_CASE("Layers of a rectangle follow its curves", "[laws]") {
    const std::vector<Layer> layers = make_rectangle_layers(0.2, 0.3, 1e-3, steel);
    const auto curve = [](double across, double along) {
        return [=](double curvature) {
            const double at_yield = steel.yield_stress / steel.E / (0.5 * along);
            const double My = steel.yield_stress * across * along * along / 6.0;
            const double k = curvature / at_yield;
            return k < 1.0 ? My * k : My * (1.5 - 0.5 / (k * k));
        };
    };
    const double strain = steel.yield_stress / steel.E;
    CHECK(find_largest_error(layers, 4, strain / 0.15, curve(0.2, 0.3)) < 1e-4);
    CHECK(find_largest_error(layers, 5, strain / 0.1, curve(0.3, 0.2)) < 1e-4);
    const LayeredLaw law(Mat6::Zero(), layers);
    LawPath path(law);
    const Vec6 S = path.go(Vec6(0.1, 0.0, 0.0, 100.0, 0.0, 0.0), 1.0).resultants;
    CHECK(S[0] == Approx(0.3 * 0.06).epsilon(1e-14));
    // Sand heaped on 0.3 × 0.2.
    CHECK(S[3] == Approx(0.3 / std::sqrt(3.0) * 0.04 * (0.9 - 0.2) / 6.0).epsilon(1e-14));
}

TEST_CASE("Layers of circles and tubes follow their curves", "[laws]") {
    const double strain = steel.yield_stress / steel.E;
    const double shear = steel.yield_stress / std::sqrt(3.0);
    for (const double inner : {0.0, 0.25, 0.45, 0.499}) {
        INFO(inner);
        const double outer = 0.5;
        const std::vector<Layer> layers = make_tube_layers(outer, inner, steel);
        const auto bending = [&](double curvature) {
            return integrate_stress(curvature, 0.0, outer, steel.E, steel.yield_stress, [&](double z) {
                return 4.0 * (half_width(outer, z) - half_width(inner, z));
            });
        };
        const auto torsion = [&](double twist) {
            return integrate_stress(
                twist, inner, outer, steel.G, shear, [](double z) { return 2.0 * M_PI * z; });
        };
        const double bent = find_largest_error(layers, 4, strain / outer, bending);
        const double twisted = find_largest_error(layers, 3, shear / steel.G / outer, torsion);
        CHECK(bent < 1e-4);
        CHECK(twisted < 1e-4);
        CAPTURE(bent, twisted);
        const double area = M_PI * (outer * outer - inner * inner);
        const LayeredLaw law(Mat6::Zero(), layers);
        LawPath path(law);
        CHECK(path.go(strain_along(0, 0.1), 1.0).resultants[0] ==
              Approx(steel.yield_stress * area).epsilon(1e-14));
    }
}

// Unloaded from 1.1 times the torque at yield, GJ = 800, Ty = 400 and L = 3: an end stays turned by 0.0394.
TEST_CASE("A circle that yielded in torsion springs back elastically", "[laws]") {
    const double G = 800.0 / (0.5 * M_PI);  // radius 1
    const double stress = std::sqrt(3.0) * 400.0 / (0.5 * M_PI);
    const LayeredLaw law(Mat6::Zero(), make_tube_layers(1.0, 0.0, {2.0 * G, G, stress}));
    LawPath path(law);
    const double twist = 0.5 / std::cbrt(4.0 - 3.0 * 1.1);
    CHECK(path.go(strain_along(3, twist), 1.0).resultants[3] == Approx(440.0).epsilon(1e-4));
    CHECK(3.0 * twist == Approx(1.6893718206654).epsilon(1e-12));
    const double residual = twist - 440.0 / 800.0;
    CHECK(3.0 * residual == Approx(0.039371820665409).epsilon(1e-9));
    CHECK(path.go(strain_along(3, residual), 1.0).resultants[3] == Approx(0.0).margin(440.0 * 1e-4));
}

}  // namespace gxrod::test
