#include "report/model/model_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/body_moments.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/ties/joint_card.hpp"
#include "model/ties/ties.hpp"
#include "report/model/wet_rods_json.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

Json to_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

Json to_json(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

// The sphere or capsule of a body, in its axes; null without one.
Json describe_shape(const Model& model, const Body& body) {
    const auto own = std::ranges::find_if(model.contact.bodies, [&](const ContactBody& one) {
        return &model.bodies[static_cast<std::size_t>(one.body)] == &body;
    });
    if (own == model.contact.bodies.end()) return nullptr;
    return {{"ends", Json::array({to_json(own->ends[0]), to_json(own->ends[1])})}, {"radius", own->radius}};
}

Json describe_body(const Model& model, const Body& body, const NodeNumbers& number) {
    const Cuboid cuboid = find_cuboid(body.mass, body.inertia);
    return {{"name", body.name},
            {"node", number(body.node)},
            {"centre", to_json(body.centre_of_mass)},
            {"attitude", to_json(body.attitude)},
            {"axes", to_json(cuboid.axes)},
            {"half_sizes", to_json(cuboid.half_sizes)},
            {"shape", describe_shape(model, body)}};
}

Json describe_end(const Anchor& end, const NodeNumbers& number) {
    return {{"node", end.is_ground() ? -1 : number(end.node)}, {"arm", to_json(end.arm)}};
}

Json describe_ends(const Anchor& a, const Anchor& b, const NodeNumbers& number) {
    return Json::array({describe_end(a, number), describe_end(b, number)});
}

// Points of a cam's curve, closed if it is, in the axes of A's side from its point.
Json describe_curve(const PlaneCurve& curve) {
    Json points = Json::array();
    constexpr int count = 180;
    for (int i = 0; i <= count; ++i) {
        const PlaneCurve::Point point = curve.find_place(i * curve.length() / count).point;
        points.push_back({point.x(), point.y()});
    }
    return points;
}

Json describe_joint(const Joint& joint, const NodeNumbers& number) {
    const JointCard& card = card_of(joint.kind);
    Json json{{"name", joint.name},
              {"type", std::string(card.word)},
              {"leaves_free", std::string(card.leaves_free)},
              {"ends", describe_ends(joint.a.anchor, joint.b.anchor, number)},
              {"axes", to_json(Quat(joint.a.axes))},
              {"moved", joint.turn.motion.has_value() || joint.slide.motion.has_value()}};
    if (card.has_axis_b) json["axis_b"] = to_json(Vec3(joint.b.axes.col(0)));
    if (joint.cam) json["curve"] = describe_curve(*joint.cam->curve);
    if (joint.cam) json["roller"] = joint.cam->roller;
    return json;
}

// At its point, on both sides; around a rod, one of whose nodes has the size.
Json describe_sleeve(const Model& model, const Sleeve& sleeve, const NodeNumbers& number) {
    const JointCard& card = card_of(JointKind::sleeve);
    return {{"name", sleeve.name},
            {"type", std::string(card.word)},
            {"leaves_free", sleeve.holds_turn ? "slide along the rod" : "all turns, slide along the rod"},
            {"ends", describe_ends(sleeve.point, sleeve.point, number)},
            {"axes", to_json(Quat(Quat::Identity()))},
            {"moved", sleeve.slide.motion.has_value()},
            {"around", number(model.rods[sleeve.rod].nodes.front())}};
}

// Of the first `most` of these parts.
template <class Part, class Describe>
Json describe_first(const std::vector<Part>& parts, std::size_t most, Describe&& describe) {
    Json list = Json::array();
    for (std::size_t i = 0; i < std::min(parts.size(), most); ++i) list.push_back(describe(parts[i]));
    return list;
}

// The first with waves; of the stages with time these go on from the first.
const Water& find_sea(const Problem& problem) {
    const std::optional<Water>& own = problem.model.surroundings.water;
    if (!own->waves.empty()) return *own;
    for (std::size_t i = 1; i < problem.stages.size(); ++i) {
        const std::optional<Water>& water = problem.stages[i].actions.surroundings.water;
        if (water && !water->waves.empty()) return *water;
    }
    return *own;
}

Json describe_water(const Water& water) {
    Json waves = Json::array();
    for (const WaveTrain& train : water.waves)
        waves.push_back({train.amplitude,
                         train.number * std::cos(train.direction),
                         train.number * std::sin(train.direction),
                         train.frequency,
                         train.phase});
    return {{"surface", *water.surface},
            {"ramp", water.ramp},
            {"ramp_start", water.ramp_start},
            {"waves", waves}};
}

// The names of the stages in which water or ground is there; null if it is in all of them.
template <class Acts>
Json list_stages(const Problem& problem, const Acts& acts) {
    Json names = Json::array();
    bool is_always = true;
    for (std::size_t i = 0; i < problem.stages.size(); ++i) {
        const StagePlan& stage = problem.stages[i];
        if (!has_steps(stage.analysis)) continue;
        if (acts(i == 0 ? problem.model.surroundings : stage.actions.surroundings)) {
            names.push_back(stage.name);
        } else {
            is_always = false;
        }
    }
    return is_always ? Json() : names;
}

Json describe_ground(const Seabed& seabed) {
    if (seabed.grid)
        return {
            {"x", seabed.grid->x}, {"y", seabed.grid->y}, {"z", seabed.grid->z}, {"turn", seabed.grid->turn}};
    return {{"point", to_json(seabed.point)}, {"normal", to_json(seabed.normal)}};
}

}  // namespace

