#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/settings.hpp"
#include "results/quantity.hpp"
#include "results/step_record.hpp"

namespace gxrod {

// The values of one named point at a step. Quantities: those of the deck's [[history]].
class HistoryPoint {
  public:
    // A row's numbers; vectors use the first three.
    using Row = std::array<double, 4>;

    // `model` must outlive the point.
    HistoryPoint(const Model& model, const HistoryRequest& request);

    PointKind kind() const { return body_ ? PointKind::body : PointKind::rod; }
    // Chooses the sign of each quaternion that is nearest to the one of the call before.
    Row compute(Quantity quantity, const Snapshot& snapshot);
    // Takes a row computed earlier for the one of the call before.
    void go_on_from(Quantity quantity, std::span<const double> row);

  private:
    // The motion of the point as seen from the point that the request is relative to: places from there,
    // components in its axes, Lambda · start_axes_ the section or body axes from those.
    NodeMotion seen_from_reference(const Snapshot& snapshot) const;
    // Section force, moment, strain or curvature: the mean over the elements that meet at the point.
    Vec3 section_mean(Quantity quantity, const Snapshot& snapshot) const;
    Row continuous_quaternion(const Quat& rotation, Quat& last);

    Vec3 start_;  // where the point is at t = 0, as it is seen
    int node_;
    int relative_node_;           // what the point is relative to, or -1
    Quat relative_axes_;          // there, at t = 0
    const Body* body_ = nullptr;  // the point is a body's
    Quat start_axes_;             // section or body axes at t = 0, as they are seen
    std::vector<int> elements_;   // that meet at the point, as indices into Snapshot::elements
    Quat last_quaternion_ = Quat::Identity();
    Quat last_orientation_ = Quat::Identity();
};

}  // namespace gxrod
