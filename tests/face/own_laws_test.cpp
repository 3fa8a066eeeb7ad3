#include "face/own_laws.hpp"

#include <cmath>

#include "deck/decks.hpp"
#include "face/gxrod.hpp"
#include "model/settings/scheme_card.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string swing = R"(gravity = [0, 0, -9.81]
[input.pull]
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[section.idle]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = 6, EIz = 8 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = ["pull", 0.5, 0]
[spring.line]
between = ["ground", "r.end"]
at_a = [2, 0, 1]
stiffness = 3.0
[[history]]
name = "tip"
at = "r.end"
quantities = ["position"]
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.02
)";

Vec3 end_of(const Deck& deck) {
    Simulation run(deck.build());
    run.run();
    return run["tip"].position;
}

Deck with(const std::string& old_text, const std::string& new_text) {
    return Deck::from_text(replaced(swing, old_text, new_text));
}

Vec6 stiffness() { return (Vec6() << 1e3, 1e3, 1e3, 5.0, 6.0, 7.0).finished(); }

SectionResponse respond_linearly(const Vec6& strain) {
    SectionResponse response;
    response.tangent = stiffness().asDiagonal();
    response.resultants = stiffness().cwiseProduct(strain);
    response.stored = 0.5 * strain.dot(response.resultants);
    return response;
}

// For each resultant a spring next to a spring and a damper in a row.
class Relaxing : public SectionLaw {
  public:
    Relaxing(double ratio, double time) : stiffness_(ratio * stiffness()), time_(time) {}

    int memory_size() const override { return 12; }  // strains, and resultants of the dampers
    std::string describe() const override { return "relaxes"; }
    SectionResponse respond(const Vec6& strain,
                            std::span<const double> memory,
                            double elapsed,
                            std::span<double> after) const override {
        const Eigen::Map<const Vec6> strain_before(memory.data()), damped_before(memory.data() + 6);
        const double x = elapsed / time_;
        const double kept = std::isinf(x) ? 0.0 : std::exp(-x);
        const double share = std::isinf(x) ? 0.0 : x > 0.0 ? -std::expm1(-x) / x : 1.0;
        const Vec6 damped =
            kept * damped_before + share * stiffness_.cwiseProduct(Vec6(strain - strain_before));
        SectionResponse response = respond_linearly(strain);
        response.resultants += damped;
        response.tangent.diagonal() += share * stiffness_;
        response.stored += 0.5 * damped.cwiseQuotient(stiffness_).dot(damped);
        if (!after.empty()) {
            Eigen::Map<Vec6>{after.data()} = strain;
            Eigen::Map<Vec6>{after.data() + 6} = damped;
        }
        return response;
    }

  private:
    Vec6 stiffness_;
    double time_;
};

}  // namespace

TEST_CASE("a linear law of a program is the linear section", "[face]") {
    const Vec3 linear = end_of(Deck::from_text(swing));
    Deck deck = Deck::from_text(swing);
    deck.set_law("s", respond_linearly);
    CHECK((end_of(deck) - linear).norm() < 1e-12);
    deck.set_law("s", [](const Vec6& strain) {
        SectionResponse response = respond_linearly(strain);
        response.resultants *= 2.0;
        response.tangent *= 2.0;
        return response;
    });
    CHECK((end_of(deck) - linear).norm() > 0.01);
}

TEST_CASE("a linear law of a program goes with every scheme, analysis and surrounding", "[face]") {
    const auto end_with = [](const std::vector<std::string>& overrides, bool has_own_law) {
        Deck deck = Deck::from_text(swing);
        deck.set_all(overrides);
        if (has_own_law) deck.set_law("s", respond_linearly);
        return end_of(deck);
    };
    const Vec3 plain = end_with({}, false);
    std::vector<std::vector<std::string>> cases{
        {"analysis={kind=\"static\", steps=4}", "load[0].force=[0, 0.5, 0.2]", "gravity=[0, 0, -0.5]"},
        {"analysis={kind=\"path\", until={t=1.0}}", "load[0].force=[0, 0.5, 0.2]", "gravity=[0, 0, 0]"},
        {"fluid={density=100.0}", "section.s.fluid={outer_diameter=0.1}"},
        {"obstacle={floor={plane={point=[0, 0, -0.3], normal=[0, 0, 1]}}}", "section.s.radius=0.05"},
        {"tendon={t={on=\"r\", offset=[0.1, 0], tension=2.0}}"},
        {"section.s.damping={kelvin_voigt=0.01}"},
        {"rod.r.order=3"},
        {"rod.r.element=\"simo\""},
    };
    for (const SchemeCard& card : scheme_cards) {
        if (card.conserves_energy) continue;  // of a section's stiffness alone
        cases.push_back({"analysis.integrator=" + std::string(card.word), "analysis.end_time=0.02"});
        if (card.is_explicit) cases.back().push_back("analysis.time_step=5e-5");
    }
    for (const auto& overrides : cases) {
        INFO(overrides.front());
        const Vec3 expected = end_with(overrides, false);
        CHECK((end_with(overrides, true) - expected).norm() < 1e-9);
        CHECK((expected - plain).norm() > 1e-9);
    }
}

