#pragma once

#include "deck/table/kinds.hpp"

namespace gxrod {

// A number for each load case, by its name.
struct CaseFactors {
    StageFunctions named;
};

template <>
struct Kind<CaseFactors> {
    static std::string words(const KeySpec&) {
        return "a table of a number for each load case, such as { dead = 1.35, wind = 1.5 }";
    }
    static std::string column(const KeySpec&) { return "{ CASE = number }"; }
    static std::string schema(const KeySpec&);
    static std::optional<CaseFactors> read(const ValueSource& from);
    static std::string print(const CaseFactors& value) { return Kind<StageFunctions>::print(value.named); }
    static std::string sample(const KeySpec&) { return "{ dead = 1.25, wind = 2.5 }"; }
};

}  // namespace gxrod
