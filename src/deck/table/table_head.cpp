#include "deck/table/table_head.hpp"

#include <algorithm>
#include <cassert>

#include "deck/table/binding.hpp"

namespace gxrod {

const KeySpec& TableHead::key_of(const void* field) const {
    const auto key = std::ranges::find_if(spec->keys, [&](const KeySpec& one) {
        if (!one.binding) return false;  // tables of the top level
        return one.binding->field(*this) == field || one.binding->value(*this) == field;
    });
    assert(key != spec->keys.end());
    return *key;
}

Place TableHead::place_of(const void* field) const {
    const Place* found = find_place(field);
    return found == nullptr ? place : *found;
}

std::string TableHead::path_of(const void* field) const {
    const std::string& key = key_of(field).name;
    return path.empty() ? key : path + "." + key;
}

const Place* TableHead::find_place(const void* field) const {
    const std::string& key = key_of(field).name;
    const auto found = std::ranges::find(given, key, &std::pair<std::string, Place>::first);
    return found == given.end() ? nullptr : &found->second;
}

}  // namespace gxrod
