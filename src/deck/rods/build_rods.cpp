#include "deck/rods/build_rods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "deck/rods/build_centreline.hpp"
#include "deck/rods/build_nets.hpp"
#include "deck/rods/element_turn.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/sections/rest_shape.hpp"
#include "deck/sections/rod_sections.hpp"
#include "deck/sections/section_axes.hpp"
#include "deck/sections/section_twist.hpp"
#include "machine/reserve_more.hpp"
#include "mesh/rod_mesh.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// How many elements; nullopt, with a fault, if the deck does not say.
std::optional<long> find_element_count(const CheckedTable& rod, const BuildContext& context) {
    if (rod.gives("elements")) return rod.get<long>("elements");
    const KeySpec& spec = *rod_table().find("elements");
    context.add_fault(rod, "elements", "missing; expected " + describe_expected(spec));
    return std::nullopt;
}

// Elements shorter than points that are one are a fault.
bool are_apart(const std::vector<double>& fractions, const CheckedTable& rod, const BuildContext& context) {
    double least = 1.0;
    for (std::size_t i = 1; i < fractions.size(); ++i)
        least = std::min(least, fractions[i] - fractions[i - 1]);
    if (least > same_fraction) return true;
    context.add_fault(rod,
                      "spacing",
                      fmt::format("the shortest of {} elements has {:.2g} of the length of the rod; expected "
                                  "sizes nearer to each other",
                                  fractions.size() - 1,
                                  least));
    return false;
}

std::vector<double> find_fractions(const CheckedTable& rod,
                                   const RodBreaks& breaks,
                                   const BuildContext& context) {
    const std::optional<long> elements = find_element_count(rod, context);
    if (!elements) return {};
    std::vector<double> fractions = compute_element_fractions(breaks, *elements);
    if (fractions.empty()) {
        const char* between = breaks.corners.empty() ? "the points that the deck names"
                                                     : "corners and the points that the deck names";
        context.add_fault(rod,
                          "elements",
                          fmt::format("expected at least {}, one for each piece between {}, found {}",
                                      count_pieces(breaks),
                                      between,
                                      *elements));
    } else if (!breaks.grading.is_even() && !are_apart(fractions, rod, context)) {
        return {};
    }
    return fractions;
}

std::string name_node(const std::string& rod, double fraction, std::size_t position, bool is_named) {
    if (position == 0) return rod + ".start";
    if (fraction == 1.0) return rod + ".end";
    return is_named ? fmt::format("{}@{:.9g}", rod, fraction) : fmt::format("{} node {}", rod, position);
}

Grading find_grading(const CheckedTable& rod) {
    return rod.gives("spacing") ? Grading(rod.get<CheckedProfile>("spacing").rows) : Grading();
}

bool is_near_any(double fraction, const std::vector<double>& points) {
    return std::any_of(points.begin(), points.end(), [&](double point) {
        return std::abs(point - fraction) <= 2.0 * same_fraction;
    });
}

// Adds the nodes and elements of one rod along its centreline.
class LineBuilder {
  public:
    LineBuilder(const Centreline& line,
                const Quat& start_axes,
                const SectionTwist& twist,
                const std::vector<double>& points,
                int index,
                BuildContext& context)
        : line_(line),
          start_axes_(start_axes),
          twist_(twist),
          points_(points),
          rod_(context.model.rods[static_cast<std::size_t>(index)]),
          nodes_(context.model.nodes),
          fractions_(context.rod_fractions[static_cast<std::size_t>(index)]),
          twists_(context.rod_twists[static_cast<std::size_t>(index)]) {}

    // The section axes on a piece of the line, at a fraction of its length.
    std::function<Quat(std::size_t, double)> axes() const {
        return [this](std::size_t piece, double fraction) {
            return twisted(line_.transport(piece, fraction) * start_axes_, twist_.at(fraction));
        };
    }

    // The largest turn within one of the elements that were added.
    double largest_turn() const { return largest_turn_; }

    void add(const std::vector<double>& element_fractions) {
        rod_.length = line_.length();
        const std::vector<double> within = compute_element_nodes(rod_.order);
        reserve(element_fractions.size() - 1);
        for (std::size_t e = 0; e + 1 < element_fractions.size(); ++e) {
            const double first = element_fractions[e];
            const double last = element_fractions[e + 1];
            const std::size_t piece = line_.piece_at(0.5 * (first + last));
            largest_turn_ =
                std::max(largest_turn_,
                         compute_element_turn(line_.turn(piece, first, last), twist_.between(first, last)));
            for (std::size_t i = 0; i < within.size(); ++i) {
                const bool is_last = i + 1 == within.size();
                const double fraction = is_last ? last : first + (last - first) * within[i];
                if (e == 0 || i > 0) add_node(piece, fraction);
                add_entry(piece, fraction);
            }
        }
    }

