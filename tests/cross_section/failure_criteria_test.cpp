#include "cross_section/failure_criteria.hpp"

#include <cmath>
#include <string>

#include "cross_section/stress_measures.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

ElasticMaterial make_ply() {
    ElasticMaterial ply{.name = "carbon"};
    ply.strength = PlyStrength{.Xt = 1500, .Xc = 1200, .Yt = 40, .Yc = 200, .S12 = 70, .S23 = 50};
    return ply;
}

Vec6 stress_of(double s1, double s2, double s3, double t23, double t13, double t12) {
    Vec6 stress;
    stress << s1, s2, s3, t23, t13, t12;
    return stress;
}

FailureModes find(const char* word, const Vec6& stress) {
    return find_failure_criterion(word)->find_modes(stress, make_ply());
}

// Rounded to nine decimals.
Approx nine_digits(double value) { return Approx(value).epsilon(0.0).margin(5.0001e-10); }

const Vec6 pulled = stress_of(500, 20, 0, 0, 0, 30);
const Vec6 pressed = stress_of(-600, -80, 0, 0, 0, 40);

}  // namespace

TEST_CASE("Tsai and Wu's criterion has the reference values", "[cross_section]") {
    const FailureMode first = find("tsai-wu", pulled).governing();
    CHECK(first.index() == nine_digits(0.605895692));
    CHECK(1.0 / first.exposure() == nine_digits(1.390904503));
    CHECK(first.word == "matrix");
    const FailureMode second = find("tsai-wu", pressed).governing();
    CHECK(second.index() == nine_digits(-0.573469388));
    CHECK(1.0 / second.exposure() == nine_digits(2.126490365));
    CHECK(find("tsai-wu", stress_of(0, 0, 0, 0, 10, 30)).governing().word == "shear");
    CHECK(find("tsai-wu", stress_of(1500, 0, 0, 0, 0, 0)).governing().word == "fibre");
}

TEST_CASE("Hashin's criterion has the reference values", "[cross_section]") {
    const FailureModes first = find("hashin", pulled);
    REQUIRE(first.count == 2);
    CHECK(first.modes[0].word == "fibre tension");
    CHECK(first.modes[0].index() == nine_digits(0.294784580));
    CHECK(1.0 / first.modes[0].exposure() == nine_digits(1.841821841));
    CHECK(first.modes[1].word == "matrix tension");
    CHECK(first.modes[1].index() == nine_digits(0.433673469));
    CHECK(1.0 / first.modes[1].exposure() == nine_digits(1.518513205));
    CHECK(first.governing().word == "matrix tension");
    const FailureModes second = find("hashin", pressed);
    CHECK(second.modes[0].word == "fibre compression");
    CHECK(second.modes[0].index() == Approx(0.25).epsilon(1e-14));
    CHECK(1.0 / second.modes[0].exposure() == Approx(2.0).epsilon(1e-14));
    CHECK(second.modes[1].word == "matrix compression");
    CHECK(second.modes[1].index() == nine_digits(-0.233469388));
    CHECK(1.0 / second.modes[1].exposure() == nine_digits(1.812411407));
}

