#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace gxrod {

// The names that each name uses. Every name that is used has an entry.
using Uses = std::map<std::string, std::set<std::string>>;

struct UseOrder {
    std::vector<std::string> names;  // all names, each after the names that it uses, apart from cycles
    std::vector<std::vector<std::string>>
        cycles;                         // a, b if a uses b and b uses a; the first is the one met first
    std::set<std::string> in_cycle;     // members of the cycles
    std::vector<std::string> too_deep;  // names used through more than most_use_depth others
};

inline constexpr std::size_t most_use_depth = 1000;

// Finds the order, starting from `names` in their order. Names that use each other in a circle are in
// `cycles`.
UseOrder find_use_order(const std::vector<std::string>& names, const Uses& uses);

}  // namespace gxrod
