// Strains that neither rigid rotations nor the path change, from curved and twisted stress-free shapes too.
#include "elements/rod/objective_map.hpp"

#include "elements/element_samples.hpp"
#include "elements/rigid_body.hpp"
#include "elements/rod/rod_run.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Quat axes = RandomValues(51).rotation();
constexpr double length = 2.0;

Quat make_triad(const Vec3& x, const Vec3& y) {
    Mat3 columns;
    columns << x, y, x.cross(y);
    return Quat(columns);
}

// Of radius 1, in a plane.
Placement arc(double s) {
    return {axes * Vec3(std::sin(s), 1.0 - std::cos(s), 0.0), axes * exp_quaternion(s * Vec3::UnitZ())};
}

// Of radius 0.5 with a rise of 0.3 a radian; section axes radial.
Placement helix(double s) {
    const double t = s / std::hypot(0.5, 0.3);
    const Vec3 out(std::cos(t), std::sin(t), 0.0);
    const Vec3 tangent = Vec3(-0.5 * out.y(), 0.5 * out.x(), 0.3).normalized();
    return {axes * Vec3(0.5 * out.x(), 0.5 * out.y(), 0.3 * t), axes * make_triad(tangent, -out)};
}

Placement pre_twisted(double s) {
    return {axes * Vec3(s, 0.0, 0.0), axes * exp_quaternion(0.7 * s * Vec3::UnitX())};
}

const std::vector<std::pair<std::string, Line>> lines{
    {"arc", arc}, {"helix", helix}, {"pre-twisted line", pre_twisted}};

template <class E>
RodRun<E> make_run(const Line& line) {
    return {line, length, 3, {"tube", RandomValues(52).positive_definite<6>(), Mat6::Identity()}};
}

template <class E>
void check_free_of_force(const RodRun<E>& run) {
    for (const Vec6& force : run.compute_forces()) CHECK(force.norm() < 1e-13);
    for (int e = 0; e < run.piece_count(); ++e) {
        CHECK(run.values(e).strain.norm() < 1e-14);
        CHECK(run.values(e).curvature.norm() < 1e-14);
    }
}

template <class E>
void turn_all(RodRun<E>& run, const std::vector<NodeMotion>& from, const Quat& turn, const Vec3& shift) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        run.place_node(static_cast<int>(i), turn * from[i].r + shift, turn * from[i].Lambda);
    }
}

// Every node some way off its reference, within what one step of any element can take.
template <class E>
void deform(RodRun<E>& run, RandomValues& random) {
    for (std::size_t i = 0; i < run.motions.size(); ++i) {
        run.place_node(static_cast<int>(i),
                       run.previous[i].r + random.vector(0.1),
                       exp_quaternion(random.vector(0.3)) * run.previous[i].Lambda);
    }
}

}  // namespace

TEST_CASE("curved and twisted references are free of force, wherever they are moved", "[elements][rod]") {
    for_each_rod([]<class E>(std::type_identity<E>) {
        for (const auto& [name, line] : lines) {
            INFO(name_of_rod<E>() << ", " << name);
            RodRun<E> run = make_run<E>(line);
            check_free_of_force(run);
            const auto reference = run.motions;
            RandomValues random(53);
            Quat turn = Quat::Identity();
            for (const double angle : {1e-6, 0.4, 1.7, 3.0, 3.1}) {
                turn = exp_quaternion(angle * random.direction()) * turn;
                turn_all(run, reference, turn, random.vector(5.0));
                check_free_of_force(run);
                run.commit();
                check_free_of_force(run);
            }
        }
    });
}

TEST_CASE("a rotation on top of a deformation turns forces and leaves strains", "[elements][rod]") {
    for_each_order<ObjectiveElement>([]<class E>(std::type_identity<E>) {
        for (const auto& [name, line] : lines) {
            INFO(name_of_rod<E>() << ", " << name);
            RodRun<E> run = make_run<E>(line);
            RandomValues random(54);
            deform(run, random);
            const auto deformed = run.motions;
            const RodRun<E> before = run;
            const std::vector<Vec6> forces = before.compute_forces();
            for (const double angle : {1e-4, 0.5, 2.0, 3.1, 6.0, 40.0}) {
                const Quat turn = exp_quaternion(angle * random.direction());
                turn_all(run, deformed, turn, random.vector());
                const std::vector<Vec6> turned = run.compute_forces();
                for (std::size_t i = 0; i < forces.size(); ++i) {
                    CHECK((turned[i].head<3>() - turn * Vec3(forces[i].head<3>())).norm() < 1e-13);
                    CHECK((turned[i].tail<3>() - turn * Vec3(forces[i].tail<3>())).norm() < 1e-13);
                }
                for (int e = 0; e < run.piece_count(); ++e) {
                    CHECK((run.values(e).strain - before.values(e).strain).norm() < 1e-14);
                    CHECK((run.values(e).curvature - before.values(e).curvature).norm() < 1e-14);
                }
            }
        }
    });
}

