#include <Eigen/LU>
#include <numbers>

#include "cross_section/cross_section.hpp"
#include "cross_section/profiles/profile_shape.hpp"
#include "mesh/sections/section_mesher.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Constants of a profile, ν = 0.3.
struct ProfileConstants {
    double It, Iw;
    PlanePoint shear_centre;
    double ky, kz, kyz = 0.0;  // shear stiffness about the shear centre over G A
};

ProfileConstants compute_constants(const Outline& outline) {
    ElasticMaterial material;
    material.stiffness = compute_isotropic_stiffness(1.0, 0.3);
    material.density = 1.0;
    const SectionProperties properties =
        compute_cross_section("", mesh_outline(outline, ""), {material})->properties;
    const double G = 1.0 / 2.6;
    const Mat6 F = properties.stiffness.inverse();
    const Eigen::Matrix2d shear = F.block<2, 2>(1, 1) - F.block<2, 1>(1, 3) * F.block<1, 2>(3, 1) / F(3, 3);
    const Eigen::Matrix2d k = shear.inverse() / (G * properties.area);
    return {1.0 / (G * F(3, 3)),
            properties.warping_stiffness,
            {-F(3, 2) / F(3, 3), F(3, 1) / F(3, 3)},
            k(0, 0),
            k(1, 1),
            k(0, 1)};
}

struct Reference {
    const char* name;
    ProfileShape shape;
    ProfileConstants constants;
};

const std::vector<Reference>& references() {
    static const std::vector<Reference> all{
        {"IPE 200", IShape{200, 100, 5.6, 8.5, 12}, {68462.0, 1.274616e10, {0, 0}, .553996, .384880}},
        {"sharp I", IShape{200, 100, 5.6, 8.5}, {50646.5, 1.297594e10, {0, 0}, .525577, .384499}},
        {"UPN 140",
         ChannelShape{
             .height = 140, .width = 60, .web = 7, .flange = 10, .fillet = 10, .toe = 5, .slope = 0.08},
         {57210.95, 1.791921e9, {-15.49477, 0}, .348846, .436923}},
        {"L 100x10",
         AngleShape{100, 100, 10, 12, 6},
         {68205.3, 4.427374e7, {5.893753, 5.893753}, .442636, .442636, -.0205}},
        {"SHS 100x5", BoxShape{100, 100, 5, 5, 10, 5}, {4417215, 4.682e6, {0, 0}, .439369, .439369}},
        {"T", TeeShape{100, 100, 10, 10, 8}, {70801.6, 2.933041e7, {0, 93.52208}, .479472, .425882}},
        {"hat", HatShape{60, 50, 20, 3, 3}, {1751.31, 9.09959e7, {0, 80.4207}, .165717, .514276}},
        {"CHS", HollowCircle{114.3, 5}, {5138404.091, 0, {0, 0}, .501724039, .501724039}}};
    return all;
}

}  // namespace

// Reference values X11, X13, X14, X16, X18, X19, X19c and X15: three finer meshes of other programs.
TEST_CASE("Profiles have the constants of the references at the default size", "[mesh]") {
    for (const auto& [name, shape, wanted] : references()) {
        INFO(name);
        const ProfileConstants found = compute_constants(draw_outline(shape));
        CHECK(found.It == Approx(wanted.It).epsilon(5e-5));
        CHECK(found.Iw == Approx(wanted.Iw).epsilon(1e-4).margin(1e-3));
        CHECK((found.shear_centre - wanted.shear_centre).norm() < 2e-5);
        CHECK(found.ky == Approx(wanted.ky).epsilon(2e-5));
        CHECK(found.kz == Approx(wanted.kz).epsilon(2e-5));
        CHECK(found.kyz == Approx(wanted.kyz).margin(5e-5));
    }
}

TEST_CASE("Blocks have the constants of closed forms at the default size", "[mesh]") {
    const auto block = [](double width) {
        return compute_constants(draw_outline({{{{0, 0}}, {{width, 0}}, {{width, 1}}, {{0, 1}}}}));
    };
    const ProfileConstants square = block(1.0), wide = block(2.0),
                           circle = compute_constants(draw_ring(1.0, 0.0));
    CHECK(square.It == Approx(0.140577014971491).epsilon(3e-5));
    CHECK(square.ky == Approx(0.828216007340560).epsilon(3e-6));
    CHECK(square.kz == Approx(square.ky).epsilon(1e-8));
    CHECK(wide.It == Approx(0.457363354255479).epsilon(1e-5));
    CHECK(wide.ky == Approx(0.832941726831447).epsilon(3e-6));
    CHECK(wide.kz == Approx(0.784441925213463).epsilon(3e-6));
    CHECK(circle.It == Approx(std::numbers::pi / 2.0).epsilon(1e-5));
    CHECK(circle.ky == Approx(6.0 / (7.0 + 0.09 / 1.69)).epsilon(1e-6));
}

}  // namespace gxrod::test