TEST_CASE("Uniaxial strengths are reached at exposure one", "[cross_section]") {
    const struct {
        int component;
        double strength;
        const char* word;
    } cases[] = {{0, 1500, "fibre tension"},
                 {0, -1200, "fibre compression"},
                 {1, 40, "matrix tension 2"},
                 {1, -200, "matrix compression 2"},
                 {2, 40, "matrix tension 3"},
                 {2, -200, "matrix compression 3"},
                 {3, 50, "shear 23"},
                 {4, 70, "shear 13"},
                 {5, -70, "shear 12"}};
    for (const auto& [component, strength, word] : cases) {
        const Vec6 stress = strength * Vec6::Unit(component);
        CAPTURE(component, strength);
        const FailureMode governing = find("max-stress", stress).governing();
        CHECK(governing.exposure() == Approx(1.0).epsilon(1e-14));
        CHECK(governing.word == word);
        CHECK(find("tsai-wu", stress).governing().exposure() == Approx(1.0).epsilon(1e-14));
        CHECK(find("hashin", stress).governing().exposure() == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("At the load times the reserve each criterion is met", "[cross_section]") {
    RandomValues random(7);
    ElasticMaterial ply = make_ply();
    ply.yield_stress = 300.0;
    for (int i = 0; i < 200; ++i) {
        const Vec6 stress = 100.0 * random.matrix<6, 1>();
        for (const FailureCriterion& criterion : failure_criteria()) {
            const double exposure = criterion.find_modes(stress, ply).governing().exposure();
            if (exposure == 0.0) continue;
            CAPTURE(std::string(criterion.word), stress.transpose());
            CHECK(criterion.find_modes(stress / exposure, ply).governing().index() ==
                  Approx(1.0).epsilon(1e-11));
            CHECK(criterion.find_modes(2.5 * stress, ply).governing().exposure() ==
                  Approx(2.5 * exposure).epsilon(1e-12));
        }
    }
}

TEST_CASE("Tsai and Wu's and Hashin's criteria do not change if the ply turns about its fibres",
          "[cross_section]") {
    RandomValues random(11);
    for (int i = 0; i < 50; ++i) {
        const Vec6 stress = 100.0 * random.matrix<6, 1>();
        // With the fibres along x, a wall turned by an angle has axes 2 and 3 turned by it.
        const double angle = random.number(0.0, 6.0);
        const Vec6 turned = turn_stress_to_ply(stress, 0.0, {std::cos(angle), std::sin(angle)});
        for (const char* word : {"tsai-wu", "hashin"}) {
            CHECK(find(word, turned).governing().index() ==
                  Approx(find(word, stress).governing().index()).epsilon(1e-11));
        }
    }
}

TEST_CASE("A mode that no load reaches has no exposure", "[cross_section]") {
    CHECK(FailureMode{.word = "", .linear = -1.0, .quadratic = 0.0}.exposure() == 0.0);
    CHECK(FailureMode{.word = "", .linear = 0.1, .quadratic = -1.0}.exposure() == 0.0);
    CHECK(FailureMode{.word = "", .linear = 0.0, .quadratic = 0.0}.exposure() == 0.0);
}

TEST_CASE("A criterion is chosen by what the material has", "[cross_section]") {
    const FailureCriterion* hashin = find_failure_criterion("hashin");
    ElasticMaterial steel{.name = "steel"};
    CHECK(choose_failure_criterion(hashin, make_ply()) == hashin);
    CHECK(choose_failure_criterion(hashin, steel) == nullptr);
    steel.yield_stress = 235.0;
    CHECK(choose_failure_criterion(hashin, steel)->word == "von-mises");
    CHECK(choose_failure_criterion(nullptr, make_ply()) == nullptr);
    CHECK(find_failure_criterion("puck") == nullptr);
    const FailureModes modes =
        find_failure_criterion("von-mises")->find_modes(stress_of(0, 0, 0, 0, 47, 0), steel);
    CHECK(modes.governing().exposure() == Approx(std::sqrt(3.0) * 0.2));
}

TEST_CASE("Principal stresses and von Mises' stress do not depend on axes", "[cross_section]") {
    RandomValues random(3);
    for (int i = 0; i < 50; ++i) {
        const Vec3 principal = stress_of(5, 3, -2, 0, 0, 0).head<3>() + random.vector();
        const Mat3 R = random.rotation().toRotationMatrix();
        const Mat3 tensor = R * principal.asDiagonal() * R.transpose();
        const Vec6 stress =
            stress_of(tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(1, 2), tensor(0, 2), tensor(0, 1));
        CHECK((compute_principal_stresses(stress) - principal).norm() < 1e-13);
        CHECK(compute_von_mises(stress) ==
              Approx(compute_von_mises(stress_of(principal[0], principal[1], principal[2], 0, 0, 0)))
                  .epsilon(1e-13));
    }
    CHECK(compute_von_mises(stress_of(3, 0, 0, 0, 0, 0)) == 3.0);
    CHECK(compute_von_mises(stress_of(0, 0, 0, 1, 0, 0)) == Approx(std::sqrt(3.0)).epsilon(1e-15));
}
