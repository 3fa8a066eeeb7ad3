#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "laws/law_path.hpp"
#include "laws/layered_law.hpp"
#include "laws/syrope_law.hpp"
#include "laws/trapeze_law.hpp"
#include "laws/viscoelastic_law.hpp"
#include "model/sections/kinked_law.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

// What holds of the law of every section, whatever it is.
namespace gxrod::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Vec6 random_strain(tools::RandomValues& random, const Vec6& scale) {
    return scale.cwiseProduct(random.matrix<6, 1>());
}

// A section that has been through some steps.
LawPath wander(const NamedLaw& named, tools::RandomValues& random) {
    LawPath path(*named.law);
    for (int i = 0; i < 6; ++i) path.go(random_strain(random, named.scale), random.number(0.01, 3.0));
    return path;
}

// By central differences of two widths: nullopt where they differ, as on a kink.
std::optional<Mat6> differentiate_law(const LawPath& path,
                                      const Vec6& strain,
                                      double elapsed,
                                      const Vec6& scale) {
    Mat6 tangent;
    for (int i = 0; i < 6; ++i) {
        const auto at = [&](double x) -> Vec6 {
            return path.look(strain + x * scale[i] * Vec6::Unit(i), elapsed).resultants;
        };
        const Vec6 wide = tools::differentiate(at, 4e-3) / scale[i];
        tangent.col(i) = tools::differentiate(at, 2e-3) / scale[i];
        if ((wide - tangent.col(i)).norm() > 1e-8 * tangent.col(i).norm() + 1e-12) return std::nullopt;
    }
    return tangent;
}

}  // namespace

TEST_CASE("The tangent of every law is the derivative of its resultants", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        INFO(named.name);
        tools::RandomValues random(11);
        int compared = 0;
        for (int i = 0; i < 60; ++i) {
            const LawPath path = wander(named, random);
            const double elapsed = i % 5 == 0 ? infinite : random.number(0.01, 3.0);
            const Vec6 strain = random_strain(random, named.scale);
            const std::optional<Mat6> difference = differentiate_law(path, strain, elapsed, named.scale);
            if (!difference) continue;
            ++compared;
            const Mat6 D = path.look(strain, elapsed).tangent;
            CHECK(tools::relative_difference(D, *difference) < 1e-7);
            if (named.is_symmetric) CHECK((D - D.transpose()).norm() < 1e-13 * D.norm());
        }
        CHECK(compared > 15);
    }
}

TEST_CASE("On the piece where it is a law responds as it does without one", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        const KinkedLaw* law = as_kinked(*named.law);
        if (law == nullptr) continue;
        INFO(named.name);
        tools::RandomValues random(5);
        std::vector<int> pieces(static_cast<std::size_t>(law->piece_count()));
        for (int i = 0; i < 40; ++i) {
            const LawPath path = wander(named, random);
            const Vec6 strain = random_strain(random, named.scale);
            std::vector<double> after(path.memory().size()), after_on(after);
            law->find_pieces(strain, path.memory(), pieces);
            const SectionResponse found = named.law->respond(strain, path.memory(), 0.3, after);
            const SectionResponse held = law->respond_on(pieces, strain, path.memory(), 0.3, after_on);
            CHECK(tools::relative_difference(held.resultants, found.resultants) < 1e-12);
            CHECK(tools::relative_difference(held.tangent, found.tangent) < 1e-10);
            CHECK(held.stored == Approx(found.stored).epsilon(1e-12));
            CHECK(held.dissipated == Approx(found.dissipated).epsilon(1e-10).margin(1e-14));
            for (std::size_t k = 0; k < after.size(); ++k)
                CHECK(after_on[k] == Approx(after[k]).epsilon(1e-11).margin(1e-14));
        }
    }
}

