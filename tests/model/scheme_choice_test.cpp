#include "model/scheme_choice.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::test;

namespace {

const std::string water = "[fluid]\ndensity = 1025\n";

Model model_of(const std::string& deck) { return read(deck).model; }

}  // namespace

TEST_CASE("Rods and bodies are left to radau-5", "[model]") {
    const SchemeChoice rods = choose_scheme(model_of(rod_deck), {});
    CHECK(rods.scheme == Scheme::radau_5);
    CHECK(rods.reason == "for rods, whose fastest vibrations steps do not resolve");
    const SchemeChoice bodies = choose_scheme(model_of(body_deck), 1e-3);
    CHECK(bodies.scheme == Scheme::radau_5);
    CHECK(bodies.reason == "for bodies");
}

TEST_CASE("A loose accuracy is left to generalized-alpha", "[model]") {
    CHECK(choose_scheme(model_of(rod_deck), 9e-3).scheme == Scheme::radau_5);
    const SchemeChoice loose = choose_scheme(model_of(rod_deck), 0.02);
    CHECK(loose.scheme == Scheme::generalized_alpha);
    CHECK(loose.reason == "an accuracy of 0.02 wants no higher order");
}

TEST_CASE("Rods in water are left to generalized-alpha unless much is asked for", "[model]") {
    const Model model = model_of(rod_deck + water);
    const SchemeChoice open = choose_scheme(model, {});
    CHECK(open.scheme == Scheme::generalized_alpha);
    CHECK(open.reason == "for rods in water, wind or on the ground");
    CHECK(choose_scheme(model, 1e-3).scheme == Scheme::generalized_alpha);
    CHECK(choose_scheme(model, 9e-4).scheme == Scheme::radau_5);
    CHECK(choose_scheme(model_of(body_deck + water), {}).scheme == Scheme::radau_5);
}
