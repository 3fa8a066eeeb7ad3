#include "watch/history_watch.hpp"

#include <algorithm>

#include "watch/stress_watch.hpp"

namespace gxrod {

std::vector<RodPlace> list_rod_places(const std::vector<HistoryRequest>& requests) {
    std::vector<RodPlace> places;
    for (const HistoryRequest& request : requests) {
        const auto* point = std::get_if<WatchedPoint>(&request.target);
        if (point == nullptr) continue;
        places.push_back(point->place);
        const auto is_of_section = [](const Quantity* one) { return part_of(*one) == SnapshotPart::section; };
        places.back().is_asked =
            point->node < 0 || std::ranges::any_of(quantities_of(request), is_of_section);
    }
    return places;
}

std::vector<RodPlace> list_recorded_places(const Model& model, const OutputSettings& output) {
    std::vector<RodPlace> places = list_rod_places(output.histories);
    if (output.stresses.empty()) return places;
    const std::vector<RodPlace> compared = list_stress_places(model);
    places.insert(places.end(), compared.begin(), compared.end());
    return places;
}

std::vector<ContactWatch> list_contact_watches(const std::vector<HistoryRequest>& requests) {
    std::vector<ContactWatch> watches;
    for (const HistoryRequest& request : requests) {
        if (const ContactWatch* contact = contact_of(request.target)) watches.push_back(*contact);
    }
    return watches;
}

HistoryRow HistoryWatch::compute(const Quantity& quantity, const Snapshot& snapshot) {
    HistoryRow row = quantity.value({subject_, snapshot});
    if (!quantity.is_rotation()) return row;
    const Quat rotation(row[0], row[1], row[2], row[3]);
    Quat& last = last_.try_emplace(&quantity, Quat::Identity()).first->second;
    const double sign = rotation.dot(last) < 0.0 ? -1.0 : 1.0;
    last.coeffs() = sign * rotation.coeffs();
    return make_row(last);
}

void HistoryWatch::resume(const Quantity& quantity, std::span<const double> row) {
    if (quantity.is_rotation()) last_[&quantity] = Quat(row[0], row[1], row[2], row[3]);
}

}  // namespace gxrod