// A load that is held leaves the strain where the step before has put it, on the surface.
TEST_CASE("On a piece a law is smooth, at its limits too, and its tangent is the derivative", "[laws]") {
    int at_limits = 0;
    for (const NamedLaw& named : every_law()) {
        const KinkedLaw* law = as_kinked(*named.law);
        if (law == nullptr) continue;
        INFO(named.name);
        tools::RandomValues random(7);
        std::vector<int> pieces(static_cast<std::size_t>(law->piece_count()));
        for (int i = 0; i < 20; ++i) {
            const LawPath path = wander(named, random);
            const Vec6 strain = path.strain();
            law->find_pieces(strain, path.memory(), pieces);
            const auto look = [&](const Vec6& at) {
                return law->respond_on(pieces, at, path.memory(), 0.3, {});
            };
            Mat6 difference;
            for (int k = 0; k < 6; ++k)
                difference.col(k) =
                    tools::differentiate(
                        [&](double x) -> Vec6 {
                            return look(strain + x * named.scale[k] * Vec6::Unit(k)).resultants;
                        },
                        2e-4) /
                    named.scale[k];
            CHECK(tools::relative_difference(look(strain).tangent, difference) < 1e-6);
            if (!differentiate_law(path, strain, 0.3, named.scale)) ++at_limits;
        }
    }
    CHECK(at_limits > 50);  // kinks where differences without pieces do not exist
}

TEST_CASE("No law changes its memory, or answers otherwise where nobody asks what it would remember",
          "[laws]") {
    for (const NamedLaw& named : every_law()) {
        INFO(named.name);
        tools::RandomValues random(3);
        const LawPath path = wander(named, random);
        const std::vector<double> memory = path.memory();
        std::vector<double> after(memory.size(), 1e9);
        const Vec6 strain = random_strain(random, named.scale);
        const SectionResponse with = named.law->respond(strain, memory, 0.3, after);
        const SectionResponse without = named.law->respond(strain, memory, 0.3, {});
        CHECK(memory == path.memory());
        CHECK(std::ranges::count(after, 1e9) == 0);
        CHECK(with.resultants == without.resultants);
        CHECK(with.tangent == without.tangent);
        CHECK(with.stored == without.stored);
        CHECK(with.dissipated == without.dissipated);
    }
}

TEST_CASE("No law has resultants or energy at the start of a run", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        INFO(named.name);
        const LawPath path(*named.law);
        for (const double elapsed : {0.0, 1e-300, 1.0, 1e300, infinite}) {
            const SectionResponse response = path.look(Vec6::Zero(), elapsed);
            CHECK(response.resultants.isZero(0.0));
            CHECK(response.stored == 0.0);
            CHECK(response.dissipated == 0.0);
            CHECK(response.tangent.allFinite());
        }
    }
}

TEST_CASE("Every law answers with numbers over no time, any time and for ever", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        INFO(named.name);
        tools::RandomValues random(5);
        LawPath path = wander(named, random);
        for (const double elapsed : {0.0, 1e-300, 1e-9, 1e9, 1e300, infinite, 0.1}) {
            const SectionResponse& response = path.go(random_strain(random, named.scale), elapsed);
            CHECK(response.resultants.allFinite());
            CHECK(response.tangent.allFinite());
            CHECK(std::isfinite(response.stored));
            CHECK(response.dissipated >= 0.0);
            CHECK(std::ranges::all_of(path.memory(), [](double x) { return std::isfinite(x); }));
        }
    }
}

