#include "study/turned_problem.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "environment/flow_profile.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

using Functions = std::array<TimeFunction, 3>;
using LineFunctions = std::array<LineFunction, 3>;

// Those of all three.
template <class FunctionVector>
std::shared_ptr<const Switches> join_switches(const FunctionVector& functions) {
    auto all = std::make_shared<Switches>();
    for (const auto& function : functions) {
        if (function.switches() == nullptr) continue;
        all->insert(all->end(), function.switches()->begin(), function.switches()->end());
    }
    return all->empty() ? nullptr : all;
}

// Of a sum of all three.
LineForm join_forms(const LineFunctions& functions) {
    LineForm form = functions[0].form();
    for (const LineFunction& function : functions) {
        form.is_even = form.is_even && function.form().is_even;
        if (function.form().in_time != form.in_time) form.in_time = InTime::varying;
    }
    return form;
}

// The components of R f. Where f varies, each calls all three of f.
Functions turn(const Quat& rotation, const Functions& functions) {
    const Mat3 R = rotation.toRotationMatrix();
    Functions turned;
    if (functions[0].is_constant() && functions[1].is_constant() && functions[2].is_constant()) {
        const Vec3 value = R * Vec3(functions[0](0.0), functions[1](0.0), functions[2](0.0));
        return {value.x(), value.y(), value.z()};
    }
    const auto all = std::make_shared<const Functions>(functions);
    const auto switches = join_switches(functions);
    for (int i = 0; i < 3; ++i) {
        const Vec3 row = R.row(i);
        turned[static_cast<std::size_t>(i)] = TimeFunction(
            [all, row](double time) {
                return row.dot(Vec3((*all)[0](time), (*all)[1](time), (*all)[2](time)));
            },
            switches);
    }
    return turned;
}

LineFunctions turn(const Quat& rotation, const LineFunctions& functions) {
    if (is_zero(functions)) return functions;
    const Mat3 R = rotation.toRotationMatrix();
    LineFunctions turned;
    const auto all = std::make_shared<const LineFunctions>(functions);
    const auto switches = join_switches(functions);
    const LineForm form = join_forms(functions);
    for (int i = 0; i < 3; ++i) {
        const Vec3 row = R.row(i);
        turned[static_cast<std::size_t>(i)] = LineFunction(
            [all, row](double time, double s) {
                return row.dot(Vec3((*all)[0](time, s), (*all)[1](time, s), (*all)[2](time, s)));
            },
            switches,
            form);
    }
    return turned;
}

// Of what of a load depends on the motion, in the load's frame.
MotionLoad turn(const Quat& rotation, MotionLoad load, Frame frame) {
    if (!load) return load;
    const Mat3 R = rotation.toRotationMatrix();
    const Mat3 out = frame == Frame::body ? Mat3(Mat3::Identity()) : R;
    load.value = [R, out, own = load.value](double time, double s, const PointMotion& motion) {
        const PointMotion back{R.transpose() * motion.position,
                               R.transpose() * motion.velocity,
                               R.transpose() * motion.rotation,
                               R.transpose() * motion.spin};
        const Vec6 value = own(time, s, back);
        Vec6 turned;
        turned << out * value.head<3>(), out * value.tail<3>();
        return turned;
    };
    return load;
}

MagneticField turn(const Quat& rotation, const MagneticField& field) {
    MagneticField turned{.uniform = turn(rotation, field.uniform)};
    if (!field.by_place) return turned;
    const Mat3 R = rotation.toRotationMatrix();
    turned.by_place = [R, own = field.by_place](double time, const Vec3& position) -> Vec3 {
        return R * own(time, R.transpose() * position);
    };
    return turned;
}

Flow turn(const Quat& rotation, Flow flow) {
    if (flow.profile) {
        SpeedProfile& profile = *flow.profile;
        profile.direction = rotation * profile.direction;
        for (std::size_t i = 0; width_of(profile) == 3 && i < profile.speeds.size(); i += 3) {
            const Vec3 turned =
                rotation * Vec3(profile.speeds[i], profile.speeds[i + 1], profile.speeds[i + 2]);
            std::copy_n(turned.data(), 3, &profile.speeds[i]);
        }
    }
    if (!flow.field) return flow;
    const Mat3 R = rotation.toRotationMatrix();
    flow.field = [R, own = flow.field](double time, const Vec3& position) -> Vec3 {
        return R * own(time, R.transpose() * position);
    };
    return flow;
}

// By a rotation about z.
void turn(const Quat& rotation, Surroundings& around) {
    const double angle = 2.0 * std::atan2(rotation.z(), rotation.w());
    if (around.water) {
        around.water->current = turn(rotation, around.water->current);
        for (WaveTrain& train : around.water->waves) train.direction += angle;
    }
    if (around.air) around.air->wind = turn(rotation, around.air->wind);
    if (!around.seabed) return;
    around.seabed->point = rotation * around.seabed->point;
    around.seabed->normal = rotation * around.seabed->normal;
    if (around.seabed->grid) around.seabed->grid->turn += angle;
}

