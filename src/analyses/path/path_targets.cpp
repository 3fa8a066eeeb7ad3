#include "analyses/path/path_targets.hpp"

#include <cmath>
#include <stdexcept>

namespace gxrod {

namespace {

// Round-off of a value that was hit before.
constexpr double close = 1e-11;

}  // namespace

PathTargets::PathTargets(const System& system, const PathSettings& settings)
    : system_(&system),
      least_load_(settings.least_load),
      greatest_load_(settings.greatest_load),
      targets_(settings.at),
      control_(settings.control) {
    PathTarget bounds;
    if (least_load_) bounds.values.push_back(*least_load_);
    if (greatest_load_) bounds.values.push_back(*greatest_load_);
    targets_.push_back(bounds);
    if (control_ && control_->to) targets_.push_back({control_->node, control_->component, {*control_->to}});
    for (const PathTarget& target : targets_) {
        if (target.node >= 0 && std::abs(row_of(target).u.norm() - 1.0) > close)
            throw std::invalid_argument("a support holds a displacement whose values a path must have");
    }
    if (control_ && std::abs(row_of(*control_).u.norm() - 1.0) > close)
        throw std::invalid_argument("a support holds what is to control the path");
}

PathVector PathTargets::row_of(const PathTarget& target) const {
    if (target.node < 0) return {Eigen::VectorXd::Zero(system_->equations().count()), 1.0};
    return row_of(target.node, target.component);
}

PathVector PathTargets::row_of(const PathControl& control) const {
    return row_of(control.node, control.component);
}

PathVector PathTargets::row_of(int node, int component) const {
    std::vector<Vec6> nodal(system_->model().nodes.size(), Vec6::Zero());
    nodal[static_cast<std::size_t>(node)][component] = 1.0;
    return {gather(nodal, system_->equations()), 0.0};
}

double PathTargets::value_of(const PathControl& control, const std::vector<NodeMotion>& motions) const {
    return value_of(PathTarget{control.node, control.component, {}},
                    &motions[static_cast<std::size_t>(control.node)],
                    0.0);
}

double PathTargets::value_of(const PathTarget& target, const NodeMotion* motion, double load_factor) const {
    if (motion == nullptr) return load_factor;
    const Vec3& reference = system_->model().nodes[static_cast<std::size_t>(target.node)].position;
    return motion->r[target.component] - reference[target.component];
}

std::optional<PathTargets::Hit> PathTargets::find_first(const PathContext& work,
                                                        const PathCurve& curve,
                                                        double load_factor) const {
    std::optional<Hit> first;
    for (const PathTarget& target : targets_) {
        const auto motion_in = [&](const std::vector<NodeMotion>& motions) {
            return target.node < 0 ? nullptr : &motions[static_cast<std::size_t>(target.node)];
        };
        const double from = value_of(target, motion_in(work.state.previous), work.state.time);
        const double to = value_of(target, motion_in(work.state.trial), load_factor);
        const PathVector row = row_of(target);
        for (const double value : target.values) {
            const double scale = target.node < 0 ? std::max(1.0, std::abs(value)) : system_->length_scale();
            // At its end the step is there.
            if (std::abs(value - to) <= close * scale && std::abs(value - from) > close * scale) {
                if (!first) first = Hit{&target, value - from, 1.0, true};
                continue;
            }
            const std::optional<double> part = curve.find_first(row, value - from, close * scale);
            if (part && (!first || *part < first->part))
                first = Hit{&target, value - from, *part, (value - from) * (value - to) < 0.0};
        }
    }
    return first;
}

bool PathTargets::hit(PathContext& work, const Step& step, PathTrial& trial) const {
    // Of the way to where it is looked for, how far from there another solution is.
    constexpr double near = 0.25;
    const PathVector whole{compute_step(work.system, work.state), trial.load_factor - work.state.time};
    const PathCurve curve(step.direction, whole, trial.direction, step.row);
    const std::optional<Hit> first = find_first(work, curve, trial.load_factor);
    if (!first || first->part == 1.0) return true;
    const PathVector row = row_of(*first->target);
    PathVector prediction = curve.at(first->part);
    // The value of the target's row: displacements and load factors add, and no further increment changes it.
    const double rest = first->value - row.u.dot(prediction.u) - row.load * prediction.load;
    prediction = prediction + rest * row;
    PathTrial found;
    bool is_there = solve_path_step(work, prediction, row, found).converged();
    if (is_there) {
        const PathVector movement{compute_step(work.system, work.state), found.load_factor - work.state.time};
        found.step = work.metric.norm(movement);
        is_there = work.metric.norm(movement + -1.0 * prediction) <= near * trial.step;
    }
    if (is_there) {
        trial = found;
        return true;
    }
    if (first->is_between || !step.is_short) return false;
    // The value turned back before it was there.
    return solve_path_step(work, whole, step.row, found).converged();
}

bool PathTargets::is_end(const std::vector<NodeMotion>& motions, double load_factor) const {
    const auto reaches = [&](double bound) {
        return std::abs(load_factor - bound) <= close * std::max(1.0, std::abs(bound));
    };
    if (control_ && control_->to &&
        std::abs(value_of(*control_, motions) - *control_->to) <= close * system_->length_scale())
        return true;
    return (least_load_ && reaches(*least_load_)) || (greatest_load_ && reaches(*greatest_load_));
}

}  // namespace gxrod
