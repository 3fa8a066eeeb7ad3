#include "face/unknown_name_error.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/schema/suggestion.hpp"

namespace gxrod {

std::size_t find_name(const std::string& what,
                      const std::string& name,
                      const std::vector<std::string>& names) {
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    const std::string meant = nearest_spelling(name, names);
    const std::string there = names.empty()       ? "there are none"
                              : names.size() == 1 ? "there is " + names.front()
                                                  : "there are " + plain_list(names);
    throw UnknownNameError(fmt::format("there is no {} \"{}\"; {}{}",
                                       what,
                                       name,
                                       meant.empty() ? "" : fmt::format("did you mean \"{}\"? ", meant),
                                       there));
}

}  // namespace gxrod
