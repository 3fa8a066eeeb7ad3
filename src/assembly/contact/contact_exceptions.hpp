#pragma once

#include <cstdint>
#include <optional>
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

    // Return the exception that applies to friction and to whether they touch; nullptr if none does.
    const ContactException* find(std::size_t element, std::size_t other) const {
        return find_between(of_elements_, element, of_elements_, other, decides_touch);
    }
    const ContactException* find_at_obstacle(std::size_t element, std::size_t obstacle) const {
        return find_between(of_elements_, element, of_obstacles_, obstacle, decides_touch);
    }
    // Return the coefficient of restitution, if there is one.
    std::optional<double> find_restitution(std::size_t element, std::size_t other) const {
        return restitution_of(find_between(of_elements_, element, of_elements_, other, has_restitution));
    }
    std::optional<double> find_restitution_at_obstacle(std::size_t element, std::size_t obstacle) const {
        return restitution_of(find_between(of_elements_, element, of_obstacles_, obstacle, has_restitution));
    }

  private:
    // The sides of one exception: bit k is set for items among between[k].
    using Sides = std::vector<std::uint8_t>;
    // Finds the last one that is of this kind.
    const ContactException* find_between(const std::vector<Sides>& own,
                                         std::size_t one,
                                         const std::vector<Sides>& others,
                                         std::size_t other,
                                         bool (*is_wanted)(const ContactException&)) const;
    static bool decides_touch(const ContactException& one) { return !one.restitution || one.friction; }
    static bool has_restitution(const ContactException& one) { return one.restitution.has_value(); }
    static std::optional<double> restitution_of(const ContactException* one) {
        return one == nullptr ? std::nullopt : one->restitution;
    }

    const Contact* contact_ = nullptr;
    std::vector<Sides> of_elements_, of_obstacles_;  // for each exception
};

}  // namespace gxrod
