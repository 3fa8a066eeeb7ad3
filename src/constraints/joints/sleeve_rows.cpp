#include "constraints/joints/sleeve_rows.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "constraints/joints/joint_force.hpp"
#include "constraints/joints/joint_motors.hpp"
#include "constraints/joints/play/bound_push.hpp"
#include "constraints/joints/pull_back.hpp"
#include "model/evaluation_error.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

namespace {

// Two directions across a unit vector, which change smoothly with it (Duff et al., J. Comput. Graph. Tech. 6
// (2017) 1).
Eigen::Matrix<double, 3, 2> find_across(const Vec3& t) {
    // The seam between both is far from lines in the global planes.
    const double sign = t.z() < -0.9 ? -1.0 : 1.0;
    const double a = -1.0 / (sign + t.z()), b = t.x() * t.y() * a;
    Eigen::Matrix<double, 3, 2> across;
    across.col(0) << 1.0 + sign * t.x() * t.x() * a, sign * b, -sign * t.x();
    across.col(1) << b, sign + t.y() * t.y() * a, -t.y();
    return across;
}

constexpr int most_iterations = 100;
constexpr double round_off = 1e-15;
// By so much of its length a point may leave a rod.
constexpr double end_tolerance = 1e-9;

}  // namespace

SleeveRows::SleeveRows(const Model& model, const Sleeve& sleeve)
    : sleeve_(&sleeve),
      name_("joint " + sleeve.name),
      rod_(&model.rods[sleeve.rod]),
      nodes_(rod_->nodes),
      line_(arc_lengths_of_nodes(*rod_)) {
    if (!sleeve.holds_turn) return;
    const SmoothLine::Piece& piece = line_.pieces()[static_cast<std::size_t>(line_.find_piece(sleeve.place))];
    const auto weights = piece.compute_weights<1>(sleeve.place);
    Mat3 section = Mat3::Zero();
    for (int i = 0; i < piece.count; ++i)
        section +=
            weights[0][static_cast<std::size_t>(i)] * rod_->triad_at(piece.first + i).toRotationMatrix();
    turn_axes_ = find_turn_axes(section);
}

SleeveTurn SleeveRows::find_turn(const Situation& at, const WidePlace& place, ConstraintLevel level) const {
    std::vector<SleeveTurn::Carrier> nodes;
    for (int i = 0; i < at.points.piece->count; ++i) {
        const int position = first_node(at) + i;
        nodes.push_back(
            carry_axes(&place.nodes[nodes_[position]], rod_->triad_at(position).toRotationMatrix()));
    }
    const NodeMotion* b = has_node() ? &place.nodes[sleeve_->point.node] : nullptr;
    const ScalarJet slide = at.motion().compute_jets(level)[SleeveMotion::slide];
    return {*at.points.piece, slide, std::move(nodes), carry_axes(b, turn_axes_)};
}

Eigen::RowVectorXd SleeveRows::compute_place_gradient(const Situation& at, const WidePlace& place) const {
    const SleeveMotion::Gradient gradient = at.motion().compute_gradient();
    return pull_back(at, place, gradient.row(SleeveMotion::slide).transpose()).transpose();
}

// By the changes of s, ṡ and s̈, and of what nodes carry.
Eigen::MatrixXd SleeveRows::compute_turn_change(const Situation& at,
                                                const WidePlace& place,
                                                const std::vector<NodeLinearization>& linearizations) const {
    const int points = at.points.unknowns();
    SleeveMotion::Change change = SleeveMotion::Change::Zero(SleeveMotion::function_count, 3 * points);
    change.row(0).head(points) = at.motion().compute_gradient().row(SleeveMotion::slide);
    change.row(1) = at.motion().compute_change(ConstraintLevel::velocity).row(SleeveMotion::slide);
    change.row(2) = at.motion().compute_change(ConstraintLevel::acceleration).row(SleeveMotion::slide);
    const Eigen::MatrixXd of_nodes = pull_back_change(at, place, change, linearizations);
    std::vector<const NodeLinearization*> of_node;
    for (const int node : list_nodes(place)) of_node.push_back(&linearizations[node]);
    return find_turn(at, place, ConstraintLevel::acceleration)
        .compute_acceleration_derivative({of_nodes.row(0), of_nodes.row(1), of_nodes.row(2)}, of_node);
}

