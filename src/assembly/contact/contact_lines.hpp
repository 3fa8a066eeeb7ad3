#pragma once

#include <vector>

#include "assembly/contact/contact_exceptions.hpp"
#include "contact/meshes/cells.hpp"

namespace gxrod {

// A piece of a rod between two of its places, straight for what touches it; or all of a body, whose length is
// zero if it is a sphere.
struct ContactPiece {
    std::size_t place = 0;  // and the one after it, of the same element
    double length = 0.0;    // at t = 0
    double middle = 0.0;    // arc length from the start of the rod; 0 of a body
    bool starts_rod = false, ends_rod = false;
};

// Where two rods, or a rod and a body, meet, so that they do not touch there: a place on each by arc length,
// and how far from it.
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
    std::vector<double> round;  // the length of each rod that is closed, else 0
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
    // Whether two pieces can touch: not neighbours on one rod, where a round rod bent as much as it can be
    // comes no nearer (Schur's theorem), nor next to where rods meet.
    bool can_touch(const ContactPiece& a, const ContactPiece& b) const;
};

// Of a model, which must outlive them, whose rods touch each other or themselves; else empty.
ContactLines find_contact_lines(const Model& model);

}  // namespace gxrod
