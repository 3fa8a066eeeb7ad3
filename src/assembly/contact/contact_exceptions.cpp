#include "assembly/contact/contact_exceptions.hpp"

namespace gxrod {

ContactExceptions::ContactExceptions(const Contact& contact, const ContactPlaces& places)
    : contact_(&contact) {
    for (const ContactException& one : contact.exceptions) {
        Sides elements(places.elements.size(), 0), obstacles(contact.obstacles.size(), 0);
        for (std::size_t side = 0; side < 2; ++side) {
            const auto bit = static_cast<std::uint8_t>(1U << side);
            for (const ContactPart& part : one.between[side]) {
                if (part.index < 0) {
                    obstacles[static_cast<std::size_t>(-1 - part.index)] |= bit;
                    continue;
                }
                for (std::size_t e = 0; e < elements.size(); ++e) {
                    const ContactElement& element = places.elements[e];
                    if (element.rod != part.index) continue;
                    const double middle = 0.5 * (places.places[element.first_place].fraction +
                                                 places.places[element.end_place - 1].fraction);
                    if (part.from <= middle && middle <= part.to) elements[e] |= bit;
                }
            }
        }
        of_elements_.push_back(std::move(elements));
        of_obstacles_.push_back(std::move(obstacles));
    }
}

const ContactException* ContactExceptions::find_between(const std::vector<Sides>& own,
                                                        std::size_t one,
                                                        const std::vector<Sides>& others,
                                                        std::size_t other,
                                                        bool (*is_wanted)(const ContactException&)) const {
    for (std::size_t i = own.size(); i-- > 0;) {
        if (!is_wanted(contact_->exceptions[i])) continue;
        const unsigned a = own[i][one], b = others[i][other];
        if (((a & 1U) != 0 && (b & 2U) != 0) || ((a & 2U) != 0 && (b & 1U) != 0))
            return &contact_->exceptions[i];
    }
    return nullptr;
}

}  // namespace gxrod