// Along straight paths, where a step back unloads all that slips or yields. A limit that follows the tension
// falls with it, and what is held by it alone slips on.
TEST_CASE("The elastic tangent of every law is that of a small step back, after a long time", "[laws]") {
    constexpr double small = 1e-6;
    int at_limit = 0, softer = 0;
    for (const NamedLaw& named : every_law()) {
        if (!named.is_symmetric) continue;
        INFO(named.name);
        tools::RandomValues random(21);
        for (int i = 0; i < 20; ++i) {
            LawPath path(*named.law);
            const Vec6 strain = random.number(0.1, 3.0) * random_strain(random, named.scale);
            const Vec6 resultants = path.go(strain, infinite).resultants;
            const Mat6 elastic = find_elastic_tangent(*named.law, strain, path.memory());
            const Vec6 change = resultants - path.look((1.0 - small) * strain, infinite).resultants;
            const Vec6 expected = elastic * (small * strain);
            CHECK((change - expected).norm() < 1e-5 * expected.norm() + 1e-10 * resultants.norm());
            if (is_at_limit(*named.law, strain, path.memory())) ++at_limit;
            const Vec6 further = path.look((1.0 + small) * strain, infinite).resultants - resultants;
            if (further.norm() < 0.99 * expected.norm()) ++softer;
        }
    }
    CHECK(at_limit > 20);
    CHECK(softer > 20);
    CHECK(softer <= at_limit);
}

TEST_CASE("Quick changes of strain meet what relaxes in addition", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        // A layer whose limit is only by tension has none yet. What relaxes in a fibre rope depends on its
        // mean tension, and small motions of it are slow ones.
        if (!named.is_symmetric || dynamic_cast<const SyropeLaw*>(named.law.get()) != nullptr) continue;
        INFO(named.name);
        const LawPath path(*named.law);
        Mat6 sum = find_elastic_tangent(*named.law, Vec6::Zero(), path.memory());
        for (const RelaxingStiffness& one : list_relaxing_stiffness(*named.law)) sum += one.stiffness;
        const Vec6 tiny = 1e-9 * named.scale;
        const Vec6 expected = sum * tiny;
        CHECK((path.look(tiny, 0.0).resultants - expected).norm() < 1e-6 * expected.norm());
    }
}

// The work done on a section is stored or dissipated: in the limit of small steps, whose error by the
// trapezoid rule falls with the square of their number, kinks apart.
TEST_CASE("Energy comes from nothing in no law", "[laws]") {
    for (const NamedLaw& named : every_law()) {
        INFO(named.name);
        const auto imbalance = [&](int parts) {
            tools::RandomValues random(17);
            LawPath path(*named.law);
            double largest = 0.0;
            for (int i = 0; i < 10; ++i) {
                const Vec6 next = i == 9 ? Vec6(Vec6::Zero()) : random_strain(random, named.scale);
                path.go(next, random.number(0.1, 2.0), parts);
                CHECK(path.least_dissipated() >= 0.0);
                largest = std::max(largest, std::abs(path.work() - path.now().stored - path.dissipated()));
            }
            CHECK(path.work() >= path.now().stored - largest);
            return largest / path.size_of_work();
        };
        const double coarse = imbalance(100);
        const double fine = imbalance(1600);
        // A limit that follows the tension is that of the end of each step.
        CHECK(fine < (named.is_symmetric ? 1e-5 : 3e-4));
        CHECK((coarse < 1e-12 || fine < coarse / 10.0));
    }
}

TEST_CASE("A law of nothing is the stiffness, to the last bit", "[laws]") {
    const Mat6 C = some_stiffness();
    const LayeredLaw no_layers(C, {});
    const ViscoelasticLaw no_branches(C, {});
    const ViscoelasticLaw weightless(C, {{0.0, 1.0}, {0.0, 3.0}});
    tools::RandomValues random(2);
    for (const SectionLaw* law : {static_cast<const SectionLaw*>(&no_layers),
                                  static_cast<const SectionLaw*>(&no_branches),
                                  static_cast<const SectionLaw*>(&weightless)}) {
        LawPath path(*law);
        for (int i = 0; i < 10; ++i) {
            const Vec6 strain = random.matrix<6, 1>();
            const SectionResponse& response = path.go(strain, i == 3 ? infinite : 0.1 * i);
            const Vec6 expected = C * strain;
            CHECK(response.resultants == expected);
            CHECK(response.tangent == C);
            CHECK(response.stored == 0.5 * strain.dot(expected));
            CHECK(response.dissipated == 0.0);
        }
    }
}

}  // namespace gxrod::test
