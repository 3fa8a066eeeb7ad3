#pragma once

#include <string>

#include "batch/plan/plan.hpp"
#include "model/settings/history_request.hpp"

namespace gxrod {

// Says why cycles of a quantity cannot be counted: the key of the collection that shows it, and a sentence.
struct CountFault {
    std::string key, message;
};

// Finds why the cycles of what a collection takes of a history would not be those of any place: it has no
// sign, or it is of another point of the section at each time. The message is "" if nothing is wrong.
CountFault find_count_fault(const Collection& collection, const HistoryRequest& history);

}  // namespace gxrod
