#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"

namespace gxrod::test {

std::vector<RoundTrip> section_frame_trips() {
    const auto with = [](const std::string& line) {
        return replaced(rod_deck, "[rod.r]", line + "\n[rod.r]");
    };
    const auto entry = [](int row, int column) {
        return [=](const Problem& p) { return p.model.sections[0].stiffness(row, column); };
    };
    return {{"section.NAME.at",
             with("at = [0.5, 0.25]"),
             [=](const Problem& p) { return entry(0, 5)(p) == -5e3 && entry(0, 4)(p) == 2.5e3; }},
            {"section.NAME.turn", with("turn = \"pi/2\""), [=](const Problem& p) {
                 return std::abs(entry(4, 4)(p) - 700.0) < 1e-10;
             }}};
}

}  // namespace gxrod::test