  private:
    void reserve(std::size_t elements) {
        const auto order = static_cast<std::size_t>(rod_.order);
        rod_.nodes.reserve(elements * order + 1);
        fractions_.reserve(elements * order + 1);
        twists_.reserve(elements * order + 1);
        reserve_more(elements * order + 1, nodes_);
        rod_.element_nodes.reserve(elements * (order + 1));
        rod_.arc_length.reserve(elements * (order + 1));
        rod_.triads.reserve(elements * (order + 1));
    }

    void add_node(std::size_t piece, double fraction) {
        const std::size_t position = rod_.nodes.size();
        rod_.nodes.push_back(static_cast<int>(nodes_.size()));
        fractions_.push_back(fraction);
        twists_.push_back(twist_.at(fraction));
        nodes_.push_back({name_node(rod_.name, fraction, position, is_near_any(fraction, points_)),
                          line_.position(piece, fraction)});
    }

    void add_entry(std::size_t piece, double fraction) {
        rod_.element_nodes.push_back(rod_.nodes.back());
        rod_.arc_length.push_back(fraction * line_.length());
        rod_.triads.push_back(axes()(piece, fraction));
    }

    const Centreline& line_;
    const Quat& start_axes_;
    const SectionTwist& twist_;
    const std::vector<double>& points_;
    Rod& rod_;
    std::vector<Node>& nodes_;
    std::vector<double>& fractions_;  // of nodes
    std::vector<double>& twists_;     // there
    double largest_turn_ = 0.0;
};

// What varies along a rod.
struct Variation {
    std::vector<Station> stations;
    SectionTwist twist;
};

void build_line(const CheckedTable& table,
                const Variation& along,
                std::vector<double> points,
                int index,
                BuildContext& context) {
    const std::vector<double> jumps = find_jumps(along.stations);
    points.insert(points.end(), jumps.begin(), jumps.end());
    const std::optional<Centreline> line = find_centreline(table, table, context);
    const std::optional<RestCurve> rest = find_rest_curve(table, along.twist, context);
    RodBreaks breaks{points, line ? line->corners() : std::vector<double>{}, find_grading(table)};
    if (rest) add_corners(rest->line.corners(), breaks);
    const std::vector<double> fractions = find_fractions(table, breaks, context);
    if (!line) return;
    const std::optional<Quat> axes = find_start_axes(table, line->start_tangent(), context);
    if (!axes || fractions.empty()) return;
    const auto order = static_cast<int>(table.get<long>("order"));
    Rod& rod = context.model.rods[static_cast<std::size_t>(index)];
    rod.order = order;
    LineBuilder builder(*line, *axes, along.twist, points, index, context);
    builder.add(fractions);
    if (rest) {
        set_rest(table, *rest, fractions, rod, context);
    } else {
        set_rest(table, {*line, builder.axes()}, fractions, rod, context);
    }
    set_sections(along.stations, fractions, rod, context);
    check_element_turn(builder.largest_turn(), order, table, "elements", context);
}

}  // namespace

void build_rods(const std::vector<RodPoint>& points,
                const RodNets& nets,
                const SectionFiles& files,
                BuildContext& context) {
    const std::vector<CheckedTable>& tables = context.deck.tables("rod");
    std::vector<std::vector<double>> fractions(tables.size());
    for (const RodPoint& point : points) fractions[point.rod].push_back(point.fraction);
    context.model.rods.resize(tables.size());
    context.rod_fractions.resize(tables.size());
    context.rod_twists.resize(tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const CheckedTable& table = tables[i];
        Rod& rod = context.model.rods[i];
        rod.name = table.name;
        const int index = static_cast<int>(i);
        const SectionFile* file = files.contains(index) ? &files.at(index) : nullptr;
        const std::vector<Station> stations = find_stations(table, file, context);
        rod.section = stations.front().section;
        rod.kind = value_of(element_kind_choices, table.get<std::string>("element"));
        if (table.gives("mesh") && stations.size() > 1) {
            context.add_fault(table,
                              table.gives("section") ? "section" : "sections",
                              "a rod from a mesh has one section, the same everywhere and without s");
        }
        if (!table.gives("mesh")) {
            build_line(table, {stations, find_twist(table, file, context)}, fractions[i], index, context);
        } else if (check_meshed_rod(table, context); nets.contains(index)) {
            build_net(table, nets.at(index), index, context);
        }
    }
}

}  // namespace gxrod
