#include "check/findings/contact_findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "assembly/contact/contact_lines.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/element_geometry.hpp"
#include "assembly/system.hpp"
#include "check/motions/free_parts.hpp"
#include "loads/shape_functions.hpp"
#include "model/settings/analysis_traits.hpp"
#include "numerics/lagrange.hpp"

namespace gxrod {
namespace {

double radius_of(const Model& model, std::size_t rod) { return model.contact.radii[rod]; }

// What the tangent turns by from one element to the next, if a line is bent to this radius and its nodes are
// on the circle.
double find_kink(int order, double length, double radius) {
    const double half = 0.5 * length / radius;
    const ShapeValues shapes = find_shape_functions(order)(1.0);
    double along = 0.0, across = 0.0;
    visit_node_count(order, [&](auto count) {
        const auto at = compute_node_positions<count>();
        for (int i = 0; i < count; ++i) {
            along += shapes.slope[static_cast<std::size_t>(i)] * std::sin(half * at[i]);
            across += shapes.slope[static_cast<std::size_t>(i)] * (1.0 - std::cos(half * at[i]));
        }
    });
    return 2.0 * std::abs(half - std::atan2(across, along));
}

// The tightest bend that contact can make of a rod: about what bulges, or as much as the deck expects of rods
// that touch each other; infinite where planes are all there is.
double find_bend(const Model& model, std::size_t rod) {
    double bend = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : model.contact.obstacles) {
        const RoundShape* round = obstacle.round();
        if (round == nullptr || round->is_hollow || round->radius == 0.0) continue;
        bend = std::min(bend, round->radius + radius_of(model, rod));
    }
    if (model.contact.between_rods || model.contact.within_rods)
        bend = std::min(bend, std::max(model.contact.bend_radii[rod], radius_of(model, rod)));
    return bend;
}

void note_kinks(const Model& model, std::vector<Finding>& findings) {
    constexpr double tolerable = 4.0 * std::numbers::pi / 180.0;
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        const Rod& rod = model.rods[i];
        if (radius_of(model, i) == 0.0 || rod.element_count() == 0) continue;
        const double bend = find_bend(model, i);
        const double length = rod.length / rod.element_count();
        // No bend closes more than a circle.
        const double turned = std::min(length, std::numbers::pi * bend);
        if (!std::isfinite(bend) || find_kink(rod.order, turned, bend) <= tolerable) continue;
        int elements = rod.element_count();
        const int order = std::max(rod.order, 2);
        while (find_kink(order, std::min(rod.length / elements, std::numbers::pi * bend), bend) > tolerable)
            elements += std::max(1, elements / 20);
        findings.push_back(
            {Severity::note,
             fmt::format(
                 "elements of \"{}\" are {:.3g} radii long: bent to a radius of {:.3g}, as contact can "
                 "bend them, they meet at kinks of {:.0f} degrees; {} elements of order {} would do",
                 rod.name,
                 length / radius_of(model, i),
                 bend,
                 find_kink(rod.order, turned, bend) * 180.0 / std::numbers::pi,
                 elements,
                 order)});
    }
}

void find_overlaps(const Contacts& contacts, const State& state, std::vector<Finding>& findings) {
    const std::string overlap = contacts.describe_overlap(state, 0.0);
    if (!overlap.empty()) findings.push_back({Severity::error, "at the start " + overlap});
}

void note_touches(const Model& model,
                  const std::vector<ContactTouch>& touches,
                  std::vector<Finding>& findings) {
    if (touches.empty()) return;
    const auto at_obstacles =
        std::ranges::count_if(touches, [](const ContactTouch& one) { return one.rods[1] < 0; });
    const auto of_rods = std::ssize(touches) - at_obstacles;
    const auto counted = [](std::ptrdiff_t count, const char* one, const char* several) {
        return count == 0 ? "" : fmt::format("{} {}", count, count == 1 ? one : several);
    };
    const std::string first =
        model.contact.bodies.empty()
            ? counted(at_obstacles, "place of a rod and an obstacle", "places of rods and obstacles")
            : counted(at_obstacles, "place at an obstacle", "places at obstacles");
    const std::string second = counted(of_rods, "pair of elements", "pairs of elements");
    const double nearest = std::ranges::min(touches, {}, &ContactTouch::gap).gap;
    findings.push_back({Severity::note,
                        fmt::format("within the skin at the start, so that they push each other: {}{}{}; the "
                                    "least gap is {:.3g}",
                                    first,
                                    first.empty() || second.empty() ? "" : " and ",
                                    second,
                                    nearest)});
}

