#pragma once

#include "deck/reading/checked_deck.hpp"

// In static analyses t is the load factor. A value that says how it follows t is taken as it is; any other
// one grows with t.
namespace gxrod {

TimeFunction apply_load_factor(const TimeFunction& function);
LineFunction apply_load_factor(const LineExpression& expression);

}  // namespace gxrod
