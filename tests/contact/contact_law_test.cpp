#include "contact/contact_law.hpp"

#include <cmath>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const ContactLaw law{0.02, 30.0};

// f′ by central differences, extrapolated.
template <class Function>
double differentiate(const Function& f, double x, double h) {
    const auto central = [&](double step) { return (f(x + step) - f(x - step)) / (2.0 * step); };
    return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}

}  // namespace

TEST_CASE("The contact law is what its formulas say", "[contact]") {
    // By hand, at x = 1/2: λ = κ/2, V = κ ĝ (ln 2 − 1 + 3/8), λ′ = −3 κ/ĝ.
    CHECK(compute_contact_force(law, 0.01) == Approx(15.0).epsilon(1e-15));
    CHECK(compute_contact_energy(law, 0.01) == Approx(30.0 * 0.02 * (std::log(2.0) - 0.625)).epsilon(1e-14));
    CHECK(compute_contact_force_slope(law, 0.01) == Approx(-3.0 * 30.0 / 0.02).epsilon(1e-15));
    for (const double gap : {0.02, 0.03, 1e9}) {
        CHECK(compute_contact_force(law, gap) == 0.0);
        CHECK(compute_contact_force_slope(law, gap) == 0.0);
        CHECK(compute_contact_energy(law, gap) == 0.0);
    }
}

TEST_CASE("The contact law's force and slope are derivatives of its energy", "[contact]") {
    for (const double x : {1e-6, 1e-3, 0.1, 0.249, 0.251, 0.5, 0.749, 0.751, 0.9}) {
        INFO(x);
        const double gap = x * law.skin, h = 1e-3 * std::min(gap, law.skin - gap);
        const auto energy = [](double g) { return compute_contact_energy(law, g); };
        const auto force = [](double g) { return compute_contact_force(law, g); };
        CHECK(-differentiate(energy, gap, h) == Approx(compute_contact_force(law, gap)).epsilon(1e-9));
        CHECK(differentiate(force, gap, h) == Approx(compute_contact_force_slope(law, gap)).epsilon(1e-9));
    }
}

TEST_CASE("Energies of contact keep their digits near both ends", "[contact]") {
    // Of e = 1 − x by long doubles: Σ e^k/k.
    for (const double e : {1e-9, 1e-4, 0.1, 0.24, 0.26, 0.5, 0.74, 0.76}) {
        INFO(e);
        const double gap = law.skin * (1.0 - e);
        const long double depth = 1.0L - static_cast<long double>(gap) / law.skin;
        long double sum = 0.0L, power = depth * depth;
        for (int k = 3; k < 400; ++k) sum += (power *= depth) / k;
        CHECK(compute_contact_energy(law, gap) ==
              Approx(30.0 * 0.02 * static_cast<double>(sum)).epsilon(e > 0.05 ? 1e-13 : 1e-6));
    }
    CHECK(compute_contact_energy(law, 0.02e-200) ==
          Approx(0.6 * (200.0 * std::log(10.0) - 1.5)).epsilon(1e-14));
}

TEST_CASE("The graph of the contact law lies on the law", "[contact]") {
    for (const double x : {1e-8, 0.01, 0.3, 0.5, 0.99, 1.0, 1.01, 5.0}) {
        INFO(x);
        const double gap = x * law.skin, zeta = compute_contact_force(law, gap) / law.stiffness - x;
        const ContactGraphPoint point = find_contact_point(law, zeta);
        const double force = compute_contact_force(law, gap);
        CHECK(point.gap == Approx(gap).epsilon(1e-14));
        CHECK(point.force == Approx(force).epsilon(1e-13).margin(1e-20));
        CHECK(point.stiffness == Approx(-compute_contact_force_slope(law, gap)).epsilon(1e-13).margin(1e-20));
    }
    // Both are smooth in ζ with slopes of at most 1: along the curve, D is their quotient.
    for (const double zeta : {-3.0, -0.9, 0.0, 0.7, 40.0}) {
        INFO(zeta);
        const double dgap =
            differentiate([](double z) { return find_contact_point(law, z).gap; }, zeta, 1e-3) / law.skin;
        const double dforce =
            differentiate([](double z) { return find_contact_point(law, z).force; }, zeta, 1e-3) /
            law.stiffness;
        CHECK(dforce - dgap == Approx(1.0).epsilon(1e-10));
        CHECK(find_contact_point(law, zeta).stiffness ==
              Approx(-dforce / dgap * law.stiffness / law.skin).epsilon(1e-9).margin(1e-9));
    }
}