std::vector<std::vector<int>> SleeveRows::list_groups() const {
    const int owner = has_node() ? sleeve_->point.node : nodes_.front();
    std::vector<std::vector<int>> groups;
    for (const SmoothLine::Piece& piece : line_.pieces()) {
        std::vector<int> group(nodes_.begin() + piece.first, nodes_.begin() + piece.first + piece.count);
        if (std::find(group.begin(), group.end(), owner) == group.end()) group.push_back(owner);
        groups.push_back(std::move(group));
    }
    return groups;
}

std::vector<int> SleeveRows::list_nodes(const WidePlace& place) const {
    const Situation at = find_situation(place);
    std::vector<int> nodes;
    if (has_node()) nodes.push_back(sleeve_->point.node);
    const auto first = nodes_.begin() + first_node(at);
    nodes.insert(nodes.end(), first, first + at.points.piece->count);
    return nodes;
}

VectorJet SleeveRows::compute_point(const std::vector<NodeMotion>& nodes) const {
    if (!has_node()) return {sleeve_->point.arm, Vec3::Zero(), Vec3::Zero()};
    const NodeMotion& node = nodes[sleeve_->point.node];
    const Vec3 arm = node.Lambda * sleeve_->point.arm;
    const Vec3 arm_rate = node.omega.cross(arm);
    return {node.r + arm, node.v + arm_rate, node.a + node.alpha.cross(arm) + node.omega.cross(arm_rate)};
}

void SleeveRows::set_points(const std::vector<NodeMotion>& nodes,
                            int piece,
                            SleeveMotion::Points& points) const {
    points.piece = &line_.pieces()[static_cast<std::size_t>(piece)];
    for (int i = 0; i < points.piece->count; ++i) {
        const NodeMotion& node = nodes[nodes_[points.piece->first + i]];
        points.jets[1 + i] = {node.r, node.v, node.a};
    }
}

// By Newton's method, from the place before; from piece to piece.
double SleeveRows::find_place(const std::vector<NodeMotion>& nodes,
                              double before,
                              SleeveMotion::Points& points) const {
    double s = before;
    double longest_step = line_.end() - line_.start();
    for (int i = 0; i < most_iterations; ++i) {
        set_points(nodes, line_.find_piece(s), points);
        const PlaceMiss miss = compute_place_miss(points, s);
        // Where the point is beyond the centre of the line's curvature, towards the nearer side.
        const double step =
            miss.slope > 0.0 ? -miss.value / miss.slope : -std::copysign(longest_step, miss.value);
        s += std::clamp(step, -longest_step, longest_step);
        if (std::abs(step) <= round_off * line_.end()) break;
        if (i > most_iterations / 2) longest_step *= 0.5;
    }
    set_points(nodes, line_.find_piece(s), points);
    return s;
}

SleeveRows::Situation SleeveRows::find_situation(const WidePlace& place) const {
    Situation at;
    const std::vector<NodeMotion>& previous = place.state.previous;
    const double before = sleeve_->place + place.before.slide;
    at.points.jets[0] = compute_point(place.nodes);
    set_points(previous, line_.find_piece(before), at.points);
    at.across = find_across(compute_tangent(at.points, before).normalized());
    at.place = find_place(place.nodes, before, at.points);
    return at;
}

ScalarJet SleeveRows::compute_slide(const Situation& at, ConstraintLevel level) const {
    ScalarJet slide = at.motion().compute_jets(level)[SleeveMotion::slide];
    slide.value -= sleeve_->place;
    return slide;
}

