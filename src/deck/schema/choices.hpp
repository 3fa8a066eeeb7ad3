#pragma once

#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/expressions/table_function.hpp"
#include "laws/plastic_law.hpp"
#include "laws/strain_part.hpp"
#include "laws/working_shape.hpp"
#include "model/model.hpp"
#include "model/settings/scheme_card.hpp"
#include "model/settings/settings.hpp"
#include "model/ties/joint_card.hpp"

// The words of a deck and their meaning, each pair stated once.
namespace gxrod {

template <class Value>
struct Choice {
    std::string_view word;
    Value value;
};

inline constexpr std::array<Choice<ElementKind>, 2> element_kind_choices{
    {{"objective", ElementKind::objective}, {"simo", ElementKind::simo}}};

inline constexpr std::array<Choice<InputHold>, 2> input_hold_choices{
    {{"step", InputHold::step}, {"linear", InputHold::linear}}};

// Where a tendon with friction is pulled.
enum class TendonEnd { from, to };
inline constexpr std::array<Choice<TendonEnd>, 2> tendon_end_choices{
    {{"from", TendonEnd::from}, {"to", TendonEnd::to}}};

inline constexpr std::array<Choice<Frame>, 3> frame_choices{
    {{"spatial", Frame::spatial}, {"follower", Frame::follower}, {"body", Frame::body}}};

// The loads to which the load of a path can be relative.
enum class LoadReference { limit };
inline constexpr std::array<Choice<LoadReference>, 1> load_reference_choices{
    {{"limit", LoadReference::limit}}};

inline constexpr std::array<Choice<BushingAxes>, 4> bushing_axes_choices{{{"between", BushingAxes::between},
                                                                          {"a", BushingAxes::a},
                                                                          {"b", BushingAxes::b},
                                                                          {"ground", BushingAxes::ground}}};

inline constexpr std::array<Choice<Stretching>, 4> stretching_choices{
    {{"wheeler", Stretching::wheeler},
     {"vertical", Stretching::vertical},
     {"extrapolate", Stretching::extrapolate},
     {"none", Stretching::none}}};

// The side of an obstacle on which rods touch it.
enum class ObstacleSide { outside, inside };
inline constexpr std::array<Choice<ObstacleSide>, 2> obstacle_side_choices{
    {{"outside", ObstacleSide::outside}, {"inside", ObstacleSide::inside}}};

// A plane, by the axis across it: x, y or z.
enum class PlaneAcross { yz, xz, xy };
inline constexpr std::array<Choice<PlaneAcross>, 3> plane_choices{
    {{"yz", PlaneAcross::yz}, {"xz", PlaneAcross::xz}, {"xy", PlaneAcross::xy}}};

inline constexpr std::array<Choice<Interpolation>, 3> interpolation_choices{
    {{"linear", Interpolation::linear},
     {"cubic", Interpolation::cubic},
     {"monotone", Interpolation::monotone}}};

inline constexpr std::array<Choice<Linearization>, 2> linearization_choices{
    {{"elastic", Linearization::elastic}, {"loading", Linearization::loading}}};

// An integrator; without one the model decides (model/settings/scheme_choice.hpp).
struct OpenScheme {
    std::optional<Scheme> scheme = {};
    bool operator==(const OpenScheme&) const = default;
};
inline constexpr const char* open_scheme_word = "auto";
inline constexpr auto scheme_choices = [] {
    std::array<Choice<OpenScheme>, scheme_cards.size() + 1> choices{};
    for (std::size_t i = 0; i < scheme_cards.size(); ++i)
        choices[i] = {scheme_cards[i].word, {scheme_cards[i].scheme}};
    choices.back().word = open_scheme_word;
    return choices;
}();

inline constexpr auto joint_kind_choices = [] {
    std::array<Choice<JointKind>, joint_cards.size()> choices{};
    for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = {joint_cards[i].word, joint_cards[i].kind};
    return choices;
}();

inline constexpr std::array<Choice<TangentKind>, 6> tangent_choices{
    {{"automatic", TangentKind::automatic},
     {"mixed", TangentKind::mixed},
     {"consistent", TangentKind::consistent},
     {"kept", TangentKind::kept},
     {"paper", TangentKind::paper},
     {"difference", TangentKind::difference}}};

inline constexpr std::array<Choice<LinearSolverKind>, 4> linear_solver_choices{
    {{"auto", LinearSolverKind::automatic},
     {"chains", LinearSolverKind::chains},
     {"klu", LinearSolverKind::klu},
     {"umfpack", LinearSolverKind::umfpack}}};

inline constexpr std::array<Choice<CriticalSearch>, 3> critical_search_choices{
    {{"locate", CriticalSearch::locate}, {"report", CriticalSearch::report}, {"off", CriticalSearch::off}}};

inline constexpr std::array<Choice<StrainPart>, 8> strain_part_choices{{{"bending", StrainPart::bending},
                                                                        {"torsion", StrainPart::torsion},
                                                                        {"tension", StrainPart::tension},
                                                                        {"shear", StrainPart::shear},
                                                                        {"bending y", StrainPart::bending_y},
                                                                        {"bending z", StrainPart::bending_z},
                                                                        {"shear y", StrainPart::shear_y},
                                                                        {"shear z", StrainPart::shear_z}}};

inline constexpr std::array<Choice<YieldInteraction>, 2> yield_interaction_choices{
    {{"ellipsoid", YieldInteraction::ellipsoid}, {"none", YieldInteraction::none}}};

// Whether a moment follows its curve back.
enum class Hysteresis { none, kinematic };
inline constexpr std::array<Choice<Hysteresis>, 2> hysteresis_choices{
    {{"none", Hysteresis::none}, {"kinematic", Hysteresis::kinematic}}};

inline constexpr std::array<Choice<WorkingShape>, 3> working_shape_choices{
    {{"linear", WorkingShape::linear},
     {"quadratic", WorkingShape::quadratic},
     {"exponential", WorkingShape::exponential}}};

// A component of a displacement, or of a rotation.
enum class Direction { x, y, z };
inline constexpr std::array<Choice<Direction>, 3> direction_choices{
    {{"x", Direction::x}, {"y", Direction::y}, {"z", Direction::z}}};

inline constexpr std::array<Choice<Compression>, 2> compression_choices{
    {{"none", Compression::none}, {"deflate", Compression::deflate}}};

template <class Value, std::size_t count>
std::vector<std::string> words_of(const std::array<Choice<Value>, count>& choices) {
    std::vector<std::string> words;
    for (const Choice<Value>& choice : choices) words.emplace_back(choice.word);
    return words;
}

// The value of a word that the schema has let through.
template <class Value, std::size_t count>
Value value_of(const std::array<Choice<Value>, count>& choices, std::string_view word) {
    for (const Choice<Value>& choice : choices) {
        if (choice.word == word) return choice.value;
    }
    assert(false);
    return choices[0].value;
}

// The word of a value, for messages.
template <class Value, std::size_t count>
std::string word_of(const std::array<Choice<Value>, count>& choices, Value value) {
    for (const Choice<Value>& choice : choices) {
        if (choice.value == value) return std::string(choice.word);
    }
    assert(false);
    return "";
}

}  // namespace gxrod
