
#include "elements/element_samples.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

template <class Sample>
PointValues values_at(const Sample& sample, const typename Sample::Nodal& nodal, double xi) {
    const typename Sample::Force none = Sample::Force::Zero();
    return sample.element.point_values(Sample::point_at(nodal), sample.histories, none, xi);
}

// The nodes a time t later, at constant rates.
template <class Nodal>
Nodal advance(Nodal nodal, double t) {
    for (NodeMotion& node : nodal) {
        node.r += t * node.v + 0.5 * t * t * node.a;
        node.v += t * node.a;
        node.Lambda = exp_quaternion(t * node.omega) * node.Lambda;
    }
    return nodal;
}

template <class Check>
void for_each_rod_sample(Check&& check) {
    for_each_sample([&](const auto& sample) {
        if constexpr (std::remove_cvref_t<decltype(sample.element)>::has_section) check(sample);
    });
}

}  // namespace

TEST_CASE("a point at a node moves as the node", "[elements]") {
    for_each_rod_sample([](const auto& sample) {
        INFO(sample.name);
        constexpr int nodes = std::remove_cvref_t<decltype(sample)>::node_count;
        for (int i = 0; i < nodes; ++i) {
            const PointValues point = values_at(sample, sample.motions, compute_node_positions<nodes>()[i]);
            CHECK((point.motion.r - sample.motions[i].r).norm() < 1e-14);
            CHECK((point.motion.v - sample.motions[i].v).norm() < 1e-14);
            CHECK((point.motion.a - sample.motions[i].a).norm() < 1e-13);
            CHECK((point.motion.omega - sample.motions[i].omega).norm() < 1e-13);
            CHECK(point.motion.Lambda.angularDistance(sample.motions[i].Lambda) < 1e-7);
        }
    });
}

TEST_CASE("rates between the nodes are those of where the point goes", "[elements]") {
    for_each_rod_sample([](const auto& sample) {
        INFO(sample.name);
        constexpr double h = 1e-5;
        for (const double xi : {-0.83, -0.2, 0.1, 0.6}) {
            const PointValues now = values_at(sample, sample.motions, xi);
            const PointValues after = values_at(sample, advance(sample.motions, h), xi);
            const PointValues before = values_at(sample, advance(sample.motions, -h), xi);
            const Vec3 v = (after.motion.r - before.motion.r) / (2.0 * h);
            const Vec3 a = (after.motion.v - before.motion.v) / (2.0 * h);
            const Vec3 omega = log(after.motion.Lambda * before.motion.Lambda.conjugate()) / (2.0 * h);
            CHECK((now.motion.v - v).norm() < 1e-8);
            CHECK((now.motion.a - a).norm() < 1e-8);
            CHECK((now.motion.omega - omega).norm() < 1e-8);
        }
    });
}

TEST_CASE("a point between the nodes goes with a rigid motion", "[elements]") {
    const Quat turn = exp_quaternion({0.7, -1.9, 0.4});
    const Vec3 shift(3.0, -2.0, 5.0);
    for_each_rod_sample([&](const auto& sample) {
        INFO(sample.name);
        auto moved = sample.motions;
        for (NodeMotion& node : moved) {
            node.r = turn * node.r + shift;
            node.Lambda = turn * node.Lambda;
        }
        const PointValues before = values_at(sample, sample.motions, 0.37);
        const PointValues after = values_at(sample, moved, 0.37);
        CHECK((after.motion.r - turn * before.motion.r - shift).norm() < 1e-13);
        CHECK(after.motion.Lambda.angularDistance(turn * before.motion.Lambda) < 1e-7);
        CHECK((after.triad.coeffs() - before.triad.coeffs()).norm() == 0.0);
    });
}

TEST_CASE("at force points, strains of damped rods are those of the motion", "[elements]") {
    for_each_rod_sample([](const auto& sample) {
        INFO(sample.name);
        constexpr int nodes = std::remove_cvref_t<decltype(sample)>::node_count;
        constexpr int points = nodes - 1;
        REQUIRE(sample.element.is_damped());
        // Values of the middle are those of the point there, or the mean of the two next to it.
        const SectionValues middle =
            sample.element.section_values(sample.point_at(sample.motions), sample.histories);
        const auto rule = compute_gauss_rule<points>();
        const PointValues left = values_at(sample, sample.motions, rule[(points - 1) / 2].xi);
        const PointValues right = values_at(sample, sample.motions, rule[points / 2].xi);
        CHECK((0.5 * (left.strain + right.strain) - middle.strain).norm() < 1e-13);
        CHECK((0.5 * (left.curvature + right.curvature) - middle.curvature).norm() < 1e-13);
    });
}
