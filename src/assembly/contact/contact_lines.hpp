#pragma once

#include <vector>

#include "assembly/contact/contact_exceptions.hpp"
#include "contact/meshes/cells.hpp"

namespace gxrod {

// A piece of a rod between two of its places, straight for contact; or a whole body, whose length is zero if
// it is a sphere.
struct ContactPiece {
    std::size_t place = 0;  // its first place; the second is the next one of the same element
    double length = 0.0;    // at t = 0
    double middle = 0.0;    // arc length from the start of the rod; 0 for a body
    bool starts_rod = false, ends_rod = false;
};

// A place where two rods, or a rod and a body, meet without contact: a place on each by arc length, and the
// distance from it without contact.
struct RodMeeting {
    int rod = 0, other = 0;  // rod ≤ other
    double at = 0.0, other_at = 0.0;
    double reach = 0.0;
};

// Rods as chains of straight pieces, which can touch each other and themselves.
struct ContactLines {
    ContactPlaces places;
    std::vector<ContactPiece> pieces;
    std::vector<RodMeeting> meetings;
    std::vector<double> round;  // length of each closed rod, else 0
    ContactExceptions exceptions;
    bool is_within_rods = false;
    bool is_between_rods = false;

    const ContactElement& element_of(const ContactPiece& piece) const {
        return places.elements[static_cast<std::size_t>(places.places[piece.place].element)];
    }
    const ContactException* find_exception(const ContactPiece& a, const ContactPiece& b) const {
        return exceptions.find(static_cast<std::size_t>(places.places[a.place].element),
                               static_cast<std::size_t>(places.places[b.place].element));
    }
    // Whether two pieces can touch. Neighbours on one rod cannot, since a round rod bent as much as possible
    // comes no nearer there (Schur's theorem), nor can pieces next to a meeting of rods.
    bool can_touch(const ContactPiece& a, const ContactPiece& b) const;
};

// Finds the lines of a model whose rods touch each other or themselves; else empty. The model must outlive
// them.
ContactLines find_contact_lines(const Model& model);

}  // namespace gxrod