Json describe_surroundings(const Problem& problem) {
    const Surroundings& around = problem.model.surroundings;
    Json json = Json::object();
    if (around.water && around.water->surface) {
        json["water"] = describe_water(find_sea(problem));
        json["water"]["stages"] =
            list_stages(problem, [](const Surroundings& one) { return one.water->acts(); });
    }
    if (around.water || around.air) json["wet"] = describe_wet_rods(problem);
    if (!around.seabed) return json;
    json["ground"] = describe_ground(*around.seabed);
    json["ground"]["stages"] =
        list_stages(problem, [](const Surroundings& one) { return one.seabed->acts(); });
    Json radii = Json::array();
    for (const Rod& rod : problem.model.rods) {
        const std::optional<SectionInFluid>& fluid =
            problem.model.sections[static_cast<std::size_t>(rod.section)].fluid;
        radii.push_back(fluid ? 0.5 * fluid->diameter : 0.0);
    }
    json["ground"]["radii"] = radii;
    return json;
}

Json describe_bodies(const Model& model, const NodeNumbers& number, std::size_t most) {
    return describe_first(
        model.bodies, most, [&](const Body& body) { return describe_body(model, body, number); });
}

Json describe_supports(const Model& model, const NodeNumbers& number, std::size_t most) {
    return describe_first(model.supports, most, [&](const Support& support) -> Json {
        return {{"name", model.nodes[support.node].name},
                {"node", number(support.node)},
                {"axes", to_json(support.axes)},
                {"fixed", support.fixed},
                {"moved", support.moved}};
    });
}

Json describe_joints(const Model& model, const NodeNumbers& number, std::size_t most) {
    Json joints =
        describe_first(model.joints, most, [&](const Joint& joint) { return describe_joint(joint, number); });
    for (const Sleeve& sleeve : model.sleeves) {
        if (joints.size() == most) break;
        joints.push_back(describe_sleeve(model, sleeve, number));
    }
    return joints;
}

void describe_element_ties(const Model& model, const NodeNumbers& number, std::size_t most, Json& json) {
    for_each_element_list(model, [&](TieKind kind, const auto& ties) {
        json[card_of(kind).names] = describe_first(ties, most, [&](const auto& tie) {
            Json one{{"name", tie.name}, {"ends", describe_ends(tie.ends[0], tie.ends[1], number)}};
            if constexpr (requires { tie.law; }) one["pulls"] = tie.stiffness != 0.0 || tie.law != nullptr;
            if constexpr (requires { tie.axes; }) one["axes"] = to_json(tie.axes);
            return one;
        });
    });
}

std::size_t count_unknowns(const Model& model) {
    std::size_t count = 6 * model.nodes.size();
    for (const Support& support : model.supports) {
        for (int i = 0; i < 6; ++i) count -= support.holds(i) ? 1 : 0;
    }
    return count;
}

}  // namespace gxrod
