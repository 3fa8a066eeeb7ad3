#include "watch/sight.hpp"

#include "cross_section/stress_measures.hpp"
#include "model/sections/pressed_tube.hpp"
#include "model/sections/section_at.hpp"
#include "model/ties/ties.hpp"
#include "model/ties/yielding_supports.hpp"
#include "watch/quantity_tables.hpp"

#include <algorithm>

namespace gxrod {
namespace {

// The axes of the section at a node of an element, at t = 0.
Quat section_axes(const Model& model, const RodPlace& place, int node) {
    const Rod& rod = model.rods[static_cast<std::size_t>(place.rod)];
    const auto first =
        rod.element_nodes.begin() + static_cast<std::ptrdiff_t>(place.element) * (rod.order + 1);
    const auto local = std::find(first, first + rod.order + 1, node) - first;
    // A rod of one element that closes on itself has its node twice.
    const bool is_end = place.xi == 1.0;
    return rod
        .triads[static_cast<std::size_t>(first - rod.element_nodes.begin() + (is_end ? rod.order : local))];
}

// The stress of a tube under pressures: at a point, or where von Mises' is the largest. Exposure is by the
// yield stress.
SectionStress find_in_tube(const WatchedStress& watched,
                           const Vec6& resultants,
                           const PressedTube& tube,
                           const Pressures& pressures) {
    const CrossSection& shape = *watched.section.section();
    const auto describe = [&](int index) {
        SectionStress found = watched.section.describe(index, resultants);
        found.stress += tube.compute_stress(pressures, found.at);
        found.von_mises = compute_von_mises(found.stress);
        found.principal = compute_principal_stresses(found.stress);
        const std::optional<double>& limit = shape.materials.front().yield_stress;
        found.exposure = limit ? found.von_mises / *limit : 0.0;
        return found;
    };
    if (watched.point) return describe(*watched.point);
    SectionStress worst;
    worst.von_mises = -1.0;
    for (std::size_t i = 0; i < shape.stresses.points.size(); ++i) {
        if (shape.stresses.points[i].is_singular) continue;
        SectionStress found = describe(static_cast<int>(i));
        if (found.von_mises > worst.von_mises) worst = found;
    }
    return worst;
}

}  // namespace

WatchedStress::WatchedStress(std::shared_ptr<const CrossSection> shape, const HistoryRequest& request)
    : section(std::move(shape), request.criterion), is_by_exposure(!request.criterion.empty()) {
    if (request.section_point) point = section.find_nearest_point(*request.section_point);
}

SectionStress WatchedStress::find(const Vec6& resultants) const {
    if (point) return section.describe(*point, resultants);
    std::optional<LargestStress> found;
    if (is_by_exposure) found = section.find_exposure(resultants);
    if (!found) found = section.find_von_mises(resultants);
    return section.describe(found->point, resultants);
}

double WatchedStress::find_exposure(const Vec6& resultants) const {
    if (point) return section.describe(*point, resultants).exposure;
    const std::optional<LargestStress> found = section.find_exposure(resultants);
    return found ? found->value : 0.0;
}

Subject::Subject(const Model& its_model, const std::vector<HistoryRequest>& requests, std::size_t index)
    : model(&its_model),
      target(requests[index].target),
      relative_node(requests[index].relative_node),
      relative_axes(requests[index].relative_axes),
      about(requests[index].about) {
    if (requests[index].no_load) {
        const bool is_relative = relative_node >= 0;
        const Vec3& direction = *requests[index].no_load;
        no_load = is_relative ? Vec3(relative_axes.conjugate() * direction) : direction;
    }
    for (std::size_t i = 0; i < index; ++i) {
        point_row += std::holds_alternative<WatchedPoint>(requests[i].target) ? 1 : 0;
        contact_row += contact_of(requests[i].target) != nullptr ? 1 : 0;
    }
    const int node = node_of(target);
    if (const auto* body = std::get_if<WatchedBody>(&target))
        start_axes = model->bodies[static_cast<std::size_t>(body->index)].attitude;
    else if (node >= 0)
        start_axes = section_axes(*model, std::get<WatchedPoint>(target).place, node);
    if (node >= 0) start = model->nodes[static_cast<std::size_t>(node)].position;
    for (std::size_t i = 0; node >= 0 && i < model->bushings.size(); ++i) {
        const Bushing& bushing = model->bushings[i];
        if (is_support(bushing) && bushing.ends[1].node == node) support_springs.push_back(i);
    }
    if (const auto* point = std::get_if<WatchedPoint>(&target)) {
        const bool has_stress = std::ranges::any_of(
            requests[index].quantities, [](const std::string& word) { return is_stress_quantity(word); });
        if (has_stress) stress.emplace(section_at(*model, point->place).shape, requests[index]);
    }
    if (relative_node >= 0) relative_start = model->nodes[static_cast<std::size_t>(relative_node)].position;
}

Vec6 Sight::section_resultants() const {
    Vec6 resultants;
    resultants << section().force, section().moment;
    return resultants;
}

SeenPoint Sight::point_by_itself() const {
    const int node = node_of(of.target);
    if (node >= 0) return {of.start, of.start_axes, now.nodes[static_cast<std::size_t>(node)]};
    return {section().start, section().triad, section().motion};
}

// With A = Λ_ref A₀ the axes of the reference point, ω and α its spatial rates, d = r − r_ref and
// c = v − v_ref − ω × d the velocity that an observer on those axes sees:
//   position Aᵀ d, velocity Aᵀ c, acceleration Aᵀ (a − a_ref − α × d − ω × (ω × d) − 2 ω × c),
//   angular velocity Aᵀ (ω_point − ω); Aᵀ Λ A₀ takes the place of Λ, so that with A₀ it is the identity at
//   t = 0, and Aᵀ Λ triad = (Aᵀ Λ A₀) (A₀ᵀ triad) are the axes of the point from those of the reference.
SeenPoint Sight::point() const {
    SeenPoint point = point_by_itself();
    if (of.relative_node < 0) return point;
    const NodeMotion& node = point.motion;
    const NodeMotion& reference = now.nodes[static_cast<std::size_t>(of.relative_node)];
    const Quat to_axes = (reference.Lambda * of.relative_axes).conjugate();
    const Vec3& omega = reference.omega;
    const Vec3 d = node.r - reference.r;
    const Vec3 c = node.v - reference.v - omega.cross(d);
    SeenPoint seen;
    seen.start = of.relative_axes.conjugate() * (point.start - of.relative_start);
    seen.start_axes = of.relative_axes.conjugate() * point.start_axes;
    seen.motion.r = to_axes * d;
    seen.motion.v = to_axes * c;
    seen.motion.a = to_axes * (node.a - reference.a - reference.alpha.cross(d) - omega.cross(omega.cross(d)) -
                               2.0 * omega.cross(c));
    seen.motion.Lambda = to_axes * node.Lambda * of.relative_axes;
    seen.motion.omega = to_axes * (node.omega - omega);
    return seen;
}

Vec3 Sight::centre_of_mass() const {
    const SeenPoint seen = point();
    return seen.motion.r + seen.axes() * of.model->bodies[index<WatchedBody>()].centre_of_mass;
}

const PointSurroundings& Sight::around() const {
    static const PointSurroundings none{};
    if (std::holds_alternative<WatchedPoint>(of.target)) return section().surroundings;
    return now.bodies.empty() ? none : now.bodies[index<WatchedBody>()];
}

// Water presses on a solid section with p in all directions: pressure_force = −p A.
SectionStress Sight::stress() const {
    const auto& place = std::get<WatchedPoint>(of.target).place;
    const Section& at = section_at(*of.model, place);
    if (const std::optional<PressedTube> tube = find_pressed_tube(*of.model, at)) {
        // The model is that of the first stage, and gravity can be another one now.
        const Pressures pressures = recover_pressures(*at.fluid,
                                                      of.model->surroundings.water,
                                                      section().surroundings.pressure_force,
                                                      section().motion.r.z());
        return find_in_tube(*of.stress, section_resultants(), *tube, pressures);
    }
    SectionStress found = of.stress->find(section_resultants());
    const std::optional<SectionInFluid>& fluid = at.fluid;
    if (!fluid || !(fluid->area > 0.0)) return found;
    const double pull = section().surroundings.pressure_force / fluid->area;
    found.stress.head<3>().array() += pull;
    found.principal.array() += pull;
    return found;
}

std::optional<GroundedPart> Sight::grounded_part() const {
    if (!now.has_ground) return std::nullopt;
    return find_grounded_part(*of.model, std::get<WatchedContacts>(of.target).contact.rod, now.nodes);
}

// A spring exerts the opposite of what the node exerts on it.
Vec6 Sight::reaction() const {
    const int node = node_of(of.target);
    Vec6 sum = now.reactions[static_cast<std::size_t>(node)];
    for (const std::size_t spring : of.support_springs) {
        const BushingValues& values = now.ties->of<BushingValues>()[spring];
        sum.head<3>() -= values.axes * values.force;
        sum.tail<3>() -= values.axes * values.moment;
    }
    return sum;
}

Vec3 Sight::reaction_force() const { return reaction().head<3>(); }

// M + (r − about) × F of the force F and the moment M on the node at r.
Vec3 Sight::reaction_moment() const {
    const Vec6 acting = reaction();
    if (!of.about) return acting.tail<3>();
    const auto node = static_cast<std::size_t>(node_of(of.target));
    return acting.tail<3>() + (now.nodes[node].r - *of.about).cross(acting.head<3>());
}

const JointValues& Sight::joint() const {
    return now.joints[number_of(*of.model, std::get<WatchedTie>(of.target).kind, index<WatchedTie>())];
}

}  // namespace gxrod
