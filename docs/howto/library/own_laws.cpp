// Runs a cord and a spring with laws that are written here, and prints what both reach next to the exact
// values.
#include <cmath>
#include <cstdio>
#include <gxrod/face/gxrod.hpp>

namespace {

const char* const deck_text = R"(
[section.cord]                    # its law is the program's
stiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }
[rod.cord]
section  = "cord"
line     = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
[[support]]
at  = "cord.start"
fix = "all"
[[load]]
at    = "cord.end"
force = ["3*pull", 0, 0]

[body.slider]
at      = [0, 1, 0]
mass    = 1
inertia = [1, 1, 1]
[[support]]
at  = "slider"
fix = ["y", "z", "rotation"]
[spring.strut]                    # and a force in addition to its stiffness
between   = ["ground", "slider"]
at_a      = [-0.5, 1, 0]
stiffness = 50
[[load]]
at    = "slider"
force = ["9*pull", 0, 0]

[input.pull]                      # over the load factor, the program's too

[analysis]
kind = "static"
[[history]]
name       = "cord"
at         = "cord.end"
quantities = ["displacement"]
[[history]]
name       = "strut"
at         = "strut"
quantities = ["elongation"]
)";

// A cord that gets stiffer the more it is stretched: N = a (exp(b ε) − 1). It resists shear, torsion and
// bending linearly.
class Cord : public gxrod::SectionLaw {
  public:
    int memory_size() const override { return 0; }
    std::string describe() const override { return "an exponential cord"; }
    gxrod::SectionResponse respond(const gxrod::Vec6& strain,
                                   std::span<const double>,
                                   double,
                                   std::span<double>) const override {
        gxrod::SectionResponse response;
        response.tangent = linear_.asDiagonal();
        response.resultants = linear_.cwiseProduct(strain);
        response.stored = 0.5 * strain.dot(response.resultants);
        const double grown = std::exp(b * strain[0]);
        response.tangent(0, 0) = a * b * grown;
        response.resultants[0] = a * (grown - 1.0);
        response.stored += a * ((grown - 1.0) / b - strain[0]);
        return response;
    }

    static constexpr double a = 2.0, b = 5.0;

  private:
    gxrod::Vec6 linear_ = (gxrod::Vec6() << 0.0, 10.0, 10.0, 1.0, 1.0, 1.0).finished();
};

}  // namespace

int main() try {
    gxrod::Deck deck = gxrod::Deck::from_text(deck_text, "own_laws.toml");
    deck.set_law("cord", std::make_shared<Cord>());
    deck.set_force("strut", [](double length) { return 4000.0 * std::pow(length - 0.5, 3); });
    deck.set_input("pull", [](double t) { return t * t; });
    gxrod::Simulation run(deck.build());
    run.run();
    std::printf(
        "cord %.9f, exact %.9f\n", run["cord"].displacement.x(), std::log(1.0 + 3.0 / Cord::a) / Cord::b);
    std::printf("strut %.9f, exact %.9f\n", run["strut"]["elongation"].number(), 0.1);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
