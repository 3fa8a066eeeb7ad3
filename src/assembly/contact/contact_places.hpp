#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/contact_law.hpp"
#include "contact/place_force.hpp"
#include "loads/loaded_element.hpp"
#include "state/state.hpp"

namespace gxrod {

// A bound: no place of an element moves by more than this times the largest motion of its nodes. It is the
// largest sum of the absolute values of its shape functions, 1.64 for five nodes.
inline constexpr double largest_shape_sum = 1.65;

// A place of a rod or body that can touch obstacles, with its share of length.
struct ContactPlace {
    int element = 0;                                  // in the list of elements
    double fraction = 0.0;                            // fraction of the rod's length, from its start
    double weight = 0.0;                              // a length at t = 0
    std::array<double, most_element_nodes> shapes{};  // values of the element's shape functions
    std::array<double, most_element_nodes> slopes{};  // their slopes; zero on bodies
    Vec3 arm = Vec3::Zero();                          // from the node of a body, at t = 0
};

// An element of a rod that can touch, or a shape of a body, which has one node and turns its places about it.
struct ContactElement {
    int rod = 0;  // as in ContactTouch
    bool is_body = false;
    int shape = -1;  // in Contact::bodies
    int element = 0;
    int part = 0;  // part of the model in ScaleGroups
    int count = 0;
    std::array<int, most_element_nodes> nodes{};
    double radius = 0.0;
    ContactLaw law{};
    std::size_t first_place = 0, end_place = 0;
    std::vector<std::int64_t> slots{};
};

struct ContactPlaces {
    std::vector<ContactElement> elements;
    std::vector<ContactPlace> places;

    const ContactElement& element_of(std::size_t place) const {
        return elements[static_cast<std::size_t>(places[place].element)];
    }
    std::size_t index_of(const ContactElement& element) const {
        return static_cast<std::size_t>(&element - elements.data());
    }
    Vec3 position(const ContactPlace& place, const std::vector<NodeMotion>& motions) const {
        return elements[static_cast<std::size_t>(place.element)].is_body
                   ? Vec3(motion_of_body(place, motions).r + arm(place, motions))
                   : interpolate(place, motions, &NodeMotion::r);
    }
    Vec3 velocity(const ContactPlace& place, const std::vector<NodeMotion>& motions) const {
        if (!elements[static_cast<std::size_t>(place.element)].is_body)
            return interpolate(place, motions, &NodeMotion::v);
        const NodeMotion& motion = motion_of_body(place, motions);
        return motion.v + motion.omega.cross(arm(place, motions));
    }
    // Returns the arm of a place of a body, from its node.
    Vec3 arm(const ContactPlace& place, const std::vector<NodeMotion>& motions) const {
        return motion_of_body(place, motions).Lambda * place.arm;
    }
    // Returns the lever of forces on a body, from its node. It is the arm; over a step with impulses it is
    // the mean of the arms at both ends, by which a force of constant direction does the work of the
    // displacement up to the third power of the rotation.
    Vec3 lever(const ContactPlace& place, const State& state, bool has_impacts) const {
        const Vec3 own = arm(place, state.trial);
        return has_impacts ? Vec3(0.5 * (own + arm(place, state.previous))) : own;
    }
    const NodeMotion& motion_of_body(const ContactPlace& place,
                                     const std::vector<NodeMotion>& motions) const {
        const ContactElement& element = elements[static_cast<std::size_t>(place.element)];
        return motions[static_cast<std::size_t>(element.nodes[0])];
    }
    // Returns the displacement of a place for displacements and spins of nodes, to first order.
    Vec3 change(const ContactPlace& place, const State& state, const std::vector<Vec6>& increments) const;
    // Bounds the displacements of all places of an element.
    double reach(const ContactElement& element, const std::vector<Vec6>& increments) const;
    template <class Member>
    Vec3 interpolate(const ContactPlace& place, const std::vector<NodeMotion>& motions, Member member) const {
        const ContactElement& element = elements[static_cast<std::size_t>(place.element)];
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < element.count; ++i)
            sum += place.shapes[static_cast<std::size_t>(i)] *
                   (motions[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])].*member);
        return sum;
    }
    // Returns the vector along the line, by the slopes of shape functions; zero on bodies.
    Vec3 tangent(const ContactPlace& place, const std::vector<NodeMotion>& motions) const {
        const ContactElement& element = elements[static_cast<std::size_t>(place.element)];
        Vec3 sum = Vec3::Zero();
        for (int i = 0; i < element.count; ++i)
            sum += place.slopes[static_cast<std::size_t>(i)] *
                   motions[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])].r;
        return sum;
    }
    // The node nearest to the place a part t of the way from one place of an element to another.
    int nearest_node(const ContactPlace& from, const ContactPlace& to, double t) const;
    // Returns the motion since the last accepted step.
    PlaceMotion motion_of(const ContactPlace& place, const State& state) const;
};

// Finds the places of all rods that touch, in the order of the model: the nodes of each element with the
// weights of Gauss-Lobatto's rule or, if an obstacle bulges, the ends of equal pieces. The places of all
// bodies that touch follow.
ContactPlaces find_contact_places(const Model& model);

// Finds the places of all rods that touch, so close together that the chords between them stay within a
// quarter of the skin of the line, even for the largest expected bend. Both ends of each body follow; for a
// sphere they coincide.
ContactPlaces find_chord_places(const Model& model);

}  // namespace gxrod
