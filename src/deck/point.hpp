#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/checked_deck.hpp"

// Named points: flyer.start, flyer.end, flyer@0.25 of a rod, and bodies by their name.
namespace gxrod {

struct RodPoint {
    int rod;          // index in Model::rods
    double fraction;  // of the length, 0 to 1
};

struct BodyPoint {
    int body;  // index in Model::bodies
};

using Point = std::variant<RodPoint, BodyPoint>;

// The rods and bodies of a deck by name.
class PointNames {
  public:
    explicit PointNames(const CheckedTable& deck);

    // The point of a text, or what is wrong with the text.
    std::variant<Point, std::string> find(const std::string& text) const;

  private:
    std::variant<Point, std::string> find_rod_point(int rod,
                                                    const std::string& text,
                                                    std::size_t separator) const;
    std::vector<std::string> all_points() const;

    std::vector<std::string> rods_;
    std::vector<std::string> bodies_;
};

}  // namespace gxrod
