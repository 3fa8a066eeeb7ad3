#include "check/surroundings/line_at_rest.hpp"

#include <fmt/format.h>

#include <cmath>

#include "check/surroundings/line_words.hpp"
#include "check/surroundings/lowest_frequency.hpp"
#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A rod in water everywhere, of mass 12 and displaced mass 1025 π 0.05² = 8.05 per length.
std::string pipe_deck(const std::string& shape, const std::string& supports, const std::string& mass = "12") {
    return gravity_down + "[fluid]\ndensity = 1025\n" + R"([section.s]
stiffness = { EA = 2e7, GAy = 8e6, GAz = 8e6, GJ = 2e4, EIy = 2e4, EIz = 2e4 }
fluid = { outer_diameter = 0.1 }
inertia = { rhoIy = 0.0075, rhoIz = 0.0075, rhoA = )" +
           mass + " }\n[rod.r]\nsection = \"s\"\norder = 4\nelements = 10\n" + shape + supports +
           "[analysis]\nkind = \"static\"\n";
}

std::string support(const std::string& at, const std::string& fix) {
    return "[[support]]\nat = \"" + at + "\"\nfix = " + fix + "\n";
}

// With a rest shape of its own a catenary does not stretch.
std::string stiff(const std::string& catenary, int free_length) {
    return fmt::format("catenary = {{ {} }}\nrest = {{ line = {{ from = [0, 0, 0], to = [{}, 0, 0] }} }}\n",
                       catenary,
                       free_length);
}

const std::string held_ends = support("r.start", "\"position\"") + support("r.end", "\"position\"");
const std::string upright = "line = { from = [0, 0, 10], to = [0, 0, 0] }\n";

LineAtRest line_of(const Model& model) {
    const std::optional<LineAtRest> line = find_line_at_rest(model, model.rods.at(0));
    REQUIRE(line);
    return *line;
}

double frequency_of(const std::string& deck) {
    const Model model = read(deck).model;
    const std::optional<double> frequency = find_lowest_frequency(model, model.rods.at(0), line_of(model));
    REQUIRE(frequency);
    return *frequency;
}

}  // namespace

TEST_CASE("A hung line's tension follows from how its slope grows", "[check]") {
    // Of the weight 196.2: H = 9603.43917624285, 13316.7780218414 and 17240.7780218414 at the ends.
    const Model model =
        read(pipe_deck(stiff("from = [0, 0, 0], to = [100, 0, 20], length = 120", 120), held_ends)).model;
    const LineAtRest line = line_of(model);
    const double weight = 9.81 * (12.0 - 1025.0 * M_PI * 0.0025);
    CHECK(line.source == LineAtRest::Source::hung);
    CHECK(line.tension.front() == Approx(13316.7780218414 * weight / 196.2).epsilon(1e-8));
    CHECK(line.tension.back() == Approx(17240.7780218414 * weight / 196.2).epsilon(1e-8));
    CHECK(*find_boundary_layer(model, model.rods[0], line, 0) ==
          Approx(std::sqrt(2e4 / line.tension[0])).epsilon(1e-12));
}

TEST_CASE("A line that hangs and stretches has the tension of the elastic catenary", "[check]") {
    const Model model =
        read(pipe_deck("catenary = { from = [0, 0, 0], to = [100, 0, 20], length = 120 }\n", held_ends))
            .model;
    const LineAtRest line = line_of(model);
    // T² = H² + V² at both ends, and V grows by the weight.
    const double weight = 9.81 * (12.0 - 1025.0 * M_PI * 0.0025);
    const double lower = line.tension.front(), upper = line.tension.back();
    const double sum = (upper * upper - lower * lower) / (120.0 * weight);
    const double V0 = 0.5 * (sum - 120.0 * weight), V1 = 0.5 * (sum + 120.0 * weight);
    const double H = std::sqrt(upper * upper - V1 * V1);
    CHECK(H * 120.0 / 2e7 + H / weight * (std::asinh(V1 / H) - std::asinh(V0 / H)) ==
          Approx(100.0).epsilon(1e-8));
    CHECK((V1 * V1 - V0 * V0) / (2.0 * 2e7 * weight) + (upper - lower) / weight ==
          Approx(20.0).epsilon(1e-8));
}

TEST_CASE("What lies on the ground has the level tension", "[check]") {
    const std::string deck =
        pipe_deck(stiff("from = [0, 0, 0], to = [640, 0, 100], length = 680, bed = true", 680), held_ends);
    const Model model = read(deck + "[seabed]\nz = 0\nstiffness = 1e5\n").model;
    const LineAtRest line = line_of(model);
    // H = w a, with a from the length ℓ and the height h of what hangs: a = (ℓ² − h²)/(2 h).
    const double hung = line.to - line.from;
    const double weight = 9.81 * (12.0 - 1025.0 * M_PI * 0.0025);
    CHECK(line.first > 0);
    CHECK(line.from > line.arc_length[line.first]);
    CHECK(line.tension.front() == line.tension[line.first]);
    CHECK(line.tension.front() == Approx(weight * (hung * hung - 1e4) / 200.0).epsilon(1e-6));
    // What lies and the span of what hangs, a asinh(ℓ/a).
    const double a = line.tension.front() / weight;
    CHECK(line.from + a * std::asinh(hung / a) == Approx(640.0).epsilon(1e-6));
}

TEST_CASE("An end that is hardly above the ground does not hide what hangs", "[check]") {
    const auto find_line = [](const char* z) {
        const std::string catenary =
            fmt::format("from = [0, 0, {}], to = [640, 0, 100], length = 680, bed = true", z);
        const Model model =
            read(pipe_deck(stiff(catenary, 680), held_ends) + "[seabed]\nz = 0\nstiffness = 1e5\n").model;
        return line_of(model);
    };
    CHECK(find_line("1e-9").from == Approx(find_line("0").from).epsilon(1e-6));
    CHECK(find_line("1e-9").tension.front() == Approx(find_line("0").tension.front()).epsilon(1e-6));
}

