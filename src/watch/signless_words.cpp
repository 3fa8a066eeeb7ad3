#include "watch/signless_words.hpp"

#include <algorithm>
#include <array>

namespace gxrod {
namespace {

struct Signless {
    std::string_view word, instead;
};

constexpr std::string_view stress_at_a_point =
    R"(quantity = "stress" and a component, such as "xx", of a history with point = [y, z])";
constexpr std::array signless_quantities{
    Signless{"von_mises", stress_at_a_point},
    Signless{"principal_stress", stress_at_a_point},
    Signless{"exposure", stress_at_a_point},
    Signless{"bending_moment", R"(quantity = "moment" and component "y" or "z")"},
    Signless{"shear_force", R"(quantity = "force" and component "y" or "z")"}};

}  // namespace

std::string_view find_signed_instead(std::string_view word) {
    const auto found = std::ranges::find(signless_quantities, word, &Signless::word);
    return found == signless_quantities.end() ? "" : found->instead;
}

bool is_exposure(std::string_view word) { return word == "exposure"; }

}  // namespace gxrod
