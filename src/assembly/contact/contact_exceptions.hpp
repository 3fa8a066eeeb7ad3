#pragma once

#include <cstdint>
#include <vector>

#include "assembly/contact/contact_places.hpp"
#include "model/contact.hpp"

namespace gxrod {

// Finds the entry of Contact::exceptions for two elements of rods, or an element and an obstacle. An element
// belongs to a part of a rod if its middle does.
class ContactExceptions {
  public:
    ContactExceptions() = default;
    // The contact must outlive it.
    ContactExceptions(const Contact& contact, const ContactPlaces& places);

    // Return the exception that applies; nullptr if none does.
    const ContactException* find(std::size_t element, std::size_t other) const {
        return find_between(of_elements_, element, of_elements_, other);
    }
    const ContactException* find_at_obstacle(std::size_t element, std::size_t obstacle) const {
        return find_between(of_elements_, element, of_obstacles_, obstacle);
    }

  private:
    // The sides of one exception: bit k is set for items among between[k].
    using Sides = std::vector<std::uint8_t>;
    const ContactException* find_between(const std::vector<Sides>& own,
                                         std::size_t one,
                                         const std::vector<Sides>& others,
                                         std::size_t other) const;

    const Contact* contact_ = nullptr;
    std::vector<Sides> of_elements_, of_obstacles_;  // for each exception
};

}  // namespace gxrod
