#include "sensitivity/memory/friction_memory.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "assembly/tendons/capstan_tension.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/difference_at_zero.hpp"

namespace gxrod {

namespace {

constexpr double small = 1e-6;
constexpr double part_of_stick = 1e-3;

}  // namespace

FrictionMemory::FrictionMemory(const System& system) : system_(&system), part_(small) {
    add_loads();
    add_joints();
    add_tendons();
    for (std::vector<int>* nodes : {&nodes_, &tendon_nodes_}) {
        std::ranges::sort(*nodes);
        nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
}

void FrictionMemory::add_joints() {
    const Model& model = system_->model();
    if (!has_joint_friction(model)) return;
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        const Joint& joint = model.joints[i];
        if (!joint.turn.friction.acts() && !joint.slide.friction.acts()) continue;
        const MemorySlice slips = system_->joints().memory_of(number_of(model, TieKind::joint, i));
        const std::array<const Friction*, 2> both{&joint.turn.friction, &joint.slide.friction};
        for (std::size_t k = 0; k < both.size(); ++k) {
            if (!both[k]->acts()) continue;
            places_.push_back({slips.first + k, part_of_stick * both[k]->stick});
            const double length = k == 0 ? 1.0 : system_->length_scale();
            part_ = std::min(part_, part_of_stick * both[k]->stick / length);
        }
        for (const Anchor* anchor : {&joint.a.anchor, &joint.b.anchor}) {
            if (!anchor->is_ground()) nodes_.push_back(anchor->node);
        }
    }
}

void FrictionMemory::add_tendons() {
    // Where a tendon hardly turns it sticks within a narrow range of tensions.
    constexpr double narrow = 1e-8;
    for (const CapstanTension& tendon : list_capstan_tensions(system_->model())) {
        part_ = std::min(part_, narrow);
        for (std::size_t i = 0; i < tendon.count(); ++i)
            places_.push_back({tendon.memory().first + i, 0.0});  // the step follows tensions
        nodes_.insert(nodes_.end(), tendon.nodes().begin(), tendon.nodes().end());
        tendon_nodes_.insert(tendon_nodes_.end(), tendon.nodes().begin(), tendon.nodes().end());
    }
}

// Between those of rods and of joints are the numbers of loads, of which friction on the ground is one.
// Whether a piece touches it is among them; nothing depends smoothly on that, so that what comes of it counts
// for nothing.
void FrictionMemory::add_loads() {
    const std::size_t end = system_->joints().memory_of(0).first;
    for (std::size_t i = system_->memory_within_rods().end(); i < end; ++i)
        places_.push_back({i, small * system_->length_scale()});
    if (places_.empty()) return;
    for (std::size_t node = 0; node < system_->model().nodes.size(); ++node)
        nodes_.push_back(static_cast<int>(node));
}

void FrictionMemory::add_by_placements(const State& state,
                                       double time,
                                       const MemoryGradient& after,
                                       MotionGradient& by_end) const {
    MemoryGradient own;
    own.numbers.assign(after.numbers.size(), 0.0);
    bool counts = false;
    for (const Place& place : places_) {
        own.numbers[place.number] = after.numbers[place.number];
        counts = counts || own.numbers[place.number] != 0.0;
    }
    if (!counts) return;
    State moved = state, there = state;
    system_->commit(there, time);
    add_by_nodes(
        nodes_,
        moved.trial,
        [&] {
            State end = moved;
            system_->commit(end, time);
            return dot(own, end, there);
        },
        by_end);
}

template <class Function>
void FrictionMemory::add_by_nodes(const std::vector<int>& nodes,
                                  std::vector<NodeMotion>& motions,
                                  const Function& function,
                                  MotionGradient& gradient) const {
    for (const int node : nodes) {
        NodeMotion& motion = motions[static_cast<std::size_t>(node)];
        const NodeMotion start = motion;
        MotionGradient::OfNode& by = gradient.nodes[static_cast<std::size_t>(node)];
        const auto differentiate = [&](double step, const auto& move) {
            const double derivative = differentiate_at_zero(
                [&](double amount) {
                    move(amount);
                    return function();
                },
                step);
            motion = start;
            return derivative;
        };
        const double length = system_->scale_groups().length_at(node);
        for (Eigen::Index k = 0; k < 3; ++k) {
            by.r[k] +=
                differentiate(part_ * length, [&](double amount) { motion.r[k] = start.r[k] + amount; });
            by.phi[k] += differentiate(part_, [&](double amount) {
                motion.Lambda = exp_quaternion(amount * Vec3::Unit(k)) * start.Lambda;
            });
        }
    }
}

void FrictionMemory::add_by_start(const State& state,
                                  double time,
                                  const std::function<double(const State& start)>& function,
                                  MemoryGradient& before,
                                  MotionGradient& motions_before) const {
    if (is_empty()) return;
    double tension = 0.0;
    for (const CapstanTension& tendon : list_capstan_tensions(system_->model())) {
        for (const double one : tendon.compute(state.trial, state, time)) tension = std::max(tension, one);
    }
    State moved = state;
    for (const Place& place : places_) {
        const double step = place.step > 0.0 ? place.step : small * tension;
        if (!(step > 0.0)) continue;
        const double start = state.memory[place.number];
        before.numbers[place.number] += differentiate_at_zero(
            [&](double amount) {
                moved.memory[place.number] = start + amount;
                return function(moved);
            },
            step);
        moved.memory[place.number] = start;
    }
    add_by_nodes(
        tendon_nodes_, moved.previous, [&] { return function(moved); }, motions_before);
}

}  // namespace gxrod
