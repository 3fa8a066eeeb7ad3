// Properties that every element has, checked for one of each kind: forces are gradients of energies, tangents
// are derivatives of forces, momenta and energies balance.

#include "elements/element_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences

// Calls visit(unknown, node, direction) for each unknown of the element.
template <int Nodes, class Visit>
void for_each_unknown(Visit&& visit) {
    for (int unknown = 0; unknown < 6 * Nodes; ++unknown)
        visit(unknown, unknown / 6, Vec6::Unit(unknown % 6));
}

// Force of an element whose node `node` is moved by `amount`, as the linearization says.
template <Element E, class Force>
auto differentiate_force(const ElementSample<E>& sample,
                         const NodeLinearization& linearization,
                         Force&& force) {
    typename ElementSample<E>::Tangent tangent;
    for_each_unknown<E::node_count>([&](int unknown, int node, const Vec6& direction) {
        tangent.col(unknown) = differentiate([&](double amount) {
            auto nodal = sample.motions;
            nodal[node] = follow(sample.previous[node], nodal[node], linearization, direction, amount);
            return force(nodal);
        });
    });
    return tangent;
}

template <Element E>
Linearizations<E::node_count> at_every_node(const ElementSample<E>&, const NodeLinearization& linearization) {
    Linearizations<E::node_count> pointers;
    pointers.fill(&linearization);
    return pointers;
}

template <Element E>
class SmoothElementMotion {
  public:
    explicit SmoothElementMotion(const ElementSample<E>& sample) {
        RandomValues random(5);
        for (const NodeMotion& motion : sample.motions) {
            paths_.push_back(
                {motion, random.vector(), random.vector(2.0), random.vector(2.0), random.vector()});
        }
    }
    typename ElementSample<E>::Nodal at(double t) const {
        typename ElementSample<E>::Nodal nodal;
        for (std::size_t i = 0; i < paths_.size(); ++i) nodal[i] = paths_[i].at(t);
        return nodal;
    }

  private:
    std::vector<SmoothMotion> paths_;
};

const Vec3 gravity(0.3, -1.1, -9.0);

}  // namespace

TEST_CASE("internal forces are the gradient of the strain energy", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        auto gradient = sample.internal_force(sample.motions);
        for_each_unknown<sample.node_count>([&](int unknown, int node, const Vec6& direction) {
            gradient[unknown] = differentiate([&](double amount) {
                auto nodal = sample.motions;
                nodal[node] = move(sample.previous[node], nodal[node], direction, amount);
                return sample.strain_energy(nodal);
            });
        });
        CHECK(relative_difference(sample.internal_force(sample.motions), gradient) < tolerance);
    });
}

TEST_CASE("internal tangents are derivatives of internal forces", "[elements]") {
    for_each_sample([](const auto& sample) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(sample.name << ", " << what);
            auto tangent = typename std::remove_cvref_t<decltype(sample)>::Tangent();
            tangent.setZero();
            sample.element.add_internal_tangent(sample.point_at(sample.motions),
                                                sample.histories,
                                                at_every_node(sample, linearization),
                                                tangent);
            const auto expected = differentiate_force(
                sample, linearization, [&](const auto& nodal) { return sample.internal_force(nodal); });
            CHECK(relative_difference(tangent, expected) < tolerance);
        }
    });
}

TEST_CASE("damping tangents are derivatives of damping forces", "[elements]") {
    for_each_sample([](const auto& sample) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(sample.name << ", " << what);
            auto tangent = typename std::remove_cvref_t<decltype(sample)>::Tangent();
            tangent.setZero();
            sample.element.add_damping_tangent(sample.point_at(sample.motions),
                                               sample.histories,
                                               at_every_node(sample, linearization),
                                               tangent);
            const auto expected = differentiate_force(
                sample, linearization, [&](const auto& nodal) { return sample.damping_force(nodal); });
            CHECK(relative_difference(tangent, expected) < tolerance);
        }
    });
}

TEST_CASE("damping takes power from every motion that strains, and mass-proportional from all",
          "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        if (!sample.element.is_damped()) return;
        RandomValues random(8);
        for (int trial = 0; trial < 20; ++trial) {
            auto nodal = sample.motions;
            for (NodeMotion& motion : nodal) {
                motion.v = random.vector();
                motion.omega = random.vector();
            }
            const auto force = sample.damping_force(nodal);
            double power = 0.0;
            for (int i = 0; i < sample.node_count; ++i) {
                power += force.template segment<3>(6 * i).dot(nodal[i].v) +
                         force.template segment<3>(6 * i + 3).dot(nodal[i].omega);
            }
            // Of the mass-proportional part, 0.09 × twice the kinetic energy.
            CHECK(power > 0.18 * sample.kinetic_energy(nodal));
        }
    });
}

