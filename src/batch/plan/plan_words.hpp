#pragma once

#include "deck/schema/choices.hpp"

// The words of a plan and what they mean.
namespace gxrod {

enum class Combination { grid, zip, latin_hypercube, table, decks };
enum class Spacing { linear, log };
enum class Keeping { all, failed, none };
enum class Take { least, largest, mean, rms, last, largest_absolute };
enum class Component { x, y, z, w, magnitude, xx, yy, zz, yz, xz, xy };

// `decks` has no word: it stands for a list of decks.
inline constexpr std::array<Choice<Combination>, 4> combination_choices{
    {{"grid", Combination::grid},
     {"zip", Combination::zip},
     {"latin-hypercube", Combination::latin_hypercube},
     {"table", Combination::table}}};
inline constexpr const auto& choices_of(Combination) { return combination_choices; }

inline constexpr std::array<Choice<Spacing>, 2> spacing_choices{
    {{"linear", Spacing::linear}, {"log", Spacing::log}}};
inline constexpr const auto& choices_of(Spacing) { return spacing_choices; }

inline constexpr std::array<Choice<Keeping>, 3> keeping_choices{
    {{"all", Keeping::all}, {"failed", Keeping::failed}, {"none", Keeping::none}}};
inline constexpr const auto& choices_of(Keeping) { return keeping_choices; }

inline constexpr std::array<Choice<Take>, 6> take_choices{{{"min", Take::least},
                                                           {"max", Take::largest},
                                                           {"mean", Take::mean},
                                                           {"rms", Take::rms},
                                                           {"final", Take::last},
                                                           {"max_abs", Take::largest_absolute}}};
inline constexpr const auto& choices_of(Take) { return take_choices; }

inline constexpr std::array<Choice<Component>, 11> component_choices{{{"x", Component::x},
                                                                      {"y", Component::y},
                                                                      {"z", Component::z},
                                                                      {"w", Component::w},
                                                                      {"magnitude", Component::magnitude},
                                                                      {"xx", Component::xx},
                                                                      {"yy", Component::yy},
                                                                      {"zz", Component::zz},
                                                                      {"yz", Component::yz},
                                                                      {"xz", Component::xz},
                                                                      {"xy", Component::xy}}};
inline constexpr const auto& choices_of(Component) { return component_choices; }

}  // namespace gxrod
