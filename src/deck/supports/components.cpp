#include "deck/supports/components.hpp"

#include <algorithm>

#include "deck/schema/choices.hpp"

namespace gxrod {

std::vector<std::string> component_words() {
    std::vector<std::string> words(component_names.begin(), component_names.end());
    words.insert(words.end(), {"all", "position", "rotation"});
    return words;
}

std::array<bool, 6> components_of(const std::string& word) {
    if (word == "all") return {true, true, true, true, true, true};
    if (word == "position") return {true, true, true, false, false, false};
    if (word == "rotation") return {false, false, false, true, true, true};
    std::array<bool, 6> components{};
    const auto name = std::find(component_names.begin(), component_names.end(), word);
    components[static_cast<std::size_t>(name - component_names.begin())] = true;
    return components;
}

}  // namespace gxrod