TEST_CASE("What is beyond a place pulls there", "[check]") {
    const std::string top = "[[load]]\nat = \"r.end\"\nforce = [7, 0, 1000]\n";
    const Model model =
        read(pipe_deck("line = { from = [0, 0, 0], to = [0, 0, 10] }\n",
                       support("r.start", "\"position\"") + support("r.end", "[\"x\", \"y\"]")) +
             top)
            .model;
    const LineAtRest line = line_of(model);
    const double weight = 9.81 * (12.0 - 1025.0 * M_PI * 0.0025);
    CHECK(line.source == LineAtRest::Source::pulled);
    CHECK(line.tension.back() == Approx(1000.0).epsilon(1e-12));
    CHECK(line.tension.front() == Approx(1000.0 - 10.0 * weight).epsilon(1e-12));
    // From a start that is free, too.
    const Model hanging = read(pipe_deck(upright, support("r.start", "\"all\""))).model;
    CHECK(line_of(hanging).tension.front() == Approx(10.0 * weight).epsilon(1e-12));
    CHECK(std::abs(line_of(hanging).tension.back()) < 1e-9);
    // Nothing is known of a rod that is bent between two supports, and no tension of a straight one.
    const Model bent =
        read(pipe_deck("arc = { from = [0, 0, 0], through = [1, 0, 1], to = [2, 0, 0] }\n", held_ends)).model;
    CHECK_FALSE(find_line_at_rest(bent, bent.rods[0]));
    // Nor of one that runs through an eye, which can hold it.
    const Model eyed = read(pipe_deck(upright, support("r.start", "\"all\"")) +
                            "[joint.eye]\ntype = \"sleeve\"\nbetween = [\"r\", \"ground\"]\nat = [0, 0, 5]\n")
                           .model;
    CHECK_FALSE(find_line_at_rest(eyed, eyed.rods[0]));
    const Model straight = read(pipe_deck(upright, held_ends)).model;
    CHECK(line_of(straight).source == LineAtRest::Source::unloaded);
    CHECK_FALSE(find_boundary_layer(straight, straight.rods[0], line_of(straight), 0));
}

TEST_CASE("The lowest frequency in water is that of a beam under tension", "[check]") {
    // Clamped at the top, in water; of a Timoshenko rod 0.19726302.
    CHECK(frequency_of(pipe_deck(upright, support("r.start", "\"all\""))) ==
          Approx(0.19726302).epsilon(2e-4));
    // A cantilever of the density of water and its mass again: 1.8751² √(EI/m)/(2 π L²).
    const std::string neutral = "\"1025*pi*0.05^2\"";
    const double mass = 2.0 * 1025.0 * M_PI * 0.0025;
    CHECK(frequency_of(pipe_deck(upright, support("r.start", "\"all\""), neutral)) ==
          Approx(1.875104068711961 * 1.875104068711961 * std::sqrt(2e4 / mass) / (2.0 * M_PI * 100.0))
              .epsilon(1e-6));
    // Between hinges: ω² = (π/L)² (T + EI (π/L)²)/m.
    const double k = M_PI / 10.0;
    CHECK(frequency_of(pipe_deck(upright,
                                 support("r.start", "\"position\"") + support("r.end", "[\"x\", \"y\"]"),
                                 neutral) +
                       "[[load]]\nat = \"r.end\"\nforce = [0, 0, -3000]\n") ==
          Approx(k * std::sqrt((3000.0 + 2e4 * k * k) / mass) / (2.0 * M_PI)).epsilon(1e-6));
}

TEST_CASE("A spacing is written where elements are longer than boundary layers", "[check]") {
    const auto words = [](const std::string& elements) {
        const std::string deck =
            pipe_deck("catenary = { from = [0, 0, 0], to = [100, 0, 20], length = 120 }\n", held_ends);
        const Model model = read(replaced(deck, "elements = 10", "elements = " + elements)).model;
        return find_coarse_layer(model, model.rods.at(0));
    };
    // The tension 3405 at the upper end makes √(2e4/3405) = 2.42, of elements of 12. Of 30 elements those at
    // the ends are 0.2 (0.74 + 0.26 ln 5/0.8) 120/30 = 1.01 long with a size of 0.2, and 1.42 with one of
    // 0.3.
    CHECK_THAT(words("10"), Contains("is 2.42 at s = 120, 0.2 of an element"));
    CHECK_THAT(words("30"), Contains("spacing = [[0, 0.2], [0.13, 1], [0.87, 1], [1, 0.2]]"));
    CHECK(words("60").empty());
}

TEST_CASE("Reduced velocities of currents are said", "[check]") {
    const auto words = [](double speed) {
        const Model model =
            read(replaced(pipe_deck(upright, support("r.start", "\"all\"")),
                          "density = 1025\n",
                          fmt::format("density = 1025\ncurrent = {{ velocity = [{}, 0, 9] }}\n", speed)))
                .model;
        return describe_line_at_rest(model, model.rods.at(0));
    };
    // 0.19726 × 0.1 makes 0.02; what flows along the rod does not count.
    CHECK_THAT(words(0.0), Contains("under this tension: 0.1973\n"));
    CHECK_THAT(words(0.06), Contains("up to 0.06 across it, has the reduced velocity U/(f D) = 3.04\n"));
    CHECK_THAT(words(0.1), Contains("5.07: within 4 to 8, where vortices"));
    CHECK_THAT(words(0.2), Contains("10.1: above 8; vortices"));
}

}  // namespace gxrod::test
