#include "deck/table/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gxrod {

std::string schema_of_any(const std::vector<std::string>& schemas) {
    return fmt::format(R"({{"anyOf": [{}]}})", fmt::join(schemas, ", "));
}

std::string schema_of_one_or_list(const std::string& item) {
    return schema_of_any({item, schema_of_list(item, 1)});
}

std::string schema_of_list(const std::string& items, std::size_t least) {
    return fmt::format(R"({{"type": "array", "items": {}, "minItems": {}}})", items, least);
}

std::string schema_of_array(const std::string& items, std::size_t size) {
    return fmt::format(
        R"({{"type": "array", "items": {}, "minItems": {}, "maxItems": {}}})", items, size, size);
}

std::string print_list(const std::vector<std::string>& items) {
    return fmt::format("[{}]", fmt::join(items, ", "));
}

}  // namespace gxrod
