#include "elements/rod/tendon_force.hpp"

#include <vector>

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

struct Case {
    TendonPull pull;
    Vec6 strain;  // total
};

// Tendons beside a rod whose strains are of the size of 1, under tension and under pressure.
std::vector<Case> make_cases() {
    RandomValues random(67);
    std::vector<Case> cases;
    for (int i = 0; i < 6; ++i) {
        const Vec3 at(0.0, random.number(-0.4, 0.4), random.number(-0.4, 0.4));
        const Vec3 slope(0.0, random.number(-0.5, 0.5), random.number(-0.5, 0.5));
        Vec6 strain = random.matrix<6, 1>();
        strain[0] += 1.5;
        cases.push_back({{random.number(-3.0, 3.0), at, slope}, strain});
    }
    return cases;
}

double potential(const TendonPull& pull, const Vec6& strain) {
    return pull.tension * compute_tendon_stretch(pull, strain);
}

Vec6 resultants_of(const TendonPull& pull, const Vec6& strain) {
    Vec6 resultants = Vec6::Zero();
    add_pull(pull, strain, resultants, nullptr);
    return resultants;
}

}  // namespace

TEST_CASE("a tendon's stretch is that of the curve on which it lies", "[elements][rod]") {
    // Near a section at s = 0 whose axes are those of space, a rod of the strains (Γ, K) has its centreline
    // at s Γ and its axes turned by exp(s K), to first order; the tendon is at s Γ + exp(s K) (d + s d′).
    for (const Case& it : make_cases()) {
        const auto place = [&](double s) {
            const Vec3 d = it.pull.at + s * it.pull.slope;
            return Vec3(s * it.strain.head<3>() + exp_quaternion(s * it.strain.tail<3>()) * d);
        };
        CHECK(relative_difference(compute_tendon_stretch(it.pull, it.strain), differentiate(place).norm()) <
              1e-11);
    }
}

TEST_CASE("a tendon's resultants and their tangent are derivatives of its potential", "[elements][rod]") {
    for (const Case& it : make_cases()) {
        Vec6 gradient;
        Mat6 hessian;
        for (int i = 0; i < 6; ++i) {
            const Vec6 direction = Vec6::Unit(i);
            gradient[i] =
                differentiate([&](double x) { return potential(it.pull, it.strain + x * direction); });
            hessian.col(i) =
                differentiate([&](double x) { return resultants_of(it.pull, it.strain + x * direction); });
        }
        Vec6 resultants = Vec6::Zero();
        Mat6 tangent = Mat6::Zero();
        add_pull(it.pull, it.strain, resultants, &tangent);
        CHECK(relative_difference(resultants, gradient) < 1e-9);
        CHECK(relative_difference(tangent, hessian) < 1e-9);
        CHECK(relative_difference(tangent, tangent.transpose()) < 1e-15);
    }
}

TEST_CASE("tendons add up, and their pull does not depend on the section's axes", "[elements][rod]") {
    const std::vector<Case> cases = make_cases();
    const Vec6& strain = cases[0].strain;
    const Quat turn = RandomValues(5).rotation();
    Mat6 both = Mat6::Zero();
    both.topLeftCorner<3, 3>() = both.bottomRightCorner<3, 3>() = turn.toRotationMatrix();
    Vec6 sum = Vec6::Zero();
    Vec6 expected = Vec6::Zero();
    Mat6 tangent = Mat6::Zero();
    Mat6 turned = Mat6::Zero();
    Vec6 ignored = Vec6::Zero();
    for (const Case& it : cases) {
        add_pull(it.pull, strain, sum, &tangent);
        expected += resultants_of(it.pull, strain);
        const TendonPull moved{it.pull.tension, turn * it.pull.at, turn * it.pull.slope};
        add_pull(moved, both * strain, ignored, &turned);
        CHECK(relative_difference(resultants_of(moved, both * strain),
                                  both * resultants_of(it.pull, strain)) < 1e-14);
    }
    CHECK(relative_difference(sum, expected) < 1e-14);
    CHECK(relative_difference(turned, both * tangent * both.transpose()) < 1e-14);
}

TEST_CASE("where a tendon has no length it does nothing", "[elements][rod]") {
    Vec6 resultants = Vec6::Ones();
    Mat6 tangent = Mat6::Ones();
    const Vec6 crushed = Vec6::Zero();
    add_pull({2.0, Vec3(0.0, 0.1, 0.0), Vec3::Zero()}, crushed, resultants, &tangent);
    CHECK(resultants == Vec6::Ones());
    CHECK(tangent == Mat6::Ones());
}
