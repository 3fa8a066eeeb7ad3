#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gxrod {

// A key of a table, or the index of an array element.
using KeyStep = std::variant<std::string, std::size_t>;

// Splits a path such as load[0].force or rod."a b".section into steps; nullopt if it is not a path.
std::optional<std::vector<KeyStep>> split_key(std::string_view key);

// Returns the path of the first `count` steps.
std::string join_key(const std::vector<KeyStep>& steps, std::size_t count);

}  // namespace gxrod
