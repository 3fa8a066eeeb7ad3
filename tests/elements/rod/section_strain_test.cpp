#include "elements/rod/section_strain.hpp"

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

struct Case {
    std::string name;
    SectionFields fields;
    SectionHistory history;
    ReferenceStrain reference;
};

std::vector<Case> make_cases() {
    RandomValues random(21);
    std::vector<Case> cases;
    for (const double angle : {0.0, 1e-9, 1e-4, 0.7, 2.0, 3.1}) {
        cases.push_back({"theta of " + std::to_string(angle),
                         {random.vector(), angle * random.direction(), random.vector()},
                         {random.rotation(), random.vector()},
                         {random.vector(), random.vector()}});
    }
    return cases;
}

SectionFields move(const SectionFields& fields, int unknown, double amount) {
    SectionFields moved = fields;
    Vec3* const parts[3] = {&moved.r_prime, &moved.theta, &moved.theta_prime};
    (*parts[unknown / 3])[unknown % 3] += amount;
    return moved;
}

}  // namespace

TEST_CASE("strains are those of the interpolated section axes", "[elements][rod]") {
    // Along s: θ(s) = θ + s θ′, so Λ(s) = exp(θ(s)) Λ_n(s), where Λ_n turns by K_n.
    for (const Case& it : make_cases()) {
        INFO(it.name);
        const auto axes = [&](double s) {
            const Quat previous = it.history.Lambda * exp_quaternion(s * it.history.K);
            return Mat3(
                (exp_quaternion(it.fields.theta + s * it.fields.theta_prime) * previous).toRotationMatrix());
        };
        const Mat3 slope = differentiate(axes);
        const Vec3 curvature = axial(axes(0.0).transpose() * slope);
        Vec6 expected;
        expected << axes(0.0).transpose() * it.fields.r_prime - it.reference.Gamma,
            curvature - it.reference.Kappa;
        CHECK(relative_difference(compute_strain(it.fields, it.history, it.reference), expected) < 1e-10);
        CHECK(relative_difference(compute_total_curvature(it.fields, it.history), curvature) < 1e-10);
        CHECK(relative_difference(compute_section_axes(it.fields.theta, it.history).toRotationMatrix(),
                                  axes(0.0)) < 1e-14);
    }
}

TEST_CASE("the strain gradient is the derivative of the strains", "[elements][rod]") {
    for (const Case& it : make_cases()) {
        INFO(it.name);
        Eigen::Matrix<double, 6, 9> expected;
        for (int unknown = 0; unknown < 9; ++unknown) {
            expected.col(unknown) = differentiate([&](double amount) {
                return compute_strain(move(it.fields, unknown, amount), it.history, it.reference);
            });
        }
        CHECK(relative_difference(compute_strain_gradient(it.fields, it.history), expected) < 1e-10);
    }
}

TEST_CASE("the geometric Hessian is the second derivative of N·Γ + M·K", "[elements][rod]") {
    RandomValues random(22);
    for (const Case& it : make_cases()) {
        INFO(it.name);
        const Vec6 resultants = random.matrix<6, 1>();
        Mat9 expected;
        for (int unknown = 0; unknown < 9; ++unknown) {
            expected.col(unknown) = differentiate([&](double amount) {
                const auto gradient = compute_strain_gradient(move(it.fields, unknown, amount), it.history);
                return Vec9(gradient.transpose() * resultants);
            });
        }
        const Mat9 hessian = compute_geometric_hessian(it.fields, it.history, resultants);
        CHECK(relative_difference(hessian, expected) < 1e-10);
        CHECK(relative_difference(hessian, hessian.transpose()) < 1e-15);
    }
}
