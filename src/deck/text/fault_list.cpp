#include "deck/text/fault_list.hpp"

#include <algorithm>

namespace gxrod {

void FaultList::add(const Place& place, std::string key, std::string message) {
    entries_.push_back({place, std::move(key), std::move(message)});
}

std::vector<DeckFault> FaultList::list() const {
    std::vector<Entry> sorted = entries_;
    std::stable_sort(
        sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) { return a.place < b.place; });
    // What is wrong in several stages is said once.
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<DeckFault> faults;
    for (const Entry& entry : sorted) faults.push_back(make_fault(entry));
    return faults;
}

void FaultList::throw_if_any() const {
    if (!entries_.empty()) throw DeckError(list());
}

DeckFault FaultList::make_fault(const Entry& entry) const {
    if (entry.place.override_index < 0) {
        return {file_, entry.place.line, entry.place.column, entry.key, entry.message};
    }
    const std::string& text = overrides_[entry.place.override_index];
    // The key is not said twice.
    const bool same_key = text.substr(0, text.find('=')) == entry.key;
    return {"--set " + text, 0, 0, same_key ? "" : entry.key, entry.message};
}

}  // namespace gxrod