TEST_CASE("a law of a program remembers as a built-in law does", "[face]") {
    const std::string end = "EIz = 7 }\n";
    const Vec3 built_in = end_of(with(end, end + "law = { viscoelastic = { prony = [[0.5, 0.3]] } }\n"));
    CHECK((built_in - end_of(Deck::from_text(swing))).norm() > 1e-3);
    Deck deck = Deck::from_text(swing);
    deck.set_law("s", std::make_shared<Relaxing>(0.5, 0.3));
    CHECK((end_of(deck) - built_in).norm() < 1e-11);
}

TEST_CASE("forces of a program are those of a deck's expressions", "[face]") {
    const std::string stiff = "stiffness = 3.0\n";
    Deck deck = Deck::from_text(swing);
    deck.set_force("line", [](double length) { return 20.0 * (length - 1.0) * (length - 1.0); });
    CHECK((end_of(deck) - end_of(with(stiff, stiff + "force = \"20*(length-1)*(length-1)\"\n"))).norm() <
          1e-12);

    deck = Deck::from_text(swing);
    deck.set_force("line", [](double length, double rate) { return length * rate; });
    CHECK((end_of(deck) - end_of(with(stiff, stiff + "force = \"length*rate\"\n"))).norm() < 1e-12);

    deck = Deck::from_text(swing);
    deck.set_force(0, [](double, const Vec3& position, const Vec3& velocity) {
        return Vec3(0.0, -velocity.y(), 2.0 * position.z());
    });
    CHECK((end_of(deck) - end_of(with("0.5, 0]", "\"0.5-vy\", \"2*z\"]"))).norm() < 1e-9);

    deck = Deck::from_text(swing);
    deck.set_input("pull", [](double t) { return 3.0 * t * t; });
    CHECK((end_of(deck) - end_of(with("[input.pull]\n", "[input.pull]\nvalue = \"3*t*t\"\n"))).norm() <
          1e-12);
}

TEST_CASE("a law of a program has no stresses", "[face]") {
    const std::string deck = R"([section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e6, nu = 0.3 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
[analysis]
kind = "static"
[[history]]
name = "root"
at = "r.start"
quantities = "von_mises"
)";
    const auto respond = [](const Vec6& strain) { return SectionResponse{strain, Mat6::Identity()}; };
    CHECK_THROWS_WITH(Deck::from_text(deck).set_law("s", respond).build(),
                      Contains("section.s: history root has stresses, which do not follow from a law"));
    CHECK_NOTHROW(Deck::from_text(replaced(deck, "von_mises", "force")).set_law("s", respond).build());
}

TEST_CASE("a law for what the deck does not have is an error of the deck", "[face]") {
    const auto build = [](const auto& change) {
        Deck deck = Deck::from_text(swing);
        change(deck);
        return deck.build();
    };
    const auto constant = [](double) { return 1.0; };
    CHECK_THROWS_WITH(build([](Deck& deck) { deck.set_law("z", respond_linearly); }),
                      Contains("section.z: the deck has none"));
    CHECK_THROWS_WITH(build([](Deck& deck) { deck.set_law("idle", respond_linearly); }),
                      Contains("no rod has this section"));
    CHECK_THROWS_WITH(build([&](Deck& deck) { deck.set_force("lime", constant); }),
                      Contains("spring.lime: the deck has none; did you mean \"line\"?"));
    CHECK_THROWS_WITH(build([](Deck& deck) {
                          deck.set_force(1, [](double, const Vec3&, const Vec3&) { return Vec3(1, 0, 0); });
                      }),
                      Contains("load[1]"));
    CHECK_THROWS_WITH(build([&](Deck& deck) { deck.set_input("push", constant); }), Contains("input.push"));
    CHECK_THROWS_WITH(
        build([&](Deck& deck) { deck.set_force("line", constant).set_force("line", constant); }),
        Contains("only one of them"));
    CHECK_THROWS_WITH(build([](Deck& deck) { deck.set_force("line", [](double) { return NAN; }); }),
                      Contains("is nan at t = 0"));
    CHECK_THROWS_WITH(build([](Deck& deck) {
                          deck.set_law("s", [](const Vec6&) {
                              SectionResponse response;
                              response.resultants[0] = NAN;
                              return response;
                          });
                      }),
                      Contains("not finite"));
}

TEST_CASE("results of a program with laws of its own say that the deck lacks them", "[face]") {
    Deck deck = Deck::from_text(swing);
    CHECK(deck.build().record.text == swing);
    deck.set_law("s", respond_linearly);
    CHECK_THAT(deck.build().record.text, Catch::StartsWith("# A program ran this deck with laws"));
}

TEST_CASE("a run with laws of a program is not resumed without them", "[face]") {
    Deck deck = Deck::from_text(swing);
    CHECK_NOTHROW(read_resumption(deck.build().record, {}, {}));
    deck.set_law("s", respond_linearly);
    CHECK_THROWS_WITH(read_resumption(deck.build().record, {}, {}),
                      Catch::Contains("laws or functions of its own"));
}

}  // namespace gxrod::test