TEST_CASE("strains depend on where the nodes are, not on how they came there", "[elements][rod]") {
    for_each_order<ObjectiveElement>([]<class E>(std::type_identity<E>) {
        for (const auto& [name, line] : lines) {
            INFO(name_of_rod<E>() << ", " << name);
            RodRun<E> at_once = make_run<E>(line);
            RandomValues random(55);
            deform(at_once, random);
            RodRun<E> in_steps = make_run<E>(line);
            for (const unsigned seed : {1U, 2U, 3U}) {
                RandomValues detour(seed);
                deform(in_steps, detour);
                in_steps.commit();
            }
            for (std::size_t i = 0; i < at_once.motions.size(); ++i) {
                in_steps.place_node(static_cast<int>(i), at_once.motions[i].r, at_once.motions[i].Lambda);
            }
            const std::vector<Vec6> forces = at_once.compute_forces();
            const std::vector<Vec6> same = in_steps.compute_forces();
            for (std::size_t i = 0; i < forces.size(); ++i) CHECK((forces[i] - same[i]).norm() < 1e-13);
        }
    });
}

TEST_CASE("a tangent in spins is symmetric but for half the moments out of balance", "[elements][rod]") {
    // Spins do not commute: K − Kᵀ = −[m_I]× on the diagonal, m_I the moment at node I, for every force that
    // is the gradient of an energy. Where moments balance the assembled tangent is symmetric.
    for_each_sample([]<Element E>(const ElementSample<E>& sample) {
        if constexpr (E::has_section) {
            INFO(sample.name);
            NodeLinearization placement;
            placement.placement = 1.0;
            Linearizations<E::node_count> linearizations;
            linearizations.fill(&placement);
            NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
            sample.element.add_internal_tangent(
                sample.point_at(sample.motions), sample.histories, linearizations, tangent);
            const auto force = sample.internal_force(sample.motions);
            NodalMatrix<E::node_count> skew = tangent - tangent.transpose();
            const double size = skew.norm();
            for (int i = 0; i < E::node_count; ++i) {
                skew.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
                    spin(Vec3(force.template segment<3>(6 * i + 3)));
            }
            CHECK(size > 1e-2 * tangent.norm());
            CHECK(skew.norm() < 1e-13 * tangent.norm());
        }
    });
}

TEST_CASE("the largest relative rotation is that between middle nodes or of a node and the triad",
          "[elements][rod]") {
    const Line line = [](double s) { return Placement{Vec3(s, 0.0, 0.0), Quat::Identity()}; };
    const auto check = [&]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        RodRun<E> run(line, 1.0, 1, {"tube", Mat6::Identity(), Mat6::Identity()});
        CHECK(run.elements[0].largest_relative_rotation(run.motions_of(0)) == 0.0);
        constexpr double turn = 1.2;
        run.strain(Vec3::Zero(), turn * Vec3::UnitY(), Quat::Identity());
        const double to_triad = 0.5 * turn;
        const double between =
            turn * (run.arc_length[E::node_count / 2] - run.arc_length[(E::node_count - 1) / 2]);
        CHECK(run.elements[0].largest_relative_rotation(run.motions_of(0)) ==
              Approx(std::max(E::node_count > 2 ? to_triad : 0.0, between)).epsilon(1e-13));
    };
    for_each_order<ObjectiveElement>(check);
    // None is interpolated.
    RodRun<SimoElement<2>> run(line, 1.0, 1, {"tube", Mat6::Identity(), Mat6::Identity()});
    CHECK(run.elements[0].largest_relative_rotation(run.motions_of(0)) == 0.0);
    const NodeMotion motion;
    CHECK(RigidBody(Body{}).largest_relative_rotation({&motion}) == 0.0);
}
