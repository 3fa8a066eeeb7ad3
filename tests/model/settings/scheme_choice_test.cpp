#include "model/settings/scheme_choice.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::test;

namespace {

Model model_of(const std::string& deck) { return read(deck).model; }

Model put_on_the_ground(Model model) {
    model.surroundings.seabed = Seabed{};
    return model;
}

}  // namespace

TEST_CASE("Rods and bodies are left to radau-5", "[model]") {
    const SchemeChoice rods = choose_scheme(model_of(rod_deck), {});
    CHECK(rods.scheme == Scheme::radau_5);
    CHECK(rods.reason == "for rods, whose fastest vibrations steps do not resolve");
    CHECK(choose_scheme(model_of(rod_deck), 0.1).scheme == Scheme::radau_5);
    const SchemeChoice bodies = choose_scheme(model_of(body_deck), 1e-3);
    CHECK(bodies.scheme == Scheme::radau_5);
    CHECK(bodies.reason == "for bodies");
}

TEST_CASE("Rods on the ground are left to generalized-alpha unless much is asked for", "[model]") {
    const Model model = put_on_the_ground(model_of(rod_deck));
    const SchemeChoice open = choose_scheme(model, {});
    CHECK(open.scheme == Scheme::generalized_alpha);
    CHECK(open.reason == "for rods in water, in wind or on the ground");
    CHECK(choose_scheme(model, 1e-3).scheme == Scheme::generalized_alpha);
    CHECK(choose_scheme(model, 9e-4).scheme == Scheme::radau_5);
    CHECK(choose_scheme(put_on_the_ground(model_of(body_deck)), {}).scheme == Scheme::radau_5);
}

TEST_CASE("Friction is left to generalized-alpha", "[model]") {
    const std::string hinge =
        "[joint.axle]\ntype = \"hinge\"\nbetween = [\"ground\", \"top\"]\naxis = [0, 0, 1]\n";
    CHECK(find_friction(model_of(body_deck + hinge)).empty());
    const Model model = model_of(body_deck + hinge + "friction = { moment = 2, stick = 1e-4 }\n");
    CHECK(find_friction(model) == "joint axle");
    CHECK(choose_scheme(model, 1e-4).scheme == Scheme::generalized_alpha);
    CHECK(choose_scheme(model, {}).reason == "for friction, which joint axle has");
    Model pulled = model_of(rod_deck);
    pulled.tendons.push_back({.name = "pull", .friction = CapstanFriction{0.3, 1e3}});
    CHECK(find_friction(pulled) == "tendon pull");
}
