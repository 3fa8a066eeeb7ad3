#pragma once

#include <memory>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "deck/text/fault.hpp"
#include "deck/text/overrides.hpp"

namespace gxrod::python {

// A deck that was checked and built with overrides. Simulations build it again, each for itself: they share
// no function of time and no input.
struct BuiltModel {
    std::shared_ptr<const DeckTemplate> deck;
    std::vector<std::string> overrides;
    Problem problem;

    // Throws DeckError, also of a parameter that the deck does not have.
    BuiltModel(std::shared_ptr<const DeckTemplate> read, std::vector<std::string> set)
        : deck(std::move(read)), overrides(std::move(set)), problem(build()) {}

  private:
    Problem build() const {
        for (const std::string& one : overrides) {
            const std::string key = one.substr(0, one.find('='));
            const std::string lack = describe_missing_parameter(key, deck->tree());
            if (!lack.empty()) throw DeckError({{"--set " + one, 0, 0, key, "the deck has no " + lack}});
        }
        return deck->build(overrides);
    }
};

}  // namespace gxrod::python
