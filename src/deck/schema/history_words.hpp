#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/settings/settings.hpp"

// What histories record, by the kind of thing that `at` of [[history]] names.
namespace gxrod {

enum class HistoryKind { rod, body, spring, bushing, joint, gear, tendon, touching };

// The quantities of a kind; a single thing may lack some of them.
std::span<const Quantity> quantities_of(HistoryKind kind);

bool has_quantity(HistoryKind kind, Quantity quantity);

// Their words.
std::vector<std::string> quantity_words_of(HistoryKind kind);

}  // namespace gxrod
