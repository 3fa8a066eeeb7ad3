#include "sensitivity/state_direction.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

Vec3 spin_between(const Quat& from, const Quat& to) { return log(to * from.conjugate()); }

// Calls visit(number of each direction, numbers of joints) for what a joint keeps.
template <class Visit, class... Joint>
void visit_joint(Visit&& visit, Joint&... joints) {
    for (std::size_t i = 0; i < 6; ++i) visit(joints.multipliers[i]...);
    visit(joints.turn...);
    visit(joints.slide...);
}

}  // namespace

void move_along(const StateDirection& direction, double amount, State& state) {
    for (std::size_t i = 0; i < direction.nodes.size(); ++i) {
        const StateDirection::OfNode& by = direction.nodes[i];
        NodeMotion& node = state.previous[i];
        node.r += amount * by.r;
        node.Lambda = exp_quaternion(amount * by.phi) * node.Lambda;
        node.v += amount * by.v;
        node.omega += amount * by.omega;
        node.a += amount * by.a;
        node.alpha += amount * by.alpha;
    }
    for (std::size_t i = 0; i < direction.sections.size(); ++i) {
        SectionHistory& section = state.sections[i];
        section.Lambda = exp_quaternion(amount * direction.sections[i].phi) * section.Lambda;
        section.K += amount * direction.sections[i].K;
    }
    for (std::size_t i = 0; i < direction.memory.size(); ++i) state.memory[i] += amount * direction.memory[i];
    for (std::size_t i = 0; i < direction.carried.size(); ++i) {
        state.carried_previous[i].a += amount * direction.carried[i].a;
        state.carried_previous[i].alpha += amount * direction.carried[i].alpha;
    }
    for (std::size_t i = 0; i < direction.joints.size(); ++i) {
        JointState by = direction.joints[i];
        visit_joint(
            [&](double& number, double& rate) { number += amount * rate; }, state.joints_previous[i], by);
    }
}

StateDirection differentiate(const State& up, const State& down, double step, const State* centre) {
    const double half = 0.5 / step;
    const auto spin_of_node = [&](std::size_t i) -> Vec3 {
        const Quat &a = up.previous[i].Lambda, &b = down.previous[i].Lambda;
        if (centre == nullptr) return spin_between(b, a);
        const Quat& c = centre->previous[i].Lambda;
        return spin_between(c, a) - spin_between(c, b);
    };
    StateDirection direction;
    direction.nodes.resize(up.previous.size());
    for (std::size_t i = 0; i < up.previous.size(); ++i) {
        const NodeMotion& a = up.previous[i];
        const NodeMotion& b = down.previous[i];
        direction.nodes[i] = {half * (a.r - b.r),
                              half * spin_of_node(i),
                              half * (a.v - b.v),
                              half * (a.omega - b.omega),
                              half * (a.a - b.a),
                              half * (a.alpha - b.alpha)};
    }
    for (std::size_t i = 0; i < up.sections.size(); ++i)
        direction.sections.push_back({half * spin_between(down.sections[i].Lambda, up.sections[i].Lambda),
                                      half * (up.sections[i].K - down.sections[i].K)});
    for (std::size_t i = 0; i < up.memory.size(); ++i)
        direction.memory.push_back(half * (up.memory[i] - down.memory[i]));
    for (std::size_t i = 0; i < up.carried_previous.size(); ++i)
        direction.carried.push_back({half * (up.carried_previous[i].a - down.carried_previous[i].a),
                                     half * (up.carried_previous[i].alpha - down.carried_previous[i].alpha)});
    for (std::size_t i = 0; i < up.joints_previous.size(); ++i) {
        JointState a = up.joints_previous[i], b = down.joints_previous[i], by;
        visit_joint(
            [&](double& number, double& high, double& low) { number = half * (high - low); }, by, a, b);
        direction.joints.push_back(by);
    }
    return direction;
}

StateDirection extrapolate(StateDirection near, const StateDirection& far) {
    const auto mix = [](auto& a, const auto& b) { a = (4.0 * a - b) / 3.0; };
    for (std::size_t i = 0; i < near.nodes.size(); ++i) {
        StateDirection::OfNode& a = near.nodes[i];
        const StateDirection::OfNode& b = far.nodes[i];
        mix(a.r, b.r);
        mix(a.phi, b.phi);
        mix(a.v, b.v);
        mix(a.omega, b.omega);
        mix(a.a, b.a);
        mix(a.alpha, b.alpha);
    }
    for (std::size_t i = 0; i < near.sections.size(); ++i) {
        mix(near.sections[i].phi, far.sections[i].phi);
        mix(near.sections[i].K, far.sections[i].K);
    }
    for (std::size_t i = 0; i < near.memory.size(); ++i) mix(near.memory[i], far.memory[i]);
    for (std::size_t i = 0; i < near.carried.size(); ++i) {
        mix(near.carried[i].a, far.carried[i].a);
        mix(near.carried[i].alpha, far.carried[i].alpha);
    }
    for (std::size_t i = 0; i < near.joints.size(); ++i) {
        JointState b = far.joints[i];
        visit_joint([&](double& number, double& other) { mix(number, other); }, near.joints[i], b);
    }
    return near;
}

}  // namespace gxrod
