#pragma once

#include "deck/reading/checked_deck.hpp"

// The load factor t of static analyses: a value that depends on t stays as it is; any other value is
// multiplied by t.
namespace gxrod {

TimeFunction apply_load_factor(const TimeFunction& function);
LineFunction apply_load_factor(const LineExpression& expression);

}  // namespace gxrod
