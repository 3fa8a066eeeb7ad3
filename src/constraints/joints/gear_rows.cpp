#include "constraints/joints/gear_rows.hpp"

#include <algorithm>

#include "constraints/joints/play/bound_push.hpp"

namespace gxrod {

namespace {

const NodeMotion ground_at_rest{};
const NodeLinearization linearization_of_ground{};

template <class Value>
const Value& value_at(const std::vector<Value>& values, int node, const Value& of_ground) {
    return node < 0 ? of_ground : values[static_cast<std::size_t>(node)];
}

// Calls visit(coordinate) with the turn or the slide, whichever a term has.
template <class Term, class Visit>
auto visit_coordinate(const Term& term, Visit&& visit) {
    return term.turn ? visit(*term.turn) : visit(*term.slide);
}

}  // namespace

GearRows::GearRows(const Model& model, const Gear& gear) : name_("gear " + gear.name) {
    for (std::size_t i = 0; i < 2; ++i) {
        const GearSide& side = gear.sides[i];
        const Joint& joint = model.joints[static_cast<std::size_t>(side.joint)];
        const JointCoordinates coordinates(joint);
        Term& term = terms_[i];
        term.factor = i == 0 ? gear.ratio : 1.0;
        term.joint = side.joint;
        term.arms = arms_of(joint);
        term.nodes = {joint.a.anchor.node, joint.b.anchor.node};
        term.columns = {find_column(term.nodes[0]), find_column(term.nodes[1])};
        if (side.is_turn)
            term.turn = coordinates.turn;
        else
            term.slide = coordinates.slide->product();
    }
    if (!gear.teeth) return;
    if (gear.teeth->lower == gear.teeth->upper) {  // without backlash they are a spring
        teeth_.stiffness = gear.teeth->stiffness;
        teeth_.damping = gear.teeth->damping;
    } else {
        teeth_.limits = *gear.teeth;
    }
}

// Appends a node that is not there yet.
int GearRows::find_column(int node) {
    if (node < 0) return -1;
    const auto found = std::ranges::find(nodes_, node);
    const auto index = static_cast<int>(found - nodes_.begin());
    if (found == nodes_.end()) nodes_.push_back(node);
    return 6 * index;
}

bool GearRows::is_length(int /*row*/) const { return terms_[1].slide.has_value(); }

std::vector<int> GearRows::list_nodes(const WidePlace& /*place*/) const { return nodes_; }

JointFrames GearRows::frames_of(const Term& term, const WidePlace& place, ConstraintLevel level) const {
    const auto motion = [&](int node) -> const NodeMotion& {
        return value_at(place.nodes, node, ground_at_rest);
    };
    return {{motion(term.nodes[0]), motion(term.nodes[1])}, term.arms, level};
}

ScalarJet GearRows::compute_jet(const WidePlace& place, ConstraintLevel level) const {
    ScalarJet sum{};
    for (const Term& term : terms_) {
        const JointFrames frames = frames_of(term, place, level);
        const double turn_before = place.state.joints_previous[static_cast<std::size_t>(term.joint)].turn;
        const ScalarJet jet =
            term.turn ? term.turn->compute_jet(frames, turn_before) : term.slide->compute_jet(frames);
        sum.value += term.factor * jet.value;
        sum.rate += term.factor * jet.rate;
        sum.acceleration += term.factor * jet.acceleration;
    }
    return sum;
}

Eigen::VectorXd GearRows::compute_values(const WidePlace& place,
                                         ConstraintLevel level,
                                         const TimeSpan& /*step*/) const {
    if (has_laws()) return {};
    return Eigen::VectorXd::Constant(1, at_level(compute_jet(place, level), level));
}

// By the unknowns of all nodes.
void GearRows::add_row(const Term& term, const PairRow& row, Eigen::MatrixXd& sum) const {
    for (int side = 0; side < 2; ++side) {
        const int column = term.columns[static_cast<std::size_t>(side)];
        if (column >= 0) sum.block<1, 6>(0, column) += row.segment<6>(6 * side);
    }
}

Eigen::MatrixXd GearRows::compute_row(const WidePlace& place) const {
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(1, size());
    for (const Term& term : terms_) {
        const JointFrames frames = frames_of(term, place, ConstraintLevel::position);
        PairRow row = PairRow::Zero();
        visit_coordinate(term, [&](const auto& it) { it.add_gradient(frames, term.factor, row); });
        add_row(term, row, gradient);
    }
    return gradient;
}

Eigen::MatrixXd GearRows::compute_change(const WidePlace& place,
                                         const std::vector<NodeLinearization>& linearizations,
                                         const ScalarJet& weights) const {
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(1, size());
    for (const Term& term : terms_) {
        const JointFrames frames = frames_of(term, place, ConstraintLevel::acceleration);
        const auto linearization = [&](int node) -> const NodeLinearization& {
            return value_at(linearizations, node, linearization_of_ground);
        };
        const JointLinearizations of_sides{linearization(term.nodes[0]), linearization(term.nodes[1])};
        const ScalarJet weighted{
            term.factor * weights.value, term.factor * weights.rate, term.factor * weights.acceleration};
        PairRow row = PairRow::Zero();
        visit_coordinate(term, [&](const auto& it) { it.add_change(frames, of_sides, weighted, row); });
        add_row(term, row, change);
    }
    return change;
}

Eigen::MatrixXd GearRows::compute_turned(const WidePlace& place, double multiplier) const {
    Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(size(), size());
    for (const Term& term : terms_) {
        const JointFrames frames = frames_of(term, place, ConstraintLevel::position);
        JointReaction reaction;
        visit_coordinate(
            term, [&](const auto& it) { it.add_reaction(frames, multiplier * term.factor, reaction); });
        const PairMatrix of_sides = reaction.compute_derivative(frames);
        for (int pair = 0; pair < 4; ++pair) {
            const int row = term.columns[static_cast<std::size_t>(pair / 2)];
            const int column = term.columns[static_cast<std::size_t>(pair % 2)];
            if (row < 0 || column < 0) continue;
            derivative.block<6, 6>(row, column) += of_sides.block<6, 6>(6 * (pair / 2), 6 * (pair % 2));
        }
    }
    return derivative;
}

Eigen::MatrixXd GearRows::compute_gradient(const WidePlace& place) const {
    return has_laws() ? Eigen::MatrixXd(0, size()) : compute_row(place);
}

Eigen::MatrixXd GearRows::compute_acceleration_derivative(
    const WidePlace& place, const std::vector<NodeLinearization>& linearizations) const {
    if (has_laws()) return Eigen::MatrixXd(0, size());
    return compute_change(place, linearizations, {0.0, 0.0, 1.0});
}

Eigen::MatrixXd GearRows::compute_force_derivative(const WidePlace& place,
                                                   const Eigen::VectorXd& multipliers) const {
    if (has_laws()) return Eigen::MatrixXd::Zero(size(), size());
    return compute_turned(place, multipliers[0]);
}

// A gear's parts sit in those that carry the joints.
Eigen::VectorXd GearRows::compute_ground_force(const WidePlace& place,
                                               const Eigen::VectorXd& multipliers) const {
    Eigen::MatrixXd exerted = Eigen::MatrixXd::Zero(1, size());
    for (const Term& term : terms_) {
        if (term.nodes[0] >= 0 && term.nodes[1] >= 0) continue;
        const JointFrames frames = frames_of(term, place, ConstraintLevel::position);
        PairRow row = PairRow::Zero();
        visit_coordinate(term, [&](const auto& it) { it.add_gradient(frames, term.factor, row); });
        add_row(term, row, exerted);
    }
    return exerted.transpose() * (has_laws() ? compute_push(place).value : multipliers[0]);
}

JointValues GearRows::compute_joint_values(const WidePlace& place, const Eigen::VectorXd& multipliers) const {
    JointValues values;
    values.drive_turn = has_laws() ? compute_push(place).value : multipliers[0];
    values.play = compute_jet(place, ConstraintLevel::position).value;
    return values;
}

CoordinateForce GearRows::compute_push(const WidePlace& place) const {
    return compute_coordinate_force(teeth_, compute_jet(place, ConstraintLevel::velocity), {}, 0.0);
}

Eigen::VectorXd GearRows::compute_law_force(const WidePlace& place) const {
    return compute_row(place).transpose() * compute_push(place).value;
}

// The motions are their placement: all nodes of a stage have the same.
Eigen::MatrixXd GearRows::compute_law_tangent(const WidePlace& place,
                                              const std::vector<NodeLinearization>& linearizations) const {
    const CoordinateForce push = compute_push(place);
    if (push.by_coordinate == 0.0) return Eigen::MatrixXd::Zero(size(), size());
    return linearizations.front().placement * compute_turned(place, push.value) +
           compute_row(place).transpose() *
               compute_change(place, linearizations, {push.by_coordinate, push.by_rate, 0.0});
}

double GearRows::compute_strain_energy(const WidePlace& place) const {
    if (!has_laws()) return 0.0;
    return compute_coordinate_energy(teeth_, compute_jet(place, ConstraintLevel::position).value, {}, 0.0);
}

double GearRows::compute_damping_power(const WidePlace& place) const {
    if (!is_damped()) return 0.0;
    return compute_coordinate_damping_power(teeth_, compute_jet(place, ConstraintLevel::velocity));
}

double GearRows::compute_damping_action(const WidePlace& place) const {
    if (!is_damped()) return 0.0;
    const WidePlace before{
        place.state.previous, place.state, place.before, place.slips_before, place.time, place.held};
    return compute_coordinate_damping_action(teeth_,
                                             compute_jet(before, ConstraintLevel::velocity),
                                             compute_jet(place, ConstraintLevel::velocity),
                                             place.state.trial_time - place.state.time);
}

}  // namespace gxrod