// A static analysis has no stiffness for what contact is to hold but does not touch yet.
void find_held_by_contact(const Model& model,
                          const std::vector<ContactTouch>& touches,
                          std::vector<Finding>& findings) {
    std::vector<std::string> far;
    for (const auto& [part, motions] : find_free_parts(model)) {
        if (!can_contact_hold(part, model)) continue;
        const auto has = [&, &rods = part.rods](int index) {
            return index >= 0 && std::ranges::binary_search(rods, index);
        };
        const bool touches_others = std::ranges::any_of(
            touches, [&](const ContactTouch& one) { return has(one.rods[0]) != has(one.rods[1]); });
        if (!touches_others) {
            far.push_back(name_part(part, model));
        } else {
            findings.push_back({Severity::note,
                                fmt::format("contact alone holds {}, from the first step on: with friction "
                                            "or in a hollow, or it slides away",
                                            name_part(part, model))});
        }
    }
    if (far.empty()) return;
    constexpr std::size_t most_named = 4;
    const std::size_t named = std::min(far.size(), most_named);
    std::string names =
        fmt::format("{}", fmt::join(far.begin(), far.begin() + static_cast<std::ptrdiff_t>(named), ", "));
    if (far.size() > named) names += fmt::format(" and {} more", far.size() - named);
    const char* touch = far.size() == 1 ? "touches" : "touch";
    findings.push_back(
        {Severity::warning,
         fmt::format("{} {} nothing at the start, and contact alone is to hold {}: a static analysis has no "
                     "stiffness for that until it touches; use kind = \"dynamic\", support it, or start "
                     "within the skin",
                     names,
                     touch,
                     far.size() == 1 ? "it" : "them")});
}

void note_meetings(const Model& model, std::vector<Finding>& findings) {
    const std::vector<RodMeeting> meetings = find_contact_lines(model).meetings;
    if (meetings.empty()) return;
    const auto [least, most] = std::ranges::minmax(meetings, {}, &RodMeeting::reach);
    const bool is_one = meetings.size() == 1;
    const std::string range = least.reach > 0.99 * most.reach
                                  ? fmt::format("{:.3g}", most.reach)
                                  : fmt::format("{:.3g} to {:.3g}", least.reach, most.reach);
    findings.push_back({Severity::note,
                        fmt::format("where rods are connected they do not touch, within {} of the connection "
                                    "along them: {} {}",
                                    range,
                                    meetings.size(),
                                    is_one ? "pair of rods" : "pairs of rods")});
}

void note_speed(const Model& model, const AnalysisSettings& analysis, std::vector<Finding>& findings) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    if (dynamic == nullptr || !dynamic->has_inertia || dynamic->adaptive || dynamic->steps == 0) return;
    double fastest = 0.0;  // radii in a time
    const Node* node = nullptr;
    const auto compare = [&](int index, double radius) {
        const Node& one = model.nodes[static_cast<std::size_t>(index)];
        const double speed = one.velocity.norm() / radius;
        if (speed <= fastest) return;
        fastest = speed;
        node = &one;
    };
    for (std::size_t i = 0; i < model.rods.size(); ++i) {
        if (radius_of(model, i) == 0.0) continue;
        for (const int index : model.rods[i].element_nodes) compare(index, radius_of(model, i));
    }
    for (const ContactBody& body : model.contact.bodies)
        compare(model.bodies[static_cast<std::size_t>(body.body)].node, body.radius);
    const double moved = fastest * dynamic->time_step();
    constexpr double tolerable = 1.0;
    if (node == nullptr || moved <= tolerable) return;
    const double step = 0.6 / fastest;
    findings.push_back({Severity::note,
                        fmt::format("{} moves by {:.2g} radii in a step at the start: where it touches, many "
                                    "increments will be shortened and steps cut; time_step = {:.1g} moves it "
                                    "by {:.2g}",
                                    node->name,
                                    moved,
                                    step,
                                    fastest * std::stod(fmt::format("{:.1g}", step)))});
}

}  // namespace

bool can_contact_hold(const ModelPart& part, const Model& model) {
    return !model.contact.is_empty() && std::ranges::any_of(part.rods, [&](int rod) {
        return model.contact.radii[static_cast<std::size_t>(rod)] > 0.0;
    });
}

std::vector<Finding> examine_contact(const Model& model, const AnalysisSettings& analysis) {
    std::vector<Finding> findings;
    if (model.contact.is_empty()) return findings;
    const System system(model);
    State state = system.initial_state();
    if (const Contacts contacts(system); contacts.are_possible()) {
        contacts.search(state);
        find_overlaps(contacts, state, findings);
        if (findings.empty()) {
            const std::vector<ContactTouch> touches = contacts.list_touches(state, 0.0);
            note_touches(model, touches, findings);
            const bool is_static = has_steps(analysis) && !needs_inertia(analysis);
            if (is_static && model.surroundings.is_empty()) find_held_by_contact(model, touches, findings);
        }
    }
    note_kinks(model, findings);
    note_meetings(model, findings);
    note_speed(model, analysis, findings);
    return findings;
}

}  // namespace gxrod