TEST_CASE("The contact law: a linear solution moves along the graph", "[contact]") {
    const double zeta = 0.7;
    const ContactGraphPoint point = find_contact_point(law, zeta);
    // Far from its gap the force is on the tangent of the graph, and pulls.
    const ContactGraphPoint far = continue_contact(law, zeta, 5.0 * law.skin);
    CHECK(far.stiffness == point.stiffness);
    CHECK(far.force == Approx(point.force - point.stiffness * (5.0 * law.skin - point.gap)).epsilon(1e-14));
    CHECK(far.force < 0.0);
    // A solution that leads to the point itself stays there, one that leads away from contact leaves it.
    CHECK(advance_contact(law, zeta, 5.0 * law.skin, point.gap - 5.0 * law.skin) ==
          Approx(zeta).epsilon(1e-12));
    CHECK(advance_contact(law, zeta, 5.0 * law.skin, 0.0) == no_contact);
    // A plane that a weight w presses on: the linear solution has the force w, and from then on the graph's
    // point is that of w, whatever it was before.
    const double weight = 20.0;
    double found = 9.0, gap = 5.0 * law.skin;
    for (int k = 0; k < 12; ++k) {
        const ContactGraphPoint at = continue_contact(law, found, gap);
        const double change = (at.force - weight) / at.stiffness;
        found = advance_contact(law, found, gap, change);
    }
    CHECK(find_contact_point(law, found).force == Approx(weight).epsilon(1e-12));
}

TEST_CASE("The contact law: predictions stop at half the skin, or where they touched", "[contact]") {
    const double skin = 0.02;
    CHECK(find_predicted_share(skin, 0.3 * skin) == 0.9);
    CHECK(find_predicted_share(skin, 2.0 * skin) == Approx(0.25));
    CHECK(find_predicted_share(skin, 100.0 * skin) == 0.1);
}

TEST_CASE("The contact law: nothing comes nearer than rounding could close", "[contact]") {
    CHECK(keep_from_rounding(0.3, 0.02, 1e-3) == 0.3);
    CHECK(keep_from_rounding(0.3, 0.02, 1e-9) == 0.0);
    CHECK(keep_from_rounding(1.0, 0.02, 1e-9) == 1.0);
}

TEST_CASE("The contact law: an increment multiplies the force of a pair by ten at most", "[contact]") {
    const double skin = 0.02;
    const auto force = [](double x) { return std::pow(1.0 - x, 3) / (x * x); };
    for (const double x : {0.05, 0.3, 0.6, 0.8, 0.95}) {
        INFO(x);
        const double share = find_kept_share(skin, x * skin);
        CHECK(share >= 0.1);
        CHECK(share < 1.0);
        CHECK(force(share * x) <= std::max(10.0 * force(x), 1e-3) * 1.0001);
        // And not much less, unless the gap is a tenth.
        CHECK((share < 0.1001 || force(share * x) > 0.95 * std::max(10.0 * force(x), 1e-3)));
    }
    // From outside it goes into the skin, where forces are small.
    const double x = find_kept_share(skin, 5.0 * skin) * 5.0;
    CHECK(force(x) == Approx(1e-3).epsilon(0.02));
    CHECK(find_kept_share(skin, 1e3 * skin) == 0.1);
}

}  // namespace gxrod::test
