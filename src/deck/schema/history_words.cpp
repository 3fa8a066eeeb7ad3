#include "deck/schema/history_words.hpp"

#include <algorithm>
#include <array>

#include "deck/schema/choices.hpp"

namespace gxrod {
namespace {

constexpr std::array rod{Quantity::position,         Quantity::displacement,
                         Quantity::rotation_vector,  Quantity::quaternion,
                         Quantity::orientation,      Quantity::velocity,
                         Quantity::angular_velocity, Quantity::angular_velocity_material,
                         Quantity::acceleration,     Quantity::force,
                         Quantity::moment,           Quantity::force_spatial,
                         Quantity::moment_spatial,   Quantity::strain,
                         Quantity::curvature,        Quantity::reaction_force,
                         Quantity::reaction_moment,  Quantity::effective_tension,
                         Quantity::wall_tension,     Quantity::water_velocity,
                         Quantity::wet_fraction,     Quantity::fluid_force,
                         Quantity::bed_force};

constexpr std::array body{Quantity::position,
                          Quantity::displacement,
                          Quantity::rotation_vector,
                          Quantity::quaternion,
                          Quantity::orientation,
                          Quantity::velocity,
                          Quantity::angular_velocity,
                          Quantity::angular_velocity_material,
                          Quantity::acceleration,
                          Quantity::centre_of_mass,
                          Quantity::reaction_force,
                          Quantity::reaction_moment,
                          Quantity::wet_fraction,
                          Quantity::fluid_force,
                          Quantity::contact_force,
                          Quantity::contact_friction,
                          Quantity::least_gap};

constexpr std::array spring{Quantity::elongation, Quantity::axial_force};

constexpr std::array bushing{Quantity::displacement,
                             Quantity::rotation_vector,
                             Quantity::force,
                             Quantity::moment,
                             Quantity::force_spatial,
                             Quantity::moment_spatial};

constexpr std::array joint{Quantity::angle,
                           Quantity::angle_rate,
                           Quantity::slide,
                           Quantity::slide_rate,
                           Quantity::force,
                           Quantity::moment,
                           Quantity::force_a,
                           Quantity::moment_a,
                           Quantity::drive,
                           Quantity::friction,
                           Quantity::gap};

constexpr std::array gear{Quantity::drive, Quantity::gap};

constexpr std::array tendon{Quantity::tendon_length, Quantity::tendon_tension, Quantity::tendon_end_tension};

constexpr std::array touching{Quantity::contact_force, Quantity::contact_friction, Quantity::least_gap};

}  // namespace

std::span<const Quantity> quantities_of(HistoryKind kind) {
    switch (kind) {
        case HistoryKind::body:
            return body;
        case HistoryKind::spring:
            return spring;
        case HistoryKind::bushing:
            return bushing;
        case HistoryKind::joint:
            return joint;
        case HistoryKind::gear:
            return gear;
        case HistoryKind::tendon:
            return tendon;
        case HistoryKind::touching:
            return touching;
        case HistoryKind::rod:
            break;
    }
    return rod;
}

bool has_quantity(HistoryKind kind, Quantity quantity) {
    return std::ranges::find(quantities_of(kind), quantity) != quantities_of(kind).end();
}

std::vector<std::string> quantity_words_of(HistoryKind kind) {
    std::vector<std::string> words;
    for (const Quantity quantity : quantities_of(kind)) words.push_back(word_of(quantity_choices, quantity));
    return words;
}

}  // namespace gxrod
