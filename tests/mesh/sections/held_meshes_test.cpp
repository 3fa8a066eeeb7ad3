#include "mesh/sections/held_meshes.hpp"

#include <cmath>

#include "cross_section/cross_section.hpp"
#include "cross_section/profiles/profile_shape.hpp"
#include "mesh/sections/section_mesher.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

struct Constants {
    double torsion, bending, shear;
    std::size_t cells;
};

Constants solve(double web, double fillet = 12.0) {
    const Outline outline = draw_outline(ProfileShape(IShape{200, 100, web, 8.5, fillet}));
    const ElasticMaterial steel{.name = "steel", .stiffness = compute_isotropic_stiffness(2.6, 0.3)};
    const auto section = compute_cross_section("I", mesh_outline(outline, "all"), {steel});
    const Mat6& K = section->properties.stiffness;
    return {K(3, 3), K(4, 4), K(2, 2), section->mesh.cells.size()};
}

}  // namespace

TEST_CASE("On held cells, constants of a profile are smooth functions of its numbers", "[mesh]") {
    const double web = 5.61803;
    const Constants base = solve(web);
    const auto slope = [&](double relative) -> Vec3 {
        const HeldMeshes held;
        const Constants more = solve(web * (1.0 + relative)), less = solve(web * (1.0 - relative));
        CHECK(more.cells == base.cells);
        CHECK(less.cells == base.cells);
        return Vec3(more.torsion - less.torsion, more.bending - less.bending, more.shear - less.shear) /
               (2.0 * relative * web);
    };
    const Vec3 near = slope(5e-4), far = slope(1e-3);
    // The slope of smooth functions changes by the square of the step.
    for (int i = 0; i < 3; ++i) CHECK(near[i] == Approx(far[i]).epsilon(3e-6));
    // And it is that of separate meshes, far apart, but for their noise.
    const Constants thick = solve(1.04 * web), thin = solve(0.96 * web);
    CHECK(near[0] == Approx((thick.torsion - thin.torsion) / (0.08 * web)).epsilon(5e-3));
    CHECK(near[1] == Approx((thick.bending - thin.bending) / (0.08 * web)).epsilon(2e-5));
    CHECK(near[2] == Approx((thick.shear - thin.shear) / (0.08 * web)).epsilon(2e-3));
}

TEST_CASE("Held cells stay out of what is not near, or has other pieces", "[mesh]") {
    const Constants round = solve(6.2, 12.0);
    const Constants sharp = solve(6.2, 0.0);
    const HeldMeshes held;
    CHECK(solve(6.2, 0.0).cells == sharp.cells);
    CHECK(solve(6.2, 12.0).cells == round.cells);
    const Constants far = solve(9.0);
    CHECK(far.torsion > 1.2 * round.torsion);
}

}  // namespace gxrod::test
