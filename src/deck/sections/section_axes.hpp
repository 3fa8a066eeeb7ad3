#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "deck/places/build_context.hpp"
#include "deck/schema/choices.hpp"

// The section axes of rods at t = 0.
namespace gxrod {

// A rule for the direction of a section axis, which has one whatever the direction of the rod.
enum class AxisRule { up };
inline constexpr std::array<Choice<AxisRule>, 1> axis_rule_choices{{{"up", AxisRule::up}}};
inline constexpr const auto& choices_of(AxisRule) { return axis_rule_choices; }

using AxisDirection = std::variant<Vec3, AxisRule>;

// The keys by which a table gives section axes, one at most: section y, or section z.
struct SectionDirections {
    std::optional<AxisDirection> y_axis, z_axis;

    bool are_given() const { return y_axis || z_axis; }
    const std::optional<AxisDirection>& given() const { return z_axis ? z_axis : y_axis; }
    bool has_rule() const { return are_given() && std::holds_alternative<AxisRule>(*given()); }
};

// Finds the axes at the start, from the unit tangent and what a table gives or, with a note, a global axis.
// If that is wrong, adds a fault and returns nullopt.
std::optional<Quat> find_start_axes(const TableHead& table,
                                    const SectionDirections& directions,
                                    const Vec3& tangent,
                                    BuildContext& context);

// Computes axes from a unit tangent and what a table gives, projected; nullopt if it is parallel to the
// tangent, which a rule never is.
std::optional<Quat> project_axes(const SectionDirections& directions,
                                 const Vec3& tangent,
                                 const BuildContext& context);

// Chooses axes from a unit tangent and the global axis least aligned with it.
Quat choose_axes(const Vec3& tangent);

// Finds the direction that is up: against gravity; without gravity along z, or along the second axis of the
// plane of the deck.
Vec3 find_up(const BuildContext& context);

// Returns whether a unit tangent is along `up`, so near that the rule takes another direction.
bool is_vertical(const Vec3& tangent, const Vec3& up);

// Notes what the rule of a table makes of vertical pieces, `count` of `all` of this kind.
void note_vertical(const TableHead& table,
                   const SectionDirections& directions,
                   const std::string& kind,
                   std::size_t count,
                   std::size_t all,
                   BuildContext& context);

// Returns axes turned about their x by an angle.
Quat twisted(const Quat& axes, double angle);

}  // namespace gxrod
