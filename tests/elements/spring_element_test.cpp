// What is special to springs: the line between their points, the ground, springs without a length.

#include "elements/spring_element.hpp"

#include <cmath>

#include "elements/element_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr std::size_t spring_with_law = std::tuple_size_v<ElementSamples> - 2;

Spring make_plain_spring(double stiffness, double damping, double length) {
    Spring spring;
    spring.ends = {Anchor{0}, Anchor{1}};
    spring.stiffness = stiffness;
    spring.damping = damping;
    spring.length = length;
    return spring;
}

// A spring between two nodes, the one of `end` at rest at the origin, and one to the ground there.
struct Grounded {
    SpringElement<2> between;
    SpringElement<1> to_ground;
    std::array<NodeMotion, 2> motions;
    int free;

    Grounded(RandomValues random, int end)
        : Grounded(make_spring(random, {Vec3::Zero(), Vec3::UnitX()}), end) {
        motions[free].r = random.vector();
        motions[free].Lambda = random.rotation();
        motions[free].v = random.vector();
        motions[free].omega = random.vector();
    }

  private:
    Grounded(const Spring& spring, int end) : between(spring), to_ground(fix(spring, end)), free(1 - end) {}
    static Spring fix(Spring spring, int end) {
        spring.ends[end].node = -1;  // its node is at the origin, so that the arm is its place
        return spring;
    }
};

template <class E>
NodalMatrix<E::node_count> compute_tangent(const E& spring, const Motions<E::node_count>& motions) {
    RandomValues random(3);
    const NodeLinearization linearization{1.0, 1.7, 2.3, random.matrix<3>(), random.matrix<3>()};
    Linearizations<E::node_count> linearizations;
    linearizations.fill(&linearization);
    NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
    spring.add_internal_tangent(motions, {}, linearizations, tangent);
    spring.add_damping_tangent(motions, {}, linearizations, tangent);
    return tangent;
}

template <class E>
NodalVector<E::node_count> compute_force(const E& spring, const Motions<E::node_count>& motions) {
    NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
    spring.add_internal_force(motions, {}, force);
    spring.add_damping_force(motions, {}, force);
    return force;
}

}  // namespace

TEST_CASE("a spring pulls its points together along their line", "[elements]") {
    const SpringElement<2> spring(make_plain_spring(3.0, 0.5, 1.0));
    NodeMotion a, b;
    b.r = Vec3(0.0, 2.0, 0.0);
    b.v = Vec3(7.0, 4.0, 0.0);  // across the line nothing changes
    const Motions<2> motions{&a, &b};
    NodalVector<2> expected;
    expected << 0.0, -5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0;
    CHECK(compute_force(spring, motions) == expected);
    CHECK(spring.strain_energy(motions, {}) == 1.5);
}

TEST_CASE("the forces of a spring balance", "[elements]") {
    for (unsigned seed = 1; seed <= sample_seeds; ++seed) {
        const ElementSamples samples = make_samples(seed);
        const auto& sample = std::get<spring_with_law>(samples);
        const auto force = compute_force(sample.element, sample.point_at(sample.motions));
        Vec6 sum = Vec6::Zero();
        for (int i = 0; i < 2; ++i) {
            const Vec3 f = force.segment<3>(6 * i);
            sum.head<3>() += f;
            sum.tail<3>() += sample.motions[i].r.cross(f) + force.segment<3>(6 * i + 3);
        }
        CHECK(sum.norm() < 1e-14);
        CHECK(force.norm() > 0.01);
    }
}

TEST_CASE("a spring to the ground acts as one to a node at rest", "[elements]") {
    for (const int end : {0, 1}) {
        const Grounded sample(RandomValues(7), end);
        const Motions<2> both{&sample.motions[0], &sample.motions[1]};
        const Motions<1> one{&sample.motions[sample.free]};
        const int first = 6 * sample.free;
        CHECK(relative_difference(compute_force(sample.to_ground, one),
                                  compute_force(sample.between, both).segment<6>(first)) < 1e-15);
        CHECK(relative_difference(compute_tangent(sample.to_ground, one),
                                  compute_tangent(sample.between, both).block<6, 6>(first, first)) < 1e-15);
        CHECK(sample.to_ground.strain_energy(one, {}) ==
              Approx(sample.between.strain_energy(both, {})).epsilon(1e-15));
    }
}

TEST_CASE("a spring without a length of its own pulls in every direction alike", "[elements]") {
    const SpringElement<2> spring(make_plain_spring(3.0, 0.5, 0.0));
    NodeMotion a, b;
    const Motions<2> motions{&a, &b};
    CHECK(compute_force(spring, motions).isZero(0.0));
    const NodalMatrix<2> tangent = compute_tangent(spring, motions);
    CHECK(tangent.topLeftCorner<3, 3>() == Mat3(3.0 * Mat3::Identity()));
    b.r = Vec3(0.0, 0.0, 1e-200);
    CHECK(compute_force(spring, motions)[8] == Approx(3e-200));
}

TEST_CASE("where a spring with a length has none left its force is not a number", "[elements]") {
    const SpringElement<2> spring(make_plain_spring(3.0, 0.5, 1.0));
    NodeMotion a, b;
    CHECK(std::isnan(compute_force(spring, Motions<2>{&a, &b})[0]));
}

TEST_CASE("the energy of a law is exact across its kinks and jumps", "[elements]") {
    Spring spring = make_plain_spring(0.0, 0.0, 1.0);
    // Slack to 1.3, then as a spring; a jump at 2.
    const auto force = [](double length, double) {
        return (length > 1.3 ? 50.0 * (length - 1.3) : 0.0) + (length > 2.0 ? 7.0 : 0.0);
    };
    spring.law = std::make_shared<const SpringLaw>(force, false, 1.0);
    const SpringElement<2> element(spring);
    NodeMotion a, b;
    for (const double length : {0.4, 1.2, 1.7, 2.3}) {
        b.r = Vec3(0.0, length, 0.0);
        const double stretch = std::max(length - 1.3, 0.0);
        const double expected = 25.0 * stretch * stretch + 7.0 * std::max(length - 2.0, 0.0);
        CHECK(element.strain_energy(Motions<2>{&a, &b}, {}) == Approx(expected).epsilon(1e-12));
    }
    CHECK(!element.is_damped());
}

TEST_CASE("what a law damps in a step is its force at the mean rate times the change of length",
          "[elements]") {
    Spring spring = make_plain_spring(0.0, 0.0, 1.0);
    spring.law = std::make_shared<const SpringLaw>(
        [](double length, double rate) { return length + 3.0 * rate * std::abs(rate); }, true, 1.0);
    const SpringElement<2> element(spring);
    NodeMotion a, before, after;
    before.r = Vec3(1.0, 0.0, 0.0);
    before.v = Vec3(2.0, 0.0, 0.0);
    after.r = Vec3(1.5, 0.0, 0.0);
    after.v = Vec3(4.0, 0.0, 0.0);
    // Over the step, 0.5/3 long, it is 3 · 3² · 0.5.
    const double action = element.damping_action(Motions<2>{&a, &before}, Motions<2>{&a, &after}, {});
    CHECK(action / (0.5 / 3.0) == Approx(27.0 * 0.5));
    const Motions<2> turning{&a, &before};
    CHECK(element.damping_action(turning, turning, {}) == 0.0);
}