TimeVector turn(const Quat& rotation, const TimeVector& vector) {
    if (vector.is_constant()) return TimeVector(rotation * vector(0.0));
    return TimeVector(turn(rotation, vector.components()));
}

void turn(const Quat& rotation, Obstacle& obstacle) {
    std::visit([&](auto& shape) { shape.turn(rotation); }, obstacle.shape);
    if (!obstacle.motion) return;
    ObstacleMotion& motion = *obstacle.motion;
    motion = {turn(rotation, motion.displacement), turn(rotation, motion.rotation), rotation * motion.about};
}

}  // namespace

Quat restrict_rotation(const Quat& rotation, const Model& model) {
    const bool is_anyhow = model.surroundings.is_empty();
    const Vec3 up = Vec3::UnitZ();
    const auto about = [&](const Vec3& axis) {
        const Vec3 part = rotation.vec().dot(axis) * axis;
        return Quat(rotation.w(), part.x(), part.y(), part.z()).normalized();
    };
    if (!model.plane) return is_anyhow ? rotation : about(up);
    const Vec3 normal = Vec3::Unit(model.plane->normal);
    if (is_anyhow || normal == up) return about(normal);
    return Quat(0.0, 0.0, 0.0, 1.0);  // half a turn, which puts an upright plane on itself
}

std::optional<Vec3> find_small_turn(const Model& model) {
    const bool is_anyhow = model.surroundings.is_empty();
    if (!model.plane) return is_anyhow ? Vec3::UnitX() : Vec3::UnitZ();
    const Vec3 normal = Vec3::Unit(model.plane->normal);
    if (is_anyhow || normal == Vec3::UnitZ()) return normal;
    return std::nullopt;
}

void turn_model(const Quat& rotation, Model& model) {
    model.gravity = turn(rotation, model.gravity);
    turn(rotation, model.surroundings);
    for (Obstacle& obstacle : model.contact.obstacles) turn(rotation, obstacle);
    if (model.rotation) {
        model.rotation->axis = rotation * model.rotation->axis;
        model.rotation->through = rotation * model.rotation->through;
    }
    for (Node& node : model.nodes) {
        node.position = rotation * node.position;
        node.velocity = rotation * node.velocity;
        node.angular_velocity = rotation * node.angular_velocity;
    }
    for (Rod& rod : model.rods) {
        for (Quat& triad : rod.triads) triad = rotation * triad;
    }
    for (Body& body : model.bodies) body.attitude = rotation * body.attitude;
    for_each_anchor(model, [&](Anchor& anchor) { anchor.arm = rotation * anchor.arm; });
    for (Bushing& bushing : model.bushings) bushing.axes = rotation * bushing.axes;
    for (Joint& joint : model.joints) {
        for (JointSide* side : {&joint.a, &joint.b}) side->axes = rotation * side->axes;
    }
    for (Support& support : model.supports) support.axes = rotation * support.axes;
    for (NodalLoad& load : model.loads) {
        load.axes = rotation * load.axes;
        load.by_motion = turn(rotation, load.by_motion, load.frame);
        if (load.frame == Frame::body) continue;
        load.force = turn(rotation, load.force);
        load.moment = turn(rotation, load.moment);
    }
    for (DistributedLoad& load : model.distributed_loads) {
        if (load.field) load.field = turn(rotation, *load.field);
        load.by_motion = turn(rotation, load.by_motion, load.frame);
        if (load.frame == Frame::body) continue;
        load.force = turn(rotation, load.force);
        load.moment = turn(rotation, load.moment);
    }
}

void turn_problem(const Quat& rotation, Problem& problem) {
    for (std::size_t i = 1; i < problem.stages.size(); ++i) {
        Model own = problem.model;
        set_actions(std::move(problem.stages[i].actions), own);
        turn_model(rotation, own);
        problem.stages[i].actions = take_actions(own);
    }
    turn_model(rotation, problem.model);
    for (HistoryRequest& request : problem.output.histories) {
        request.relative_axes = rotation * request.relative_axes;
        if (request.about) request.about = rotation * *request.about;
        if (request.no_load) request.no_load = rotation * *request.no_load;
    }
}

HistoryRow turn_row(Turning turning, const Quat& rotation, const HistoryRow& row) {
    if (turning == Turning::none) return row;
    if (turning == Turning::vector) {
        const Vec3 turned = rotation * Vec3(row[0], row[1], row[2]);
        return {turned.x(), turned.y(), turned.z(), 0.0};
    }
    Quat turned = rotation * Quat(row[0], row[1], row[2], row[3]);
    if (turning == Turning::rotation_since_start) turned = turned * rotation.conjugate();
    return {turned.w(), turned.x(), turned.y(), turned.z()};
}

}  // namespace gxrod