Eigen::VectorXd SleeveRows::compute_values(const WidePlace& place,
                                           ConstraintLevel level,
                                           const TimeSpan& step) const {
    const Situation at = find_situation(place);
    const SleeveMotion::Functions functions = at.motion().compute_jets(level);
    Eigen::VectorXd values(count());
    for (int row = 0; row < lengths(); ++row) values[row] = at_level(functions[row], level);
    if (sleeve_->holds_turn) {
        const SleeveTurn::Rows turns = find_turn(at, place, level).compute_jets();
        for (int row = 0; row < SleeveTurn::row_count; ++row)
            values[lengths() + row] = at_level(turns[static_cast<std::size_t>(row)], level);
    }
    if (!sleeve_->slide.motion) return values;
    const PrescribedCoordinate motor = compute_motor(sleeve_->slide.motion, place.time, step, level);
    values[SleeveMotion::slide] -= at_level({motor.value, motor.rate, motor.acceleration}, level);
    if (level == ConstraintLevel::position) values[SleeveMotion::slide] -= sleeve_->place;
    return values;
}

// Forces on the points.
Eigen::VectorXd SleeveRows::pull_back(const Situation& at,
                                      const WidePlace& place,
                                      const Eigen::VectorXd& forces) const {
    Eigen::VectorXd on_nodes = Eigen::VectorXd::Zero(unknowns(at));
    int node = 0;
    if (has_node()) {
        const Vec3 arm = place.nodes[sleeve_->point.node].Lambda * sleeve_->point.arm;
        const Vec3 force = forces.head<3>();
        on_nodes.head<6>() << force, arm.cross(force);
        ++node;
    }
    for (int i = 1; i < at.points.count(); ++i, ++node)
        on_nodes.segment<3>(6 * node) = forces.segment<3>(3 * i);
    return on_nodes;
}

Eigen::MatrixXd SleeveRows::compute_gradient(const WidePlace& place) const {
    const Situation at = find_situation(place);
    const SleeveMotion::Gradient gradient = at.motion().compute_gradient();
    Eigen::MatrixXd of_nodes(count(), unknowns(at));
    for (int row = 0; row < lengths(); ++row)
        of_nodes.row(row) = pull_back(at, place, gradient.row(row).transpose()).transpose();
    if (sleeve_->holds_turn)
        of_nodes.bottomRows<SleeveTurn::row_count>() =
            find_turn(at, place, ConstraintLevel::position)
                .compute_gradient(compute_place_gradient(at, place));
    return of_nodes;
}

Eigen::MatrixXd SleeveRows::pull_back_change(const Situation& at,
                                             const WidePlace& place,
                                             const SleeveMotion::Change& change,
                                             const std::vector<NodeLinearization>& linearizations) const {
    const int points = at.points.unknowns();
    Eigen::MatrixXd of_nodes = Eigen::MatrixXd::Zero(change.rows(), unknowns(at));
    for (int row = 0; row < change.rows(); ++row) {
        const auto of_point = [&](int i) -> VectorJet {
            const auto part = [&](int first) -> Vec3 {
                return change.block<1, 3>(row, first + 3 * i).transpose();
            };
            return {part(0), part(points), part(2 * points)};
        };
        int node = 0;
        if (has_node()) {
            const NodeMotion& motion = place.nodes[sleeve_->point.node];
            const NodeLinearization& linearization = linearizations[sleeve_->point.node];
            const VectorJet& jet = at.points.jets[0];
            const VectorJet arm{jet.value - motion.r, jet.rate - motion.v, jet.acceleration - motion.a};
            const VectorJet g = of_point(0);
            of_nodes.block<1, 3>(row, 0) = pull_back_moved(g, linearization).transpose();
            of_nodes.block<1, 3>(row, 3) = pull_back_carried(arm, g, motion, linearization).transpose();
            ++node;
        }
        for (int i = 1; i < at.points.count(); ++i, ++node) {
            const NodeLinearization& linearization = linearizations[nodes_[first_node(at) + i - 1]];
            of_nodes.block<1, 3>(row, 6 * node) = pull_back_moved(of_point(i), linearization).transpose();
        }
    }
    return of_nodes;
}

