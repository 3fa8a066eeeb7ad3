// Kelvin & Voigt's damping: resultants C (E + τ Ė), of the very strains that the element makes. And damping
// by the momenta.

#include "elements/element_samples.hpp"
#include "elements/rod/rod_run.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double delay = 0.3;  // τ

// An element whose nodes continue at their v and ω.
template <Element E>
struct MovingSample {
    ElementSample<E> sample;
    Section section;
    double length;

    explicit MovingSample(unsigned seed, double kelvin_voigt = delay, double mass_proportional = 0.0)
        : MovingSample(RandomValues(seed), kelvin_voigt, mass_proportional) {}

    typename ElementSample<E>::Nodal at(double t) const {
        auto nodal = sample.motions;
        for (int i = 0; i < E::node_count; ++i) {
            Vec6 rates;
            rates << nodal[i].v, nodal[i].omega;
            nodal[i] = move(sample.previous[i], nodal[i], rates, t);
        }
        return nodal;
    }
    SectionValues values_at(double t) const {
        const auto nodal = at(t);
        return sample.element.section_values(sample.point_at(nodal), sample.histories);
    }
    Vec6 strain_at(double t) const {
        const SectionValues values = values_at(t);
        Vec6 strain;
        strain << values.strain, values.curvature;
        return strain;
    }
    // By differences of nearby strains.
    Vec6 strain_rate() const {
        return differentiate([this](double t) { return strain_at(t); });
    }
    double power(const typename ElementSample<E>::Force& force) const {
        double sum = 0.0;
        for (int i = 0; i < E::node_count; ++i) {
            sum += force.template segment<3>(6 * i).dot(sample.motions[i].v) +
                   force.template segment<3>(6 * i + 3).dot(sample.motions[i].omega);
        }
        return sum;
    }

  private:
    MovingSample(RandomValues random, double kelvin_voigt, double mass_proportional)
        : MovingSample(random, make_piece(random, kelvin_voigt, mass_proportional)) {}
    MovingSample(RandomValues& random, const RodPiece<E::node_count>& piece)
        : sample{"", E(piece.geometry, piece.section), piece.geometry.positions, {}, {}, {}},
          section(piece.section),
          length((piece.geometry.positions.back() - piece.geometry.positions.front()).norm()) {
        const Quat turn = random.rotation();
        for (int i = 0; i < E::node_count; ++i) {
            NodeMotion& previous = sample.previous[i];
            previous.r = piece.geometry.positions[i] + random.vector(0.1);
            previous.Lambda = exp_quaternion(random.vector(0.3)) * turn;
            place(previous, previous.r + random.vector(0.1), random.vector(0.4), sample.motions[i]);
            sample.motions[i].v = random.vector();
            sample.motions[i].omega = random.vector();
        }
        for (int p = 0; p < E::history_count; ++p) {
            sample.histories.axes.push_back({random.rotation(), random.vector(0.5)});
        }
    }
    static RodPiece<E::node_count> make_piece(RandomValues& random,
                                              double kelvin_voigt,
                                              double mass_proportional) {
        RodPiece<E::node_count> piece = make_rod_piece<E::node_count>(random);
        piece.section.kelvin_voigt = kelvin_voigt;
        piece.section.mass_proportional = mass_proportional;
        return piece;
    }
};

}  // namespace

TEST_CASE("section resultants are C (E + tau dE/dt)", "[elements][rod]") {
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        const MovingSample<E> moving(71);
        const SectionValues values = moving.values_at(0.0);
        Vec6 resultants;
        resultants << values.force, values.moment;
        const Vec6 expected =
            moving.section.stiffness * (moving.strain_at(0.0) + delay * moving.strain_rate());
        CHECK(relative_difference(resultants, expected) < 1e-10);
        CHECK(relative_difference(moving.section.stiffness * moving.strain_at(0.0), expected) > 0.1);
    });
}

TEST_CASE("damping of a two-node element dissipates L tau dE/dt . C dE/dt", "[elements][rod]") {
    const auto check = []<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        for (const unsigned seed : {72U, 73U}) {
            const MovingSample<E> moving(seed);
            const Vec6 rate = moving.strain_rate();
            const double expected = moving.length * delay * rate.dot(moving.section.stiffness * rate);
            const double power = moving.power(moving.sample.damping_force(moving.sample.motions));
            CHECK(relative_difference(power, expected) < 1e-10);
        }
    };
    check(std::type_identity<ObjectiveElement<2>>());
    check(std::type_identity<SimoElement<2>>());
}

TEST_CASE("mass-proportional damping alone takes 2 c times the kinetic energy", "[elements][rod]") {
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        for (const double c : {0.02, 3.0}) {
            const MovingSample<E> moving(76, 0.0, c);
            const double power = moving.power(moving.sample.damping_force(moving.sample.motions));
            CHECK(power ==
                  Approx(2.0 * c * moving.sample.kinetic_energy(moving.sample.motions)).epsilon(1e-12));
        }
    });
}

TEST_CASE("rates of a constant strain are damped alike along a whole element", "[elements][rod]") {
    // A straight piece from its reference: v and ω that stretch, bend and twist at constant rates.
    for_each_rod([]<class E>(std::type_identity<E>) {
        INFO(name_of_rod<E>());
        constexpr double length = 1.5;
        const Line line = [](double s) { return Placement{Vec3(s, 0.0, 0.0), Quat::Identity()}; };
        Section section{"tube", RandomValues(74).positive_definite<6>(), Mat6::Identity()};
        section.kelvin_voigt = delay;
        RodRun<E> run(line, length, 1, section);
        const Vec6 rate = RandomValues(75).matrix<6, 1>();
        for (std::size_t i = 0; i < run.motions.size(); ++i) {
            const double s = run.arc_length[i];
            // dΓ = v′ + e₁ × ω, dK = ω′.
            run.motions[i].omega = s * rate.tail<3>();
            run.motions[i].v = s * rate.head<3>() - 0.5 * s * s * Vec3::UnitX().cross(Vec3(rate.tail<3>()));
        }
        NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
        run.elements[0].add_damping_force(run.motions_of(0), run.histories_of(0), force);
        double power = 0.0;
        for (int i = 0; i < E::node_count; ++i) {
            power += force.template segment<3>(6 * i).dot(run.motions[i].v) +
                     force.template segment<3>(6 * i + 3).dot(run.motions[i].omega);
        }
        // v is quadratic: two nodes with one point in the middle see its mean slope, which is as good.
        CHECK(relative_difference(power, length * delay * rate.dot(section.stiffness * rate)) < 1e-13);
    });
}
