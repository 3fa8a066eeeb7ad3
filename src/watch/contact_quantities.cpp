#include <algorithm>

#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

std::string lacks_shape(const Watched& target, const Model& model) {
    const int body = std::get<WatchedBody>(target).index;
    const auto& shapes = model.contact.bodies;
    return std::ranges::find(shapes, body, &ContactBody::body) != shapes.end()
               ? ""
               : "this body touches nothing; expected its `sphere` or `capsule`";
}

std::string lacks_contact(const Watched& /*target*/, const Model& model) {
    return model.contact.is_empty() ? "the deck has no [contact]" : "";
}

// clang-format off
constexpr Quantity obstacle_lines[]{
    Quantity("contact_force", "force that rods and bodies exert on the obstacle", "force", Axes::global,
             [](const Sight& see) { return see.obstacle().force; }),
    Quantity("contact_friction", "the part of contact_force along the surface", "force", Axes::global,
             [](const Sight& see) { return see.obstacle().friction; }),
    Quantity("least_gap",
             "least distance of the surface of a rod or body from that of the obstacle", "length", Axes::none,
             [](const Sight& see) { return see.obstacle().least_gap; }).by_search()};

constexpr Quantity lines_of_touching_rods[]{
    Quantity("contact_force", "force on the rod of what touches it", "force", Axes::global,
             [](const Sight& see) { return see.contacts().force; }).unless(lacks_contact),
    Quantity("contact_friction", "the part of contact_force along the surfaces", "force", Axes::global,
             [](const Sight& see) { return see.contacts().friction; }).unless(lacks_contact),
    Quantity("least_gap", "least distance of the surface of the rod from what it can touch; infinite without that",
             "length", Axes::none, [](const Sight& see) { return see.contacts().least_gap; }).unless(lacks_contact).by_search()};

constexpr Quantity lines_of_touching_bodies[]{
    Quantity("contact_force", "force on the body of what touches it", "force", Axes::global,
             [](const Sight& see) { return see.contacts().force; }).unless(lacks_shape),
    Quantity("contact_friction", "the part of contact_force along the surfaces", "force", Axes::global,
             [](const Sight& see) { return see.contacts().friction; }).unless(lacks_shape),
    Quantity("least_gap", "least distance of the surface of the body from what it can touch; infinite without that",
             "length", Axes::none, [](const Sight& see) { return see.contacts().least_gap; }).unless(lacks_shape).by_search()};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_obstacles{
    obstacle_lines,
    SnapshotPart::contact,
    "obstacles",
    "an obstacle has contact_force, contact_friction and least_gap only"};
constinit const QuantityTable quantities_of_touching_rods{
    lines_of_touching_rods,
    SnapshotPart::contact,
    "rods",
    "a rod as a whole has contact and touch-down quantities only; expected a point of it, as in "
    "\"ROD@0.5\""};
constinit const QuantityTable quantities_of_touching_bodies{
    lines_of_touching_bodies, SnapshotPart::contact, "bodies"};

}  // namespace gxrod
