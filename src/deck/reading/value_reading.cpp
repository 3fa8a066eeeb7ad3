#include "deck/reading/value_reading.hpp"

#include <cassert>
#include <utility>

#include "deck/reading/array_reading.hpp"
#include "deck/reading/row_reader.hpp"
#include "deck/reading/word_reading.hpp"

namespace gxrod {
namespace {

template <class Value>
decltype(CheckedValue::value) wrap(std::optional<Value> value) {
    if (!value) return std::monostate{};
    return std::move(*value);
}

}  // namespace

std::optional<double> read_number(const DeckNode& node,
                                  const std::string& path,
                                  const KeySpec& key,
                                  const ReadingContext& context) {
    return NumberReader(key, context).number(node, path);
}

decltype(CheckedValue::value) read_value(const DeckNode& node,
                                         const std::string& path,
                                         const KeySpec& key,
                                         const ReadingContext& context) {
    const RowReader reader(key, context);
    switch (key.type) {
        case ValueType::text:
        case ValueType::reference:
        case ValueType::point:
            return wrap(read_text(node, path, key, context));
        case ValueType::choice:
            return wrap(read_word(node, path, key, context));
        case ValueType::choices:
            return wrap(read_words(node, path, key, context));
        case ValueType::names:
            return wrap(read_names(node, path, key, context));
        case ValueType::flag:
            return wrap(reader.flag(node, path));
        case ValueType::integer:
            return wrap(reader.integer(node, path));
        case ValueType::number:
        case ValueType::number_or_table:
            return wrap(reader.number(node, path));
        case ValueType::vector:
            return wrap(reader.vector(node, path));
        case ValueType::partners:
            return wrap(read_points(node, path, key, context));
        case ValueType::numbers:
            return wrap(read_number_list(node, path, key, context));
        case ValueType::bounds:
            return wrap(read_bounds(node, path, key, context));
        case ValueType::time_expression:
            return wrap(reader.time_function(node, path));
        case ValueType::time_vector:
            return wrap(reader.functions<3>(node, path, &FunctionReader::time_function));
        case ValueType::time_table:
            return wrap(reader.time_table(node, path));
        case ValueType::columns:
            return std::monostate{};  // read with their file, which is a table then
        default:
            assert(false);
            return std::monostate{};
    }
}

}  // namespace gxrod
