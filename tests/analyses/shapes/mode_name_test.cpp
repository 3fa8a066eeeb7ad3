// Names of modes: their order, and what moves in a frame that turns.
#include <fmt/format.h>

#include "analyses/shapes/modes.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// EI about z is four times that about y; torsion and extension lie above.
Model make_beam() {
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {12, 3},
                       make_section({4e4, 2e4, 2e4, 20.0, 1.0, 4.0}, {1.0, 1.0, 1.0, 5e-3, 1e-4, 1e-4}));
    model.rods[0].name = "beam";
    return model;
}

std::vector<std::string> name_modes(const Model& model, int count) {
    const System system(model);
    std::vector<std::string> words;
    for (const Mode& mode : find_modes(system, system.initial_state(), 0.0, {.count = count}).modes)
        words.push_back(mode.shape.words);
    return words;
}

// The words of the modes that bend about an axis, in the order of frequency.
std::vector<std::string> bending_modes(const Model& model, char axis) {
    std::vector<std::string> found;
    for (const std::string& words : name_modes(model, 14)) {
        if (words.ends_with(fmt::format("bending about {} of beam", axis))) found.push_back(words);
    }
    return found;
}

}  // namespace

TEST_CASE("Modes are numbered by their nodes, however the ends are held", "[analyses]") {
    const auto check = [](const Model& model) {
        for (const char axis : {'y', 'z'}) {
            const std::vector<std::string> found = bending_modes(model, axis);
            REQUIRE(found.size() >= 3);
            CHECK(found[0] == fmt::format("1st bending about {} of beam", axis));
            CHECK(found[1] == fmt::format("2nd bending about {} of beam", axis));
            CHECK(found[2] == fmt::format("3rd bending about {} of beam", axis));
        }
    };
    Model free = make_beam(), clamped = make_beam(), held = make_beam();
    clamp(clamped, 0);
    clamp(held, 0);
    clamp(held, held.rods[0].nodes.back());
    check(free);
    check(clamped);
    check(held);
    CHECK(name_modes(free, 1)[0].starts_with("the whole model"));
}

TEST_CASE("In a frame that turns modes are flaps along its axis and edges across it", "[analyses]") {
    Model model = make_beam();
    clamp(model, 0);
    model.rotation = TurningFrame{.axis = Vec3::UnitZ(), .speed = TimeFunction(0.0)};
    CHECK(name_modes(model, 2)[0] == "1st flap: bending about y of beam");
    CHECK(name_modes(model, 2)[1] == "1st edge: bending about z of beam");
    model.rotation->axis = Vec3::UnitY();
    CHECK(name_modes(model, 2)[0] == "1st edge: bending about y of beam");
    CHECK(name_modes(model, 2)[1] == "1st flap: bending about z of beam");
    std::string all;
    for (const std::string& words : name_modes(model, 12)) all += words + "\n";
    CHECK_THAT(all, Catch::Contains("2nd flap: bending about z of beam"));
    CHECK_THAT(all, Catch::Contains("1st torsion of beam"));
}
