#include "deck/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "deck/suggestion.hpp"

namespace gxrod {
namespace {

std::vector<std::string> names_of(const std::vector<CheckedTable>& tables) {
    std::vector<std::string> names;
    for (const CheckedTable& table : tables) names.push_back(table.name);
    return names;
}

// The index of a name, or -1.
int index_of(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::optional<double> read_fraction(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    return is_number && value >= 0.0 && value <= 1.0 ? std::optional(value) : std::nullopt;
}

}  // namespace

PointNames::PointNames(const CheckedTable& deck)
    : rods_(names_of(deck.tables("rod"))), bodies_(names_of(deck.tables("body"))) {}

std::variant<Point, std::string> PointNames::find(const std::string& text) const {
    const std::size_t separator = text.find_first_of(".@");
    const std::string name = text.substr(0, separator);
    const int body = index_of(bodies_, name);
    const int rod = index_of(rods_, name);
    if (separator == std::string::npos) {
        if (body >= 0) return Point(BodyPoint{body});
        if (rod >= 0) {
            return fmt::format("\"{0}\" is a rod; expected a point of it: {0}.start, {0}.end or {0}@FRACTION",
                               name);
        }
    }
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

std::vector<std::string> PointNames::all_points() const {
    std::vector<std::string> points;
    for (const std::string& rod : rods_) {
        points.push_back(rod + ".start");
        points.push_back(rod + ".end");
    }
    points.insert(points.end(), bodies_.begin(), bodies_.end());
    return points;
}

}  // namespace gxrod