Eigen::MatrixXd SleeveRows::compute_acceleration_derivative(
    const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const {
    const Situation at = find_situation(place);
    const SleeveMotion::Change change = at.motion().compute_change(ConstraintLevel::acceleration);
    Eigen::MatrixXd of_nodes(count(), unknowns(at));
    of_nodes.topRows(lengths()) = pull_back_change(at, place, change, linearizations).topRows(lengths());
    if (sleeve_->holds_turn)
        of_nodes.bottomRows<SleeveTurn::row_count>() = compute_turn_change(at, place, linearizations);
    return of_nodes;
}

// A motor's multiplier acts along the line, as laws do.
SleeveMotion::Weights SleeveRows::weigh(const Eigen::VectorXd& multipliers) const {
    SleeveMotion::Weights weights = SleeveMotion::Weights::Zero();
    weights.head(lengths()) = multipliers.head(lengths());
    return weights;
}

// The derivative of Σ weights ∂(function)/∂(δr, δφ).
Eigen::MatrixXd SleeveRows::pull_back_hessian(const Situation& at,
                                              const WidePlace& place,
                                              const SleeveMotion::Weights& weights) const {
    const SleeveMotion::Hessian hessian = at.motion().compute_hessian(weights);
    const int points = at.points.unknowns();
    // How the points follow the unknowns.
    Eigen::MatrixXd follow = Eigen::MatrixXd::Zero(points, unknowns(at));
    for (int j = 0; j < points; ++j)
        follow.row(j) = pull_back(at, place, Eigen::VectorXd::Unit(points, j)).transpose();
    Eigen::MatrixXd derivative = follow.transpose() * hessian * follow;
    if (has_node()) {
        const Vec3 arm = place.nodes[sleeve_->point.node].Lambda * sleeve_->point.arm;
        const Vec3 force = at.motion().compute_gradient().leftCols<3>().transpose() * weights;
        derivative.block<3, 3>(3, 3) += cross_matrix(force) * cross_matrix(arm);
    }
    return derivative;
}

Eigen::MatrixXd SleeveRows::compute_force_derivative(const WidePlace& place,
                                                     const Eigen::VectorXd& multipliers) const {
    const Situation at = find_situation(place);
    SleeveMotion::Weights weights = weigh(multipliers);
    if (!sleeve_->holds_turn) return pull_back_hessian(at, place, weights);
    const SleeveTurn turn = find_turn(at, place, ConstraintLevel::position);
    const Vec3 moments = multipliers.tail<SleeveTurn::row_count>();
    weights[SleeveMotion::slide] += turn.compute_push(moments);
    return pull_back_hessian(at, place, weights) +
           turn.compute_force_derivative(moments, compute_place_gradient(at, place));
}

CoordinateForce SleeveRows::compute_law(const Situation& at, const WidePlace& place) const {
    const JointCoordinate& laws = sleeve_->slide;
    return compute_coordinate_force(laws,
                                    compute_slide(at, ConstraintLevel::velocity),
                                    {laws.rest(place.time), laws.drive(place.time), place.held},
                                    place.slips_before.slide);
}

Vec3 SleeveRows::compute_force_on_point(const Situation& at,
                                        const WidePlace& place,
                                        const Eigen::VectorXd& multipliers) const {
    SleeveMotion::Weights weights = weigh(multipliers);
    if (has_laws()) weights[SleeveMotion::slide] += compute_law(at, place).value;
    if (sleeve_->holds_turn)
        weights[SleeveMotion::slide] += find_turn(at, place, ConstraintLevel::position)
                                            .compute_push(multipliers.tail<SleeveTurn::row_count>());
    return at.motion().compute_gradient().leftCols<3>().transpose() * weights;
}

// The rest of the points is held by nodes: what the ground exerts on them is what it takes of the point.
Eigen::VectorXd SleeveRows::compute_ground_force(const WidePlace& place,
                                                 const Eigen::VectorXd& multipliers) const {
    if (has_node()) return {};
    const Situation at = find_situation(place);
    SleeveMotion::Weights weights = weigh(multipliers);
    if (has_laws()) weights[SleeveMotion::slide] += compute_law(at, place).value;
    Eigen::VectorXd force = pull_back(at, place, at.motion().compute_gradient().transpose() * weights);
    if (sleeve_->holds_turn)
        force += find_turn(at, place, ConstraintLevel::position)
                     .compute_gradient(compute_place_gradient(at, place))
                     .transpose() *
                 multipliers.tail<SleeveTurn::row_count>();
    return force;
}

bool SleeveRows::has_laws() const { return is_acted_on(sleeve_->slide); }

Eigen::VectorXd SleeveRows::compute_law_force(const WidePlace& place) const {
    const Situation at = find_situation(place);
    const SleeveMotion::Gradient gradient = at.motion().compute_gradient();
    return compute_law(at, place).value * pull_back(at, place, gradient.row(SleeveMotion::slide).transpose());
}

Eigen::MatrixXd SleeveRows::compute_law_tangent(const WidePlace& place,
                                                const std::vector<NodeLinearization>& linearizations) const {
    const Situation at = find_situation(place);
    const CoordinateForce force = compute_law(at, place);
    const Eigen::VectorXd gradient =
        pull_back(at, place, at.motion().compute_gradient().row(SleeveMotion::slide).transpose());
    // The motions are their placement: all nodes of a stage have the same.
    const double placement = linearizations.front().placement;
    Eigen::MatrixXd tangent =
        placement * pull_back_hessian(at, place, SleeveMotion::Weights(0.0, 0.0, force.value));
    tangent += placement * force.by_coordinate * gradient * gradient.transpose();
    if (force.by_rate == 0.0) return tangent;
    const SleeveMotion::Change change = at.motion().compute_change(ConstraintLevel::velocity);
    const Eigen::MatrixXd rate = pull_back_change(at, place, change, linearizations);
    return tangent + force.by_rate * gradient * rate.row(SleeveMotion::slide);
}

Eigen::VectorXd SleeveRows::compute_held_derivative(const WidePlace& place) const {
    const Situation at = find_situation(place);
    const SleeveMotion::Gradient gradient = at.motion().compute_gradient();
    return compute_law(at, place).by_held *
           pull_back(at, place, gradient.row(SleeveMotion::slide).transpose());
}

double SleeveRows::compute_strain_energy(const WidePlace& place) const {
    if (!has_laws()) return 0.0;
    const JointCoordinate& laws = sleeve_->slide;
    const double slide = compute_slide(find_situation(place), ConstraintLevel::position).value;
    return compute_coordinate_energy(laws,
                                     slide,
                                     {laws.rest(place.time), laws.drive(place.time), place.held},
                                     compute_slip(laws.friction, slide, place.slips_before.slide));
}

bool SleeveRows::is_damped() const { return is_damped_by(sleeve_->slide); }

double SleeveRows::compute_damping_power(const WidePlace& place) const {
    if (!is_damped()) return 0.0;
    const ScalarJet slide = compute_slide(find_situation(place), ConstraintLevel::velocity);
    return compute_coordinate_damping_power(sleeve_->slide, slide);
}

double SleeveRows::compute_damping_action(const WidePlace& place) const {
    if (!is_damped()) return 0.0;
    const WidePlace at_start{
        place.state.previous, place.state, place.before, place.slips_before, place.time, place.held};
    ScalarJet before{place.before.slide, 0.0, 0.0};
    if (sleeve_->slide.limits.act())
        before.rate = compute_slide(find_situation(at_start), ConstraintLevel::velocity).rate;
    return compute_coordinate_damping_action(sleeve_->slide,
                                             before,
                                             compute_slide(find_situation(place), ConstraintLevel::velocity),
                                             place.state.trial_time - place.state.time);
}

double SleeveRows::compute_slip_dissipation(const WidePlace& place) const {
    const Friction& friction = sleeve_->slide.friction;
    if (!friction.acts()) return 0.0;
    const double slide = compute_slide(find_situation(place), ConstraintLevel::position).value;
    const double before = place.slips_before.slide;
    return gxrod::compute_slip_dissipation(
        friction, place.held, before, compute_slip(friction, slide, before));
}

bool SleeveRows::is_driven() const { return is_driven_by(sleeve_->slide); }

Vec6 SleeveRows::compute_driving_forces(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
    const JointCoordinate& laws = sleeve_->slide;
    const Vec6 coordinates = compute_coordinates(place);
    Vec6 forces = Vec6::Zero();
    forces[1] = laws.drive(place.time) + (laws.motion ? multipliers[SleeveMotion::slide] : 0.0);
    forces[3] = laws.stiffness * (coordinates[3] - coordinates[1]);
    return forces;
}

Vec6 SleeveRows::compute_coordinates(const WidePlace& place) const {
    Vec6 coordinates = Vec6::Zero();
    coordinates[1] = compute_slide(find_situation(place), ConstraintLevel::position).value;
    coordinates[3] = sleeve_->slide.rest(place.time);
    return coordinates;
}

double SleeveRows::compute_driving_power(const WidePlace& place,
                                         const Eigen::VectorXd& multipliers,
                                         const TimeSpan& step) const {
    const Vec6 forces = compute_driving_forces(place, multipliers);
    const ScalarJet slide = compute_slide(find_situation(place), ConstraintLevel::velocity);
    return forces[1] * slide.rate + forces[3] * differentiate(sleeve_->slide.rest, place.time, step);
}

// The section's y axis is interpolated between the nodes on both sides, and made perpendicular to the line.
Mat3 SleeveRows::compute_force_axes(const Situation& at, const std::vector<NodeMotion>& nodes) const {
    const auto y_axis_at = [&](int position) -> Vec3 {
        return nodes[nodes_[position]].Lambda * (rod_->triad_at(position) * Vec3::UnitY());
    };
    const int piece = line_.find_piece(at.place);
    const SmoothLine::Piece& between = *at.points.piece;
    const double u = std::clamp((at.place - between.start) / between.length, 0.0, 1.0);
    const Vec3 y = (1.0 - u) * y_axis_at(piece) + u * y_axis_at(piece + 1);
    const Vec3 along = compute_tangent(at.points, at.place).normalized();
    const Vec3 across = (y - y.dot(along) * along).normalized();
    Mat3 axes;
    axes << along, across, along.cross(across);
    return axes;
}

JointValues SleeveRows::compute_joint_values(const WidePlace& place,
                                             const Eigen::VectorXd& multipliers) const {
    const Situation at = find_situation(place);
    const ScalarJet slide = compute_slide(at, ConstraintLevel::velocity);
    JointValues values;
    values.slide = slide.value;
    values.slide_rate = slide.rate;
    values.force = compute_force_on_point(at, place, multipliers);
    const Mat3 axes = compute_force_axes(at, place.nodes);
    values.force_in_joint = axes.transpose() * values.force;
    if (sleeve_->holds_turn) {
        values.moment = find_turn(at, place, ConstraintLevel::position)
                            .compute_moment(multipliers.tail<SleeveTurn::row_count>());
        values.moment_in_joint = axes.transpose() * values.moment;
    }
    values.drive_slide =
        sleeve_->slide.motion ? multipliers[SleeveMotion::slide] : sleeve_->slide.drive(place.time);
    values.friction =
        compute_friction_force(sleeve_->slide.friction, place.held, slide.value, place.slips_before.slide);
    return values;
}

void SleeveRows::check_range(const WidePlace& place) const {
    const double s = find_situation(place).place;
    const double tolerance = end_tolerance * (line_.end() - line_.start());
    if (s >= line_.start() - tolerance && s <= line_.end() + tolerance) return;
    const bool is_end = s > line_.end();
    std::ostringstream time;
    time << place.time;
    throw EvaluationError(name() + " runs off the " + (is_end ? "end" : "start") + " of rod " + rod_->name +
                          " at t = " + time.str() + "; end the run before, or stop it there: limits = { " +
                          (is_end ? "upper" : "lower") + " = …, stiffness = … }");
}

double SleeveRows::find_first_slip(const WidePlace& place) const {
    const Situation at = find_situation(place);
    double speed = 0.0;
    for (int i = 0; i < at.points.count(); ++i) speed = std::max(speed, at.points.jets[i].rate.norm());
    return compute_first_slip(sleeve_->slide.friction, compute_slide(at, ConstraintLevel::velocity), speed);
}

double SleeveRows::commit(const WidePlace& place, JointState& state) const {
    const Situation at = find_situation(place);
    state.slide = at.place - sleeve_->place;
    // In the directions across the line where it is now.
    const Vec3 across = at.across * Eigen::Map<const Eigen::Vector2d>(state.multipliers.data());
    Eigen::Map<Eigen::Vector2d>(state.multipliers.data()) =
        find_across(compute_tangent(at.points, at.place).normalized()).transpose() * across;
    return compute_slip(sleeve_->slide.friction, state.slide, place.slips_before.slide);
}

}  // namespace gxrod
