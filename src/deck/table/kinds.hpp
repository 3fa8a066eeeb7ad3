#pragma once

#include "deck/table/binding.hpp"
#include "deck/table/function_kinds.hpp"
#include "deck/table/name_kinds.hpp"
#include "deck/table/number_kinds.hpp"

// All kinds, and what is known of each without its type.
namespace gxrod {

template <class Value>
constexpr ValueKind make_kind() {
    ValueKind kind{.words = &Kind<Value>::words,
                   .column = &Kind<Value>::column,
                   .schema = &Kind<Value>::schema,
                   .sample = &Kind<Value>::sample};
    if constexpr (requires { Kind<Value>::nature; }) kind.nature = Kind<Value>::nature;
    if constexpr (requires { Kind<Value>::variables(); }) kind.variables = &Kind<Value>::variables;
    return kind;
}

template <class Value>
inline constexpr ValueKind value_kind = make_kind<Value>();

}  // namespace gxrod