TEST_CASE("inertial tangents are derivatives of inertial forces", "[elements]") {
    for_each_sample([](const auto& sample) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(sample.name << ", " << what);
            auto tangent = typename std::remove_cvref_t<decltype(sample)>::Tangent();
            tangent.setZero();
            sample.element.add_inertial_tangent(
                sample.point_at(sample.motions), gravity, at_every_node(sample, linearization), tangent);
            const auto expected = differentiate_force(sample, linearization, [&](const auto& nodal) {
                return sample.inertial_force(nodal, gravity);
            });
            CHECK(relative_difference(tangent, expected) < tolerance);
        }
    });
}

TEST_CASE("forces and tangents are added to what is there", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        using Sample = std::remove_cvref_t<decltype(sample)>;
        const NodeLinearization linearization = make_linearizations().back().second;
        const auto motions = sample.point_at(sample.motions);
        typename Sample::Force force = Sample::Force::Ones();
        sample.element.add_internal_force(motions, sample.histories, force);
        sample.element.add_inertial_force(motions, gravity, force);
        const typename Sample::Force expected = Sample::Force::Ones() +
                                                sample.internal_force(sample.motions) +
                                                sample.inertial_force(sample.motions, gravity);
        CHECK(relative_difference(force, expected) < 1e-14);
        typename Sample::Tangent first = Sample::Tangent::Zero();
        sample.element.add_internal_tangent(
            motions, sample.histories, at_every_node(sample, linearization), first);
        sample.element.add_inertial_tangent(motions, gravity, at_every_node(sample, linearization), first);
        typename Sample::Tangent twice = first;
        sample.element.add_internal_tangent(
            motions, sample.histories, at_every_node(sample, linearization), twice);
        sample.element.add_inertial_tangent(motions, gravity, at_every_node(sample, linearization), twice);
        CHECK(relative_difference(twice, 2.0 * first) < 1e-14);
    });
}

TEST_CASE("inertial forces do the work that changes the kinetic energy", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        const SmoothElementMotion path(sample);
        const auto now = path.at(0.0);
        const auto force = sample.inertial_force(now, Vec3::Zero());
        double power = 0.0;
        for (int i = 0; i < sample.node_count; ++i) {
            power += now[i].v.dot(force.template segment<3>(6 * i));
            power += now[i].omega.dot(force.template segment<3>(6 * i + 3));
        }
        const double expected = differentiate([&](double t) { return sample.kinetic_energy(path.at(t)); });
        CHECK(relative_difference(power, expected) < tolerance);
    });
}

TEST_CASE("inertial forces change linear and angular momentum", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        const SmoothElementMotion path(sample);
        const auto now = path.at(0.0);
        const auto force = sample.inertial_force(now, Vec3::Zero());
        Vec6 total = Vec6::Zero();
        for (int i = 0; i < sample.node_count; ++i) {
            const Vec3 f = force.template segment<3>(6 * i);
            const Vec3 m = force.template segment<3>(6 * i + 3);
            total.head<3>() += f;
            total.tail<3>() += now[i].r.cross(f) + m;
        }
        const Vec6 expected = differentiate([&](double t) {
            const Momentum momentum = sample.momentum(path.at(t));
            Vec6 stacked;
            stacked << momentum.linear, momentum.angular;
            return stacked;
        });
        CHECK(relative_difference(total, expected) < tolerance);
    });
}

TEST_CASE("kinetic energy and momenta of a rigid motion are those of one body", "[elements]") {
    // With v_I = v + ω × r_I and ω everywhere, T = ½ (v · P + ω · H).
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        auto nodal = sample.motions;
        const Vec3 v(0.4, -0.9, 1.3);
        const Vec3 omega(-0.7, 0.2, 1.1);
        for (NodeMotion& motion : nodal) {
            motion.v = v + omega.cross(motion.r);
            motion.omega = omega;
        }
        const Momentum momentum = sample.momentum(nodal);
        const double expected = 0.5 * (v.dot(momentum.linear) + omega.dot(momentum.angular));
        CHECK(relative_difference(sample.kinetic_energy(nodal), expected) < 1e-13);
    });
}

TEST_CASE("gravity pulls down the slope of its potential", "[elements]") {
    for_each_sample([](const auto& sample) {
        INFO(sample.name);
        auto gradient = sample.internal_force(sample.motions);
        for_each_unknown<sample.node_count>([&](int unknown, int node, const Vec6& direction) {
            gradient[unknown] = differentiate([&](double amount) {
                auto nodal = sample.motions;
                nodal[node] = move(sample.previous[node], nodal[node], direction, amount);
                return sample.element.gravity_potential(sample.point_at(nodal), gravity);
            });
        });
        const auto pull = (sample.inertial_force(sample.motions, gravity) -
                           sample.inertial_force(sample.motions, Vec3::Zero()))
                              .eval();
        CHECK(relative_difference(pull, gradient) < tolerance);
    });
}
