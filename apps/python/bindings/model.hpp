#pragma once

#include <string>
#include <vector>

#include "face/deck.hpp"

namespace gxrod::python {

// A deck that was checked and built with overrides. Simulations build it again, each for itself: they share
// no function of time and no input.
struct BuiltModel {
    Deck deck;
    Problem problem;

    // Throws DeckError, also of a parameter that the deck does not have.
    BuiltModel(const Deck& read, const std::vector<std::string>& overrides)
        : deck(Deck(read).set_all(overrides)), problem(deck.build()) {}
};

}  // namespace gxrod::python
