#pragma once

#include <map>
#include <span>
#include <vector>

#include "model/settings/settings.hpp"
#include "watch/quantities.hpp"

namespace gxrod {

// Lists the points of rods in the requests, in order, for Snapshot::points.
std::vector<RodPlace> list_rod_places(const std::vector<HistoryRequest>& requests);
// Lists these points, then those at which stresses are compared if the output has stresses.
std::vector<RodPlace> list_recorded_places(const Model& model, const OutputSettings& output);
// Lists the contacts that snapshots record for these requests, in order.
std::vector<ContactWatch> list_contact_watches(const std::vector<HistoryRequest>& requests);

// Computes the values of the thing of a history, step by step.
class HistoryWatch {
  public:
    // Watches the thing of requests[index]. `model` must outlive the watch; snapshots must have the points
    // and contacts of all requests.
    HistoryWatch(const Model& model, const std::vector<HistoryRequest>& requests, std::size_t index)
        : subject_(model, requests, index) {}

    // Computes a quantity of the thing; quaternions get the sign that is nearest to the result of the
    // previous call.
    HistoryRow compute(const Quantity& quantity, const Snapshot& snapshot);
    // Computes a quantity by its word, which must be one of the thing's.
    HistoryRow compute(std::string_view word, const Snapshot& snapshot) {
        return compute(quantity_of(subject_.target, word), snapshot);
    }
    // Sets the previous row that signs of a quaternion follow.
    void resume(const Quantity& quantity, std::span<const double> row);

  private:
    Subject subject_;
    std::map<const Quantity*, Quat> last_;
};

}  // namespace gxrod
