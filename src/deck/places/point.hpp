#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "deck/reading/checked_deck.hpp"

// Named points: flyer.start, flyer.end, flyer@0.25 of a rod, truss.top of a rod from a mesh, and bodies by
// their name.
namespace gxrod {

struct RodPoint {
    int rod;            // index in Model::rods
    double fraction;    // fraction of the length, 0 to 1
    int position = -1;  // index in Rod::nodes of a rod from a mesh, which has its nodes already
};

// The points of a rod from a mesh.
struct NetPoints {
    struct Group {
        std::string name;
        std::vector<int> positions;  // indices in Rod::nodes; a point only if it is one
    };

    std::vector<Group> groups;  // 0-dimensional physical groups that have nodes on the rod
    std::vector<double>
        fractions;  // fractions of the length, by index in Rod::nodes; none if the rod has no two ends
};

struct BodyPoint {
    int body;  // index in Model::bodies
};

using Point = std::variant<RodPoint, BodyPoint>;

// A point and how texts name it.
struct NamedPoint {
    std::string text;
    Point point;
};

// Whether a rod from a mesh must have a node at a fraction; other rods get one there.
enum class PointNeeds { node, place };

// The rods and bodies of a deck by name.
class PointNames {
  public:
    // `nets` has an entry for each rod of the deck with a mesh, by the index of the rod.
    explicit PointNames(const CheckedTable& deck, std::map<int, NetPoints> nets = {});

    // Finds the point of a text, or the fault of the text.
    std::variant<Point, std::string> find(const std::string& text, PointNeeds needs = PointNeeds::node) const;

    // Finds the points of a text in which * stands for any letters, or of a mesh's group of several nodes;
    // the fault of the text if there is no point.
    std::variant<std::vector<NamedPoint>, std::string> find_all(const std::string& text,
                                                                PointNeeds needs = PointNeeds::node) const;

    // Finds the rods whose names match a text, by index.
    std::vector<int> find_rods(std::string_view pattern) const;

    bool is_meshed(int rod) const { return is_meshed_[static_cast<std::size_t>(rod)]; }

  private:
    std::vector<NamedPoint> match(const std::string& text, PointNeeds needs) const;
    std::vector<NamedPoint> find_group(int rod, const std::string& text) const;
    std::variant<Point, std::string> find_rod_point(int rod,
                                                    const std::string& text,
                                                    std::size_t separator) const;
    std::variant<Point, std::string> find_net_point(int rod,
                                                    const std::string& text,
                                                    std::size_t separator,
                                                    PointNeeds needs) const;
    std::vector<std::string> points_of(int rod) const;
    std::vector<std::string> all_points() const;

    std::vector<std::string> rods_;
    std::vector<std::string> bodies_;
    std::unordered_map<std::string, int> rod_index_;
    std::unordered_map<std::string, int> body_index_;
    std::vector<bool> is_meshed_;  // by rod
    std::map<int, NetPoints> nets_;
};

}  // namespace gxrod
