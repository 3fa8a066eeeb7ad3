#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "results/histories/point_kind.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Lists the points of rods in the requests, in order, for Snapshot::points.
std::vector<RodPlace> list_rod_places(const std::vector<HistoryRequest>& requests);
// Lists the contacts of rods that snapshots record for these requests, in order.
std::vector<ContactWatch> list_contact_watches(const std::vector<HistoryRequest>& requests);

// Computes the values of one named point at a step, for the quantities of the deck's [[history]].
class HistoryPoint {
  public:
    // The numbers of a row; vectors use the first three, single numbers the first.
    using Row = std::array<double, 4>;

    // Makes the point of requests[index]. `model` must outlive the point; snapshots must have the points of
    // all requests.
    HistoryPoint(const Model& model, const std::vector<HistoryRequest>& requests, std::size_t index);

    PointKind kind() const;
    // Returns whether this quantity of a joint's motor or friction is the force of a slide, not the moment of
    // a turn.
    bool is_force_of_slide(Quantity quantity) const;
    // Computes a quantity; quaternions get the sign that is nearest to the result of the previous call.
    Row compute(Quantity quantity, const Snapshot& snapshot);
    // Sets the previous row that signs of quaternions follow.
    void go_on_from(Quantity quantity, std::span<const double> row);

  private:
    // The state of the point at t = 0 and now.
    struct Seen {
        Vec3 start;
        Quat start_axes;  // axes of the section or body
        NodeMotion motion;
    };
    Seen see(const Snapshot& snapshot) const;
    // Returns the state relative to the request's reference point: positions from there, components in its
    // axes, and Lambda · start_axes the section or body axes relative to them.
    Seen see_from_reference(const Snapshot& snapshot) const;
    static Row joint_value(Quantity quantity, const JointValues& joint);
    double spring_value(Quantity quantity, const Snapshot& snapshot) const;
    Vec3 bushing_value(Quantity quantity, const Snapshot& snapshot) const;
    Vec3 reaction_moment(const Snapshot& snapshot) const;
    Row surrounding_value(Quantity quantity, const Snapshot& snapshot) const;
    Vec3 section_value(Quantity quantity, const Snapshot& snapshot, const Quat& axes) const;
    Row continuous_quaternion(const Quat& rotation, Quat& last);

    Vec3 start_ = Vec3::Zero();  // start of a node
    Quat start_axes_ = Quat::Identity();
    int node_;                    // or -1
    std::size_t point_ = 0;       // or a point of a rod, by index in Snapshot::points
    const Body* body_ = nullptr;  // or a body
    std::size_t body_index_ = 0;  // index of the body
    int spring_ = -1;             // or a spring, by index in Snapshot::springs
    int bushing_ = -1;            // or a bushing, by index in Snapshot::bushings
    int joint_ = -1;              // or a joint, or a gear, by index in Snapshot::joints
    bool is_of_gear_ = false;
    bool drives_slide_ = false;  // whether its motor drives the slide
    bool rubs_slide_ = false;    // whether its friction acts on the slide
    int relative_node_;          // reference node, or -1
    Quat relative_axes_;         // axes of the reference at t = 0
    Vec3 relative_start_ = Vec3::Zero();
    std::optional<Vec3> about_;  // reference point of moments of reactions
    int tendon_ = -1;            // or a tendon, by index in Snapshot::tendons
    int obstacle_ = -1;          // or an obstacle, by index in Snapshot::obstacles
    int contact_ = -1;           // or contacts of a rod, by index in Snapshot::watched_contacts
    Quat last_quaternion_ = Quat::Identity();
    Quat last_orientation_ = Quat::Identity();
};

}  // namespace gxrod
