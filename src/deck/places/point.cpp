#include "deck/places/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "deck/places/name_pattern.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {
namespace {

constexpr const char* any_fraction = "@FRACTION";
// How near a node of a mesh must be to a fraction of the length.
constexpr double mesh_fraction = 1e-6;

std::vector<std::string> names_of(const std::vector<CheckedTable>& tables) {
    std::vector<std::string> names;
    for (const CheckedTable& table : tables) names.push_back(table.name);
    return names;
}

using NameIndex = std::unordered_map<std::string, int>;

NameIndex index(const std::vector<std::string>& names) {
    NameIndex indices;
    for (const std::string& name : names) indices.emplace(name, static_cast<int>(indices.size()));
    return indices;
}

// The index of a name, or -1.
int index_of(const NameIndex& indices, const std::string& name) {
    const auto found = indices.find(name);
    return found == indices.end() ? -1 : found->second;
}

// "a, b or c".
std::string alternatives(std::vector<std::string> words) {
    if (words.empty()) return "a point that the mesh names, a 0-dimensional physical group";
    const std::string last = words.back();
    words.pop_back();
    return words.empty() ? last : plain_list(words) + " or " + last;
}

std::size_t nearest_index(const std::vector<double>& fractions, double fraction) {
    const auto nearest = std::min_element(fractions.begin(), fractions.end(), [&](double a, double b) {
        return std::abs(a - fraction) < std::abs(b - fraction);
    });
    return static_cast<std::size_t>(nearest - fractions.begin());
}

std::optional<double> read_fraction(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    return is_number && value >= 0.0 && value <= 1.0 ? std::optional(value) : std::nullopt;
}

}  // namespace

PointNames::PointNames(const CheckedTable& deck, std::map<int, NetPoints> nets)
    : rods_(names_of(deck.tables("rod"))),
      bodies_(names_of(deck.tables("body"))),
      rod_index_(index(rods_)),
      body_index_(index(bodies_)),
      nets_(std::move(nets)) {
    for (const RodTable& rod : rods_of(deck)) is_meshed_.push_back(rod.mesh.has_value());
}

std::variant<Point, std::string> PointNames::find(const std::string& text, PointNeeds needs) const {
    const std::size_t separator = text.find_first_of(".@");
    const std::string name = text.substr(0, separator);
    const int body = index_of(body_index_, name);
    const int rod = index_of(rod_index_, name);
    if (separator == std::string::npos) {
        if (body >= 0) return Point(BodyPoint{body});
        if (rod >= 0) {
            return fmt::format(
                "\"{}\" is a rod; expected a point of it: {}", name, alternatives(points_of(rod)));
        }
    }
    if (rod >= 0 && is_meshed_[static_cast<std::size_t>(rod)])
        return find_net_point(rod, text, separator, needs);
    if (rod >= 0) return find_rod_point(rod, text, separator);
    if (body >= 0) return fmt::format("\"{0}\" is a body; its point is \"{0}\"", name);
    std::string hint = did_you_mean(text, all_points());
    if (hint.empty() && separator != std::string::npos) {
        const std::string nearest = nearest_spelling(name, rods_);
        if (!nearest.empty()) hint = fmt::format("; did you mean \"{}{}\"?", nearest, text.substr(separator));
    }
    if (hint.empty()) hint = "; the deck has " + plain_list(all_points());
    return fmt::format("no point \"{}\"{}", text, hint);
}

std::vector<int> PointNames::find_rods(std::string_view pattern) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < rods_.size(); ++i) {
        if (matches_pattern(rods_[i], pattern)) found.push_back(static_cast<int>(i));
    }
    return found;
}

// The nodes of a rod in a group of its mesh; none if the text names no group.
std::vector<NamedPoint> PointNames::find_group(int rod, const std::string& text) const {
    std::vector<NamedPoint> found;
    const auto net = nets_.find(rod);
    if (net == nets_.end()) return found;
    const auto& [groups, fractions] = net->second;
    const std::string name = text.substr(rods_[rod].size() + 1);
    const auto group = std::ranges::find(groups, name, &NetPoints::Group::name);
    if (group == groups.end()) return found;
    for (const int position : group->positions) {
        const double fraction = fractions.empty() ? 0.0 : fractions[static_cast<std::size_t>(position)];
        found.push_back({fmt::format("{} node {}", text, position), RodPoint{rod, fraction, position}});
    }
    return found;
}

// Points of rods whose names match what stands before the . or @, and bodies.
std::vector<NamedPoint> PointNames::match(const std::string& text, PointNeeds needs) const {
    std::vector<NamedPoint> found;
    const std::size_t separator = std::min(text.find_first_of(".@"), text.size());
    if (separator == text.size()) {
        for (const std::string& body : bodies_) {
            if (matches_pattern(body, text)) found.push_back({body, BodyPoint{index_of(body_index_, body)}});
        }
        return found;
    }
    const std::string part = text.substr(separator);
    const auto add = [&](const std::string& one) {
        const auto point = find(one, needs);
        if (const auto* known = std::get_if<Point>(&point)) found.push_back({one, *known});
    };
    for (const int rod : find_rods(text.substr(0, separator))) {
        if (part.find('*') == std::string::npos) {
            const std::vector<NamedPoint> group = find_group(rod, rods_[rod] + part);
            found.insert(found.end(), group.begin(), group.end());
            if (group.empty()) add(rods_[rod] + part);
            continue;
        }
        for (const std::string& one : points_of(rod)) {
            if (!one.ends_with(any_fraction) && matches_pattern(one, rods_[rod] + part)) add(one);
        }
    }
    return found;
}

