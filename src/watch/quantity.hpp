#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

#include "model/settings/history_request.hpp"

namespace gxrod {

struct Sight;

// A row of a history: vectors use the first three numbers, single numbers the first; quaternions are w x y z,
// stresses xx yy zz yz xz xy.
using HistoryRow = std::array<double, 6>;

inline HistoryRow make_row(double number) { return {number}; }
inline HistoryRow make_row(const Vec3& vector) { return {vector.x(), vector.y(), vector.z(), 0.0}; }
inline HistoryRow make_row(const Vec6& stress) {
    return {stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
}
inline HistoryRow make_row(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }
inline HistoryRow make_row(const Quat& quaternion) {
    return {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
}

// The axes of a quantity's components.
enum class Axes {
    none,  // a single number
    global,
    observer,   // global, or those of the point that the history is relative to
    material,   // of the section or body
    principal,  // those of the stress itself
    joint,      // those that the joint's side A carries
    bushing
};

// The effect of turning the whole model on a quantity.
enum class Turning {
    none,                 // components in axes that turn, too
    vector,               // v → R v
    attitude,             // q → R q
    rotation_since_start  // q → R q Rᵀ
};

// The scale of the model with which errors of a quantity are compared if it is small itself.
enum class Size {
    unknown,
    place,   // a length that is known as well as places are, counted from where it starts
    change,  // a length that is known as well as places are
    length,
    speed,
    spin,
    acceleration,
    force,
    line_force,
    moment,
    strain,
    curvature,
    stress,
    number
};

// Returns the size that most quantities of a dimension have.
constexpr Size size_of_dimension(std::string_view dimension) {
    if (dimension == "length") return Size::length;
    if (dimension == "length/time") return Size::speed;
    if (dimension == "angle/time") return Size::spin;
    if (dimension == "length/time²") return Size::acceleration;
    if (dimension == "force") return Size::force;
    if (dimension == "force/length") return Size::line_force;
    if (dimension == "force·length") return Size::moment;
    if (dimension == "angle/length") return Size::curvature;
    if (dimension == "force/length²") return Size::stress;
    return Size::number;
}

// A quantity that can be recorded of a kind of thing: a line of a table.
struct Quantity {
    const char* word;       // as decks and results have it
    const char* meaning;    // as results describe it
    const char* dimension;  // "force·length"; "1" for plain numbers
    Axes axes;
    int columns;
    HistoryRow (*value)(const Sight& sight);

    // Members that only some lines of the tables set.
    Turning turning;
    Size size;
    // "" where the thing has the quantity, else why it lacks it.
    std::string (*lack)(const Watched& target, const Model& model) = nullptr;
    // Replaces the dimension if it depends on the thing.
    const char* (*dimension_of)(const Watched& target, const Model& model) = nullptr;
    // Replaces the meaning if the history is relative to a point, "{}".
    const char* relative_meaning = nullptr;
    const char* continuous = nullptr;  // the word of the same rotation without jumps
    bool has_strain_order = false;     // converges as strains do, by one order of elements
    bool is_about = false;             // a moment that can be about any point
    bool is_from_no_load = false;      // an angle to the direction `no_load`
    bool is_searched = false;          // takes a search where nothing is near

    template <class Member>
    constexpr Quantity with(Member Quantity::*member, std::type_identity_t<Member> changed) const {
        Quantity line = *this;
        line.*member = changed;
        return line;
    }

    // Takes the value as a lambda without captures, whose result sets the number of columns.
    template <class Value>
    constexpr Quantity(const char* its_word,
                       const char* its_meaning,
                       const char* its_dimension,
                       Axes its_axes,
                       Value /*value*/)
        : word(its_word),
          meaning(its_meaning),
          dimension(its_dimension),
          axes(its_axes),
          columns(columns_of<std::invoke_result_t<Value, const Sight&>>()),
          value([](const Sight& sight) { return make_row(Value{}(sight)); }),
          turning(its_axes == Axes::global || its_axes == Axes::observer ? Turning::vector : Turning::none),
          size(size_of_dimension(its_dimension)) {}

    constexpr Quantity turns(Turning way, const char* seen_from) const {
        Quantity line = *this;
        line.turning = way;
        line.relative_meaning = seen_from;
        line.size = Size::unknown;
        return line;
    }
    constexpr Quantity followed_as(const char* other) const { return with(&Quantity::continuous, other); }
    constexpr Quantity sized(Size like) const { return with(&Quantity::size, like); }
    constexpr Quantity unless(std::string (*reason)(const Watched&, const Model&)) const {
        return with(&Quantity::lack, reason);
    }
    constexpr Quantity measured(const char* (*by)(const Watched&, const Model&)) const {
        return with(&Quantity::dimension_of, by);
    }
    constexpr Quantity with_strain_order() const { return with(&Quantity::has_strain_order, true); }
    constexpr Quantity about_a_point() const { return with(&Quantity::is_about, true); }
    constexpr Quantity from_no_load() const { return with(&Quantity::is_from_no_load, true); }
    constexpr Quantity by_search() const { return with(&Quantity::is_searched, true); }

    bool is_rotation() const { return columns == 4; }

  private:
    template <class Result>
    static constexpr int columns_of() {
        constexpr bool is_number = std::is_same_v<Result, double>;
        constexpr bool is_quaternion = std::is_same_v<Result, Quat>;
        constexpr bool is_stress = std::is_same_v<Result, Vec6>;
        constexpr bool is_in_section = std::is_same_v<Result, Eigen::Vector2d>;
        static_assert(is_number || is_quaternion || is_stress || is_in_section ||
                      std::is_same_v<Result, Vec3>);
        return is_number ? 1 : is_quaternion ? 4 : is_stress ? 6 : is_in_section ? 2 : 3;
    }
};

}  // namespace gxrod
