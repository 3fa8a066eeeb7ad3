#pragma once

#include <compare>
#include <string>
#include <vector>

#include "deck/text/fault.hpp"

namespace gxrod {

// The place of a key or value: a line and column of the deck, or one of the overrides. Places are ordered as
// in the deck, overrides last.
struct Place {
    int override_index = -1;  // index in --set, from 0; -1 in the deck's text
    int line = 1;
    int column = 1;

    auto operator<=>(const Place&) const = default;
};

// Collects faults, so that a user sees all of them at once.
class FaultList {
  public:
    // Takes the "KEY=VALUE" that Place::override_index counts.
    FaultList(std::string file, std::vector<std::string> overrides)
        : file_(std::move(file)), overrides_(std::move(overrides)) {}

    void add(const Place& place, std::string key, std::string message);
    bool empty() const { return entries_.empty(); }
    std::size_t count() const { return entries_.size(); }

    // Returns all faults in deck order.
    std::vector<DeckFault> list() const;
    // Throws DeckError with all faults, if there are any.
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