std::variant<std::vector<NamedPoint>, std::string> PointNames::find_all(const std::string& text,
                                                                        PointNeeds needs) const {
    const bool is_pattern = text.find('*') != std::string::npos;
    const std::size_t separator = text.find_first_of(".@");
    const int rod = index_of(rod_index_, text.substr(0, separator));
    std::vector<NamedPoint> found;
    if (is_pattern) found = match(text, needs);
    if (!is_pattern && rod >= 0 && separator != std::string::npos) found = find_group(rod, text);
    if (!found.empty()) return found;
    if (is_pattern)
        return fmt::format("no point matches \"{}\"; the deck has {}", text, plain_list(all_points()));
    const std::variant<Point, std::string> one = find(text, needs);
    if (const auto* message = std::get_if<std::string>(&one)) return *message;
    return std::vector{NamedPoint{text, std::get<Point>(one)}};
}

std::variant<Point, std::string> PointNames::find_rod_point(int rod,
                                                            const std::string& text,
                                                            std::size_t separator) const {
    const std::string part = text.substr(separator);
    if (part == ".start") return Point(RodPoint{rod, 0.0});
    if (part == ".end") return Point(RodPoint{rod, 1.0});
    if (part[0] == '@') {
        if (const auto fraction = read_fraction(std::string_view(part).substr(1))) {
            return Point(RodPoint{rod, *fraction});
        }
        return fmt::format("expected a fraction from 0 to 1 after \"@\", found \"{}\"", part.substr(1));
    }
    const std::string& name = rods_[rod];
    const std::string hint = did_you_mean(text, {name + ".start", name + ".end"});
    return fmt::format(
        "no point \"{}\"{}",
        text,
        hint.empty() ? fmt::format("; a rod has {0}.start, {0}.end and {0}@FRACTION", name) : hint);
}

std::variant<Point, std::string> PointNames::find_net_point(int rod,
                                                            const std::string& text,
                                                            std::size_t separator,
                                                            PointNeeds needs) const {
    const auto net = nets_.find(rod);
    // The mesh is at fault, and its points are unknown.
    if (net == nets_.end()) return Point(RodPoint{rod, 0.0});
    const auto& [groups, fractions] = net->second;
    const std::string part = text.substr(separator + 1);
    const auto point = [&](std::size_t position) {
        const double fraction = fractions.empty() ? 0.0 : fractions[position];
        return Point(RodPoint{rod, fraction, static_cast<int>(position)});
    };
    if (text[separator] == '@') {
        if (fractions.empty()) {
            return fmt::format(
                "rod {} is no single line with two ends, along which a fraction has a meaning; {}",
                rods_[rod],
                "expected " + alternatives(points_of(rod)));
        }
        const auto fraction = read_fraction(part);
        if (!fraction) return fmt::format("expected a fraction from 0 to 1 after \"@\", found \"{}\"", part);
        const std::size_t nearest = nearest_index(fractions, *fraction);
        if (std::abs(fractions[nearest] - *fraction) <= mesh_fraction) return point(nearest);
        if (needs == PointNeeds::place) return Point(RodPoint{rod, *fraction});
        return fmt::format(
            "the mesh has no node at {}; the nearest is at {:.9g}", *fraction, fractions[nearest]);
    }
    for (const NetPoints::Group& group : groups) {
        if (group.name != part) continue;
        if (group.positions.size() == 1) return point(static_cast<std::size_t>(group.positions.front()));
        return fmt::format(
            "the mesh's group \"{}\" has {} nodes of this rod; expected one with a single node",
            part,
            group.positions.size());
    }
    if (!fractions.empty() && part == "start") return point(nearest_index(fractions, 0.0));
    if (!fractions.empty() && part == "end") return point(nearest_index(fractions, 1.0));
    const std::string hint = did_you_mean(text, points_of(rod));
    return fmt::format(
        "no point \"{}\"{}", text, hint.empty() ? "; the rod has " + plain_list(points_of(rod)) : hint);
}

std::vector<std::string> PointNames::points_of(int rod) const {
    const std::string& name = rods_[rod];
    const auto net = nets_.find(rod);
    if (net == nets_.end()) return {name + ".start", name + ".end", name + any_fraction};
    std::vector<std::string> points;
    if (!net->second.fractions.empty()) points = {name + ".start", name + ".end", name + any_fraction};
    for (const NetPoints::Group& group : net->second.groups) {
        if (group.positions.size() == 1) points.push_back(name + "." + group.name);
    }
    return points;
}

std::vector<std::string> PointNames::all_points() const {
    std::vector<std::string> points;
    for (int rod = 0; rod < static_cast<int>(rods_.size()); ++rod) {
        for (const std::string& point : points_of(rod)) {
            if (!point.ends_with(any_fraction)) points.push_back(point);
        }
    }
    points.insert(points.end(), bodies_.begin(), bodies_.end());
    return points;
}

}  // namespace gxrod
