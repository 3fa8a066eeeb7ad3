#pragma once

#include <cstddef>
#include <string>
#include <vector>

// The types of values of a deck, each stated once: a key has the Kind of the C++ type of its field. A Kind<T>
// has
//   words, column, schema   what ValueKind says
//   nature                  optional: what ValueKind says
//   read                    the value of a text; nullopt, with a fault, if it is wrong
//   print                   the value as a deck has it
//   sample                  a value for tests
//   default_value           optional: what the schema shows as the default
namespace gxrod {

template <class Value>
struct Kind;

// A text or a number, as JSON Schema.
inline constexpr const char* text_schema = R"({"type": "string"})";
inline constexpr const char* any_number_schema = R"({"$ref": "#/$defs/number"})";
// One of these, as JSON Schema.
std::string schema_of_any(const std::vector<std::string>& schemas);
// A value, or a list of them that is not empty, as JSON Schema.
std::string schema_of_one_or_list(const std::string& item);
// Arrays of so many values, as JSON Schema.
std::string schema_of_array(const std::string& items, std::size_t size);
// Arrays of so many values at least, as JSON Schema.
std::string schema_of_list(const std::string& items, std::size_t size);
// "[a, b, c]".
std::string print_list(const std::vector<std::string>& items);

}  // namespace gxrod
