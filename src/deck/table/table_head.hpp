#pragma once

#include <string>
#include <utility>
#include <vector>

#include "deck/text/fault_list.hpp"

namespace gxrod {

struct KeySpec;
struct TableSpec;

// The base of every struct that a table of a deck is read into: which table it is, and what the deck gives of
// it.
struct TableHead {
    const TableSpec* spec = nullptr;
    std::string name;  // of a [spring.NAME]
    std::string path;  // "spring.strut", "load[0]"
    Place place;
    std::vector<std::pair<std::string, Place>> given;  // keys that the deck has, and where their values are

    // The key that is bound to the field of this struct at this address, or to the value of an std::optional.
    const KeySpec& key_of(const void* field) const;
    // Whether the deck has the key of this field.
    template <class Field>
    bool gives(const Field& field) const {
        return find_place(&field) != nullptr;
    }
    // Where the deck has the value of the key of this field; the table's place if it does not.
    Place place_of(const void* field) const;
    std::string path_of(const void* field) const;

  private:
    const Place* find_place(const void* field) const;
};

}  // namespace gxrod
