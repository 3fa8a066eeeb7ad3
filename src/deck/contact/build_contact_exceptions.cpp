#include "deck/contact/build_contact_exceptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "deck/places/name_pattern.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/suggestion.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

using Fractions = std::pair<double, double>;

std::vector<std::string> list_partner_names(const Model& model) {
    std::vector<std::string> names;
    for (const Rod& rod : model.rods) names.push_back(rod.name);
    for (const Obstacle& obstacle : model.contact.obstacles) names.push_back(obstacle.name);
    for (const int body : model.contact.touching_bodies())
        names.push_back(model.bodies[static_cast<std::size_t>(body)].name);
    return names;
}

// "0.9..1".
std::optional<Fractions> read_range(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const auto read = [](std::string_view part, double& value) {
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && end == part.data() + part.size();
    };
    Fractions range;
    if (!read(text.substr(0, dots), range.first) || !read(text.substr(dots + 2), range.second))
        return std::nullopt;
    const bool is_within = 0.0 <= range.first && range.first < range.second && range.second <= 1.0;
    return is_within ? std::optional(range) : std::nullopt;
}

// The fraction of a rod nearest to this one at which elements end; of a rod without elements, whose mesh is
// at fault, there is nothing to say.
double find_nearest_end(const Rod& rod, double fraction) {
    if (rod.element_count() == 0) return fraction;
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    double nearest = 0.0;
    for (std::size_t last = nodes - 1; last < rod.arc_length.size(); last += nodes) {
        const double end = rod.arc_length[last] / rod.length;
        if (std::abs(end - fraction) < std::abs(nearest - fraction)) nearest = end;
    }
    return nearest;
}

// What a text names; none, with a fault, if that is nothing.
std::vector<ContactPart> find_side(const CheckedWord& word, const BuildContext& context) {
    const auto add_fault = [&](const std::string& message) {
        context.faults.add(word.place, word.path, message);
        return std::vector<ContactPart>();
    };
    const Model& model = context.model;
    const std::size_t at = word.word.find('@');
    const std::string pattern = word.word.substr(0, at);
    std::optional<Fractions> range;
    if (at != std::string::npos) {
        range = read_range(std::string_view(word.word).substr(at + 1));
        if (!range)
            return add_fault(
                fmt::format("expected two rising fractions from 0 to 1 after \"@\", such as \"{}@0.9..1\", "
                            "found \"{}\"",
                            pattern,
                            word.word.substr(at + 1)));
    }
    std::vector<ContactPart> parts;
    const auto tables = rods_of(context.deck);
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        const Rod& rod = model.rods[i];
        if (!matches_pattern(rod.name, pattern)) continue;
        ContactPart part{.index = static_cast<int>(i)};
        if (range) {
            if (tables[i].get().mesh && context.rod_fractions[i].empty())
                return add_fault(fmt::format(
                    "rod {} is no single line with two ends, along which a fraction has a meaning",
                    rod.name));
            for (const double end : {range->first, range->second}) {
                const double nearest = find_nearest_end(rod, end);
                if (std::abs(nearest - end) <= 2.0 * same_fraction) continue;
                return add_fault(fmt::format(
                    "no element of \"{}\" ends at {:.9g}; expected a part from an end of an element to "
                    "another one, as its mesh has them: the nearest is at {:.9g}",
                    rod.name,
                    end,
                    nearest));
            }
            std::tie(part.from, part.to) = *range;
        }
        parts.push_back(part);
    }
    for (const int body : model.contact.touching_bodies()) {
        const std::string& name = model.bodies[static_cast<std::size_t>(body)].name;
        if (!matches_pattern(name, pattern)) continue;
        if (range && pattern.find('*') == std::string::npos)
            return add_fault(fmt::format("\"{}\" is a body; only rods have parts", pattern));
        if (!range) parts.push_back({.index = static_cast<int>(model.rods.size()) + body});
    }
    for (std::size_t i = 0; i < model.contact.obstacles.size(); ++i) {
        if (!matches_pattern(model.contact.obstacles[i].name, pattern)) continue;
        if (range && pattern.find('*') == std::string::npos)
            return add_fault(fmt::format("\"{}\" is an obstacle; only rods have parts", pattern));
        if (!range) parts.push_back({.index = -1 - static_cast<int>(i)});
    }
    if (!parts.empty()) return parts;
    const std::vector<std::string> names = list_partner_names(model);
    std::string hint = did_you_mean(pattern, names);
    if (hint.empty()) hint = "; the deck has " + plain_list(names);
    return add_fault(fmt::format("no rod and no obstacle \"{}\"{}", pattern, hint));
}

