#include "assembly/contact/contact_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/ties/joint_card.hpp"

namespace gxrod {

namespace {

// Where a node of the model is on a rod, and the tangent of the rod there, at t = 0, away from the end if it
// is one. On a body, which has no tangent, what it extends from the node.
struct NodeOnRod {
    int rod = 0;
    double s = 0.0;
    Vec3 tangent = Vec3::Zero();
    bool is_end = false;
    double radius = 0.0, extent = 0.0;
};

std::multimap<int, NodeOnRod> find_nodes_of_rods(const Model& model) {
    std::multimap<int, NodeOnRod> found;
    for (int index = 0; index < static_cast<int>(model.rods.size()); ++index) {
        const Rod& rod = model.rods[static_cast<std::size_t>(index)];
        if (model.contact.radii[static_cast<std::size_t>(index)] == 0.0) continue;
        const auto nodes = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t entry = 0; entry < rod.element_nodes.size(); ++entry) {
            const bool repeats = entry % nodes == 0 && entry > 0;
            if (repeats && rod.element_nodes[entry] == rod.element_nodes[entry - 1]) continue;
            const double s = rod.arc_length[entry];
            const bool is_start = s == 0.0;
            const bool is_end = s == rod.length;
            const Vec3 tangent = rod.triads[entry] * Vec3::UnitX();
            found.emplace(rod.element_nodes[entry],
                          NodeOnRod{index,
                                    s,
                                    is_end ? Vec3(-tangent) : tangent,
                                    is_start || is_end,
                                    model.contact.radii[static_cast<std::size_t>(index)]});
        }
    }
    for (const ContactBody& body : model.contact.bodies) {
        NodeOnRod own{static_cast<int>(model.rods.size()) + body.body};
        own.radius = body.radius;
        own.extent = std::max(body.ends[0].norm(), body.ends[1].norm());
        found.emplace(model.bodies[static_cast<std::size_t>(body.body)].node, own);
    }
    return found;
}

// The least angle between two lines that meet, each of which goes on both sides unless it ends there.
double find_angle(const NodeOnRod& a, const NodeOnRod& b) {
    double cosine = a.tangent.dot(b.tangent);
    if (!a.is_end || !b.is_end) cosine = std::abs(cosine);
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

void add_meeting(double skin, const NodeOnRod& a, const NodeOnRod& b, ContactLines& lines) {
    const double radii = a.radius + b.radius;
    constexpr double least_angle = 0.2;
    const double reach =
        std::max(M_PI / 2.0, 1.0 / std::sin(0.5 * std::max(find_angle(a, b), least_angle))) * radii +
        skin * radii + a.extent + b.extent;
    lines.meetings.push_back({a.rod, b.rod, a.s, b.s, reach});
}

void find_meetings(const Model& model, ContactLines& lines) {
    const std::multimap<int, NodeOnRod> nodes = find_nodes_of_rods(model);
    const auto meet = [&](int node, int other) {
        const auto [first, last] = nodes.equal_range(node);
        const auto [other_first, other_last] = nodes.equal_range(other);
        for (auto a = first; a != last; ++a) {
            for (auto b = other_first; b != other_last; ++b) {
                if (a->second.rod < b->second.rod ||
                    (a->second.rod == b->second.rod && a->second.s < b->second.s))
                    add_meeting(model.contact.skin, a->second, b->second, lines);
                else if (node != other && a->second.rod > b->second.rod)
                    add_meeting(model.contact.skin, b->second, a->second, lines);
            }
        }
    };
    for (auto at = nodes.begin(); at != nodes.end(); at = nodes.upper_bound(at->first))
        meet(at->first, at->first);
    for (const Joint& joint : model.joints) {
        if (joint.a.anchor.is_ground() || joint.b.anchor.is_ground()) continue;
        if (!card_of(joint.kind).is_at_one_place) continue;
        meet(joint.a.anchor.node, joint.b.anchor.node);
    }
}

}  // namespace

bool ContactLines::can_touch(const ContactPiece& a, const ContactPiece& b) const {
    const ContactElement& of_a = element_of(a);
    const ContactElement& of_b = element_of(b);
    if (of_a.rod == of_b.rod) {
        // Shapes of one body are parts of it.
        if (of_a.is_body || !is_within_rods) return false;
        double between = std::abs(a.middle - b.middle);
        if (const double length = round[static_cast<std::size_t>(of_a.rod)]; length > 0.0)
            between = std::min(between, length - between);
        if (between - 0.5 * (a.length + b.length) < M_PI * of_a.radius) return false;
    } else if (!is_between_rods) {
        return false;
    }
    if (const ContactException* one = find_exception(a, b); one != nullptr && one->is_off) return false;
    return std::ranges::none_of(meetings, [&](const RodMeeting& meeting) {
        const auto is_near = [&](const ContactPiece& one, double at, const ContactPiece& two, double other) {
            return std::abs(one.middle - at) - 0.5 * one.length < meeting.reach &&
                   std::abs(two.middle - other) - 0.5 * two.length < meeting.reach;
        };
        if (meeting.rod == of_a.rod && meeting.other == of_b.rod &&
            is_near(a, meeting.at, b, meeting.other_at))
            return true;
        return meeting.rod == of_b.rod && meeting.other == of_a.rod &&
               is_near(b, meeting.at, a, meeting.other_at);
    });
}

ContactLines find_contact_lines(const Model& model) {
    ContactLines lines;
    lines.is_between_rods = model.contact.between_rods;
    lines.is_within_rods = model.contact.within_rods;
    if (!lines.is_between_rods && !lines.is_within_rods) return lines;
    lines.places = find_chord_places(model);
    lines.exceptions = ContactExceptions(model.contact, lines.places);
    for (std::size_t p = 0; p + 1 < lines.places.places.size(); ++p) {
        const ContactPlace& from = lines.places.places[p];
        const ContactPlace& to = lines.places.places[p + 1];
        if (from.element != to.element) continue;
        const ContactElement& element = lines.places.elements[static_cast<std::size_t>(from.element)];
        if (element.is_body) {
            const double length = (to.arm - from.arm).norm();
            lines.pieces.push_back({p, length, 0.0, true, length > 0.0});
            continue;
        }
        const Rod& rod = model.rods[static_cast<std::size_t>(element.rod)];
        const double length = (to.fraction - from.fraction) * rod.length;
        const bool is_closed = rod.element_nodes.front() == rod.element_nodes.back();
        lines.pieces.push_back({p,
                                length,
                                0.5 * (from.fraction + to.fraction) * rod.length,
                                !is_closed && from.fraction < 1e-9,
                                !is_closed && to.fraction > 1.0 - 1e-9});
    }
    for (const Rod& rod : model.rods) {
        const bool is_closed = rod.element_nodes.front() == rod.element_nodes.back();
        lines.round.push_back(is_closed ? rod.length : 0.0);
    }
    find_meetings(model, lines);
    return lines;
}

}  // namespace gxrod
