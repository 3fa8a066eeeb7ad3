#include "deck/surroundings/contents_flow.hpp"

#include <algorithm>

#include "deck/loads/acting.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// What flows through a rod.
struct PipeFlow {
    std::string key;
    int rod = 0;
    double mass = 0.0;  // of the contents, per length
    TimeFunction velocity{};

    bool is_steady() const { return velocity.is_constant(); }
    // m v².
    TimeFunction thrust(double factor) const {
        if (is_steady()) return factor * mass * velocity(0.0) * velocity(0.0);
        return TimeFunction([v = velocity, m = factor * mass](double time) { return m * v(time) * v(time); },
                            velocity.switches());
    }
};

// The section axis x along a rod at t = 0, linear between nodes.
class StartAxes {
  public:
    explicit StartAxes(const Rod& rod) {
        for (std::size_t i = 0; i < rod.arc_length.size(); ++i) {
            if (!s_.empty() && rod.arc_length[i] <= s_.back()) continue;
            s_.push_back(rod.arc_length[i]);
            axes_.emplace_back(rod.triads[i] * Vec3::UnitX());
        }
    }

    Vec3 at(double s) const {
        const auto above = std::ranges::upper_bound(s_, s);
        if (above == s_.begin()) return axes_.front();
        if (above == s_.end()) return axes_.back();
        const auto i = static_cast<std::size_t>(above - s_.begin());
        const double part = (s - s_[i - 1]) / (s_[i] - s_[i - 1]);
        return Vec3((1.0 - part) * axes_[i - 1] + part * axes_[i]).normalized();
    }

  private:
    std::vector<double> s_;
    std::vector<Vec3> axes_;
};

// The rate of a velocity; before t = 0 it need not have values.
double find_rate(const TimeFunction& velocity, double time) {
    const double step = 6e-6 * std::max(1.0, std::abs(time));
    if (time >= step) return (velocity(time + step) - velocity(time - step)) / (2.0 * step);
    return (4.0 * velocity(time + step) - 3.0 * velocity(time) - velocity(time + 2.0 * step)) / (2.0 * step);
}

// (W20), without the part that thrusts and pulls have: the force that turning and acceleration of the flow
// exert, per length.
MotionLoad make_flow_load(const PipeFlow& flow, const Rod& rod, bool has_rate) {
    MotionLoad load;
    load.has_force = load.turns = true;
    load.value = [flow, has_rate, axes = StartAxes(rod)](double time, double s, const PointMotion& motion) {
        Vec6 value = Vec6::Zero();
        const Vec3 along = exp_quaternion(motion.rotation) * axes.at(s);
        value.head<3>() = -2.0 * flow.mass * flow.velocity(time) * motion.spin.cross(along);
        if (has_rate) value.head<3>() -= flow.mass * find_rate(flow.velocity, time) * along;
        return value;
    };
    return load;
}

void add_flow(const PipeFlow& flow, BuildContext& context) {
    Model& model = context.model;
    const Rod& rod = model.rods[static_cast<std::size_t>(flow.rod)];
    const Mat6 compliance = model.sections[static_cast<std::size_t>(rod.section)].stiffness.inverse();
    Actuation pull{.key = flow.key, .rod = flow.rod};
    for (int i = 0; i < 6; ++i) {
        const TimeFunction strain = flow.thrust(compliance(i, 0));
        pull.strain[static_cast<std::size_t>(i)] =
            strain.is_constant() ? LineFunction(strain(0.0))
                                 : LineFunction([strain](double time, double) { return strain(time); },
                                                strain.switches(),
                                                {InTime::varying, true});
    }
    model.actuations.push_back(std::move(pull));
    const auto add_thrust = [&](int node, const Quat& axes, double sign) {
        model.loads.push_back({.key = flow.key,
                               .node = node,
                               .force = {flow.thrust(sign), 0.0, 0.0},
                               .moment = {0.0, 0.0, 0.0},
                               .frame = Frame::body,
                               .axes = axes});
    };
    add_thrust(rod.element_nodes.front(), rod.triads.front(), 1.0);
    add_thrust(rod.element_nodes.back(), rod.triads.back(), -1.0);
    DistributedLoad turning{
        .key = flow.key, .rod = flow.rod, .force = {0.0, 0.0, 0.0}, .moment = {0.0, 0.0, 0.0}};
    turning.by_motion = make_flow_load(flow, rod, model.has_time && !flow.is_steady());
    model.distributed_loads.push_back(std::move(turning));
}

// The contents of a section that flow; nullptr if they rest.
const ContentsTable* find_flowing(const std::string& section, const BuildContext& context) {
    for (const SectionTable& one : tables_of<SectionTable>(context.deck, section_table())) {
        const bool flows =
            one.name == section && one.fluid && one.fluid->contents && one.fluid->contents->velocity;
        if (flows) return &*one.fluid->contents;
    }
    return nullptr;
}

// Why contents cannot flow through the rod, or "".
std::string explain_no_flow(const RodTable& table, const Rod& rod, const Section& section) {
    if (table.mesh)
        return "contents flow through rods that are one line; this section is that of a rod from a mesh";
    if (rod.has_varying_sections()) return "contents flow through sections that are the same along a rod";
    return section.law ? "contents flow through sections without a law" : "";
}

void check_stations(const RodTable& table, const BuildContext& context) {
    const auto* stations =
        table.sections ? std::get_if<std::vector<CheckedStation>>(&*table.sections) : nullptr;
    if (stations == nullptr || context.stage > 0) return;
    for (const CheckedStation& station : *stations) {
        if (const ContentsTable* contents = find_flowing(station.section.word, context))
            context.add_fault(*contents,
                              contents->velocity,
                              "contents flow through sections that are the same along a rod");
    }
}

}  // namespace

void build_contents_flow(BuildContext& context) {
    const auto tables = rods_of(context.deck);
    for (std::size_t i = 0; i < tables.size() && i < context.model.rods.size(); ++i) {
        const RodTable& table = tables[i];
        if (!table.section) {
            check_stations(table, context);
            continue;
        }
        const ContentsTable* contents = find_flowing(table.section->word, context);
        const Rod& rod = context.model.rods[i];
        if (contents == nullptr || rod.element_nodes.empty()) continue;
        const Section& section = context.model.sections[static_cast<std::size_t>(rod.section)];
        const std::string reason = explain_no_flow(table, rod, section);
        if (!reason.empty()) {
            if (context.stage == 0) context.add_fault(*contents, contents->velocity, reason);
            continue;
        }
        if (!section.fluid) continue;
        add_flow({.key = contents->path_of(&contents->velocity),
                  .rod = static_cast<int>(i),
                  .mass = section.fluid->contents_density * section.fluid->contents_area,
                  .velocity = find_acting(context).apply(contents->velocity->function)},
                 context);
    }
}

}  // namespace gxrod