// Whether the settings of all contact let them touch.
bool can_touch(const Contact& contact, int a, int b) {
    const auto touches = [&](int index) {
        const auto rod = static_cast<std::size_t>(std::max(index, 0));
        return index < 0 || rod >= contact.radii.size() || contact.radii[rod] > 0.0;
    };
    if (!touches(a) || !touches(b) || (a < 0 && b < 0)) return false;
    if (a == b && static_cast<std::size_t>(a) >= contact.radii.size()) return false;
    if (a < 0 || b < 0) return true;
    return a == b ? contact.within_rods : contact.between_rods;
}

bool has_touching(const ContactException& one, const Contact& contact) {
    return std::ranges::any_of(one.between[0], [&](const ContactPart& a) {
        return std::ranges::any_of(
            one.between[1], [&](const ContactPart& b) { return can_touch(contact, a.index, b.index); });
    });
}

}  // namespace

std::vector<RodPoint> list_contact_part_ends(const BuildContext& context) {
    std::vector<RodPoint> ends;
    const auto rods = rods_of(context.deck);
    const auto add = [&](const CheckedWord& word) {
        const std::size_t at = word.word.find('@');
        if (at == std::string::npos) return;
        const std::optional<Fractions> range = read_range(std::string_view(word.word).substr(at + 1));
        for (std::size_t i = 0; range && i < rods.size(); ++i) {
            const RodTable& rod = rods[i];
            if (rod.mesh || !matches_pattern(rod.name, word.word.substr(0, at))) continue;
            for (const double end : {range->first, range->second}) {
                if (end > 0.0 && end < 1.0) ends.push_back({static_cast<int>(i), end});
            }
        }
    };
    const ContactKeys* contact = find_contact(context.deck);
    if (contact == nullptr) return ends;
    for (const ContactPairTable& pair : contact->pairs) {
        for (const CheckedWord& word : pair.between) add(word);
    }
    return ends;
}

std::vector<ContactException> build_contact_exceptions(const ContactKeys& contact,
                                                       const BuildContext& context) {
    std::vector<ContactException> exceptions;
    for (const ContactPairTable& table : contact.pairs) {
        ContactException one;
        const Partners& words = table.between;
        for (std::size_t side = 0; side < 2; ++side) one.between[side] = find_side(words[side], context);
        if (one.between[0].empty() || one.between[1].empty()) continue;
        if (table.friction) {
            const ContactFriction friction = find_contact_friction(table.friction, context);
            one.friction = friction.coefficient;
            one.friction_shape = friction.shape;
        }
        one.restitution = table.restitution;
        one.is_off = table.off.value_or(false);
        if (!has_touching(one, context.model.contact))
            context.add_fault(table,
                              table.between,
                              fmt::format("\"{}\" and \"{}\" do not touch: [contact] leaves them out",
                                          words[0].word,
                                          words[1].word));
        exceptions.push_back(std::move(one));
    }
    return exceptions;
}

bool is_left_out(const Contact& contact, int a, int b) {
    bool is_off = false;
    for (const ContactException& one : contact.exceptions) {
        if (one.restitution && !one.friction) continue;
        bool fits = false, is_whole = false;
        for (const auto& [own, other] : {std::pair(0, 1), std::pair(1, 0)}) {
            for (const ContactPart& x : one.between[static_cast<std::size_t>(own)]) {
                for (const ContactPart& y : one.between[static_cast<std::size_t>(other)]) {
                    if (x.index != a || y.index != b) continue;
                    fits = true;
                    is_whole = is_whole || (x.from == 0.0 && x.to == 1.0 && y.from == 0.0 && y.to == 1.0);
                }
            }
        }
        if (fits && !one.is_off) is_off = false;
        if (is_whole && one.is_off) is_off = true;
    }
    return is_off;
}

}  // namespace gxrod
