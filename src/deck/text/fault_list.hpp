#pragma once

#include <compare>
#include <string>
#include <vector>

#include "deck/text/fault.hpp"

namespace gxrod {

// Where a key or value is: a line and column of the deck, or one of the overrides. Orders as the deck
// does, overrides last.
struct Place {
    int override_index = -1;  // of --set, from 0; -1 in the deck's text
    int line = 1;
    int column = 1;

    auto operator<=>(const Place&) const = default;
};

// Collects what is wrong, so that a user sees all of it at once.
class FaultList {
  public:
    // `overrides` are the "KEY=VALUE" that Place::override_index counts.
    FaultList(std::string file, std::vector<std::string> overrides)
        : file_(std::move(file)), overrides_(std::move(overrides)) {}

    void add(const Place& place, std::string key, std::string message);
    bool empty() const { return entries_.empty(); }
    std::size_t count() const { return entries_.size(); }

    // All faults in deck order.
    std::vector<DeckFault> list() const;
    // Throws DeckError with them, if there are any.
    void throw_if_any() const;

  private:
    struct Entry {
        Place place;
        std::string key;
        std::string message;

        bool operator==(const Entry&) const = default;
    };

    DeckFault make_fault(const Entry& entry) const;

    std::string file_;
    std::vector<std::string> overrides_;
    std::vector<Entry> entries_;
};

}  // namespace gxrod
