#include "check/mechanism/mechanism.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>

#include "check/mechanism/joint_gradient.hpp"
#include "check/motions/unsupported_motions.hpp"
#include "constraints/joints/gear_rows.hpp"
#include "model/ties/ties.hpp"
#include "numerics/singular_values.hpp"

namespace gxrod {
namespace {

// Of rows and columns of length 1: zero.
constexpr double round_off = 1e-9;
// More bodies or joints take longer than a user waits.
constexpr std::size_t most_parts = 60;

// The equations of a mechanism, by (v, size · ω) of its bodies, each of length 1.
struct Equations {
    struct Row {
        int joint = -1;  // −1: of a support; gears behind the joints
        bool is_motor = false;
        Eigen::RowVectorXd values;
    };
    std::vector<Row> rows;
    Eigen::Index columns = 0;  // not counting what a plane holds
};

class EquationBuilder {
  public:
    EquationBuilder(const Model& model, const Mechanism& mechanism) : model_(model), mechanism_(mechanism) {
        for (const int body : mechanism.bodies) {
            const int node = model.bodies[body].node;
            column_.emplace(node, 6 * static_cast<Eigen::Index>(column_.size()));
        }
        size_ = measure();
    }

    Equations build() {
        Equations built;
        built.columns = count_columns();
        for (const auto& [node, column] : column_) add_supports(node, column, built);
        for (const int joint : mechanism_.joints) add_joint(joint, built);
        for (const int gear : mechanism_.gears) add_gear(gear, built);
        return built;
    }

  private:
    double measure() const {
        Eigen::AlignedBox3d box;
        for (const auto& [node, column] : column_) box.extend(model_.nodes[node].position);
        for (const int index : mechanism_.joints) {
            const Joint& joint = model_.joints[index];
            for (const JointSide* side : {&joint.a, &joint.b}) box.extend(find_place(model_, side->anchor));
        }
        const double size = box.diagonal().norm();
        return size > 0.0 ? size : 1.0;
    }

    Eigen::Index all_columns() const { return 6 * static_cast<Eigen::Index>(column_.size()); }

    Eigen::Index count_columns() const { return model_.plane ? all_columns() / 2 : all_columns(); }

    // A row that the plane of the deck does not make zero, at length 1.
    void add(Equations::Row row, Equations& built) const {
        for (Eigen::Index i = 0; model_.plane && i < row.values.size(); ++i) {
            if (model_.plane->holds(static_cast<int>(i % 6))) row.values[i] = 0.0;
        }
        const double length = row.values.norm();
        if (length <= round_off) return;
        row.values /= length;
        built.rows.push_back(std::move(row));
    }

    void add_supports(int node, Eigen::Index column, Equations& built) const {
        ModelPart part;
        part.nodes = {node};
        const Eigen::MatrixXd held = build_support_rows(model_, part);
        for (Eigen::Index i = 0; i < held.rows(); ++i) {
            Equations::Row row{.values = Eigen::RowVectorXd::Zero(all_columns())};
            row.values.segment<6>(column) = held.row(i);
            add(std::move(row), built);
        }
    }

    void add_joint(int index, Equations& built) const {
        const Joint& joint = model_.joints[index];
        const JointRows rows(joint);
        const JointMatrix gradient = compute_start_gradient(model_, joint);
        for (int i = 0; i < rows.count(); ++i) {
            const bool is_motor = i == rows.turn_motor_row() || i == rows.slide_motor_row();
            Equations::Row row{
                .joint = index, .is_motor = is_motor, .values = Eigen::RowVectorXd::Zero(all_columns())};
            const double scale = rows.is_length(i) ? 1.0 : size_;
            add_node(joint.a.anchor.node, scale * gradient.row(i).head<6>(), row.values);
            add_node(joint.b.anchor.node, scale * gradient.row(i).tail<6>(), row.values);
            add(std::move(row), built);
        }
    }

    void add_gear(int index, Equations& built) const {
        const GearRows rows(model_, model_.gears[index]);
        if (rows.count() == 0) return;  // teeth that yield hold nothing exactly
        const WideGradient gradient = compute_start_gradient(model_, rows);
        const std::size_t number = number_of(model_, TieKind::gear, static_cast<std::size_t>(index));
        Equations::Row row{.joint = static_cast<int>(number),
                           .values = Eigen::RowVectorXd::Zero(all_columns())};
        const double scale = rows.is_length(0) ? 1.0 : size_;
        for (std::size_t i = 0; i < gradient.nodes.size(); ++i) {
            const auto first = 6 * static_cast<Eigen::Index>(i);
            add_node(gradient.nodes[i], scale * gradient.rows.middleCols<6>(first), row.values);
        }
        add(std::move(row), built);
    }

    // −1: the ground.
    void add_node(int node, Eigen::Matrix<double, 1, 6> row, Eigen::RowVectorXd& values) const {
        if (node < 0) return;
        row.tail<3>() /= size_;
        values.segment<6>(column_.at(node)) += row;
    }

    const Model& model_;
    const Mechanism& mechanism_;
    std::map<int, Eigen::Index> column_;  // by node
    double size_ = 1.0;
};

using Rows = std::vector<const Equations::Row*>;

template <class Test>
Rows choose(const Equations& equations, Test&& test) {
    Rows chosen;
    for (const Equations::Row& row : equations.rows) {
        if (test(row)) chosen.push_back(&row);
    }
    return chosen;
}

Eigen::MatrixXd assemble(const Rows& rows) {
    const Eigen::Index columns = rows.empty() ? 0 : rows.front()->values.size();
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), columns);
    for (std::size_t i = 0; i < rows.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = rows[i]->values;
    return matrix;
}

// The rank of rows, and those that take part in a combination that vanishes.
struct Dependence {
    Eigen::Index rank = 0;
    Rows dependent;
};

Dependence find_dependence(const Rows& rows) {
    if (rows.empty()) return {};
    const SingularValues svd = find_singular_values(assemble(rows));
    Dependence found{svd.rank(round_off), {}};
    const auto vanishing = svd.left.rightCols(static_cast<Eigen::Index>(rows.size()) - found.rank);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        constexpr double takes_part = 1e-6;
        if (vanishing.row(static_cast<Eigen::Index>(i)).norm() > takes_part)
            found.dependent.push_back(rows[i]);
    }
    return found;
}

void add_once(int index, std::vector<int>& list) {
    if (std::ranges::find(list, index) == list.end()) list.push_back(index);
}

// Counts what its equations hold.
void count(const Model& model, Mechanism& mechanism) {
    if (mechanism.bodies.size() > most_parts || mechanism.joints.size() > most_parts) return;
    const Equations equations = EquationBuilder(model, mechanism).build();
    mechanism.is_counted = true;
    const auto is_support = [](const Equations::Row& row) { return row.joint < 0; };
    const Rows supports = choose(equations, is_support);
    const Rows holding = choose(equations, [](const Equations::Row& row) { return !row.is_motor; });
    const Dependence held = find_dependence(holding);
    const Dependence moved = find_dependence(choose(equations, [](const Equations::Row&) { return true; }));
    mechanism.equations = static_cast<int>(holding.size() - supports.size());
    const Eigen::Index by_joints = held.rank - find_dependence(supports).rank;
    mechanism.redundant = mechanism.equations - static_cast<int>(by_joints);
    mechanism.free_motions = static_cast<int>(equations.columns - held.rank);
    mechanism.unmoved = static_cast<int>(equations.columns - moved.rank);
    for (const Equations::Row* row : held.dependent) {
        if (row->joint >= 0) add_once(row->joint, mechanism.redundant_joints);
        mechanism.has_redundant_supports = mechanism.has_redundant_supports || row->joint < 0;
    }
    for (const Equations::Row* row : moved.dependent) {
        if (row->is_motor) add_once(row->joint, mechanism.conflicting_motors);
    }
}

// Sets of bodies' nodes that joints connect.
class BodySets {
  public:
    explicit BodySets(const Model& model) : model_(model), body_of_node_(model.nodes.size(), -1) {
        for (std::size_t body = 0; body < model.bodies.size(); ++body)
            body_of_node_[model.bodies[body].node] = static_cast<int>(body);
        for (const Rod& rod : model.rods) {
            for (const int node : rod.nodes) body_of_node_[node] = -1;
        }
        parents_.resize(model.bodies.size());
        std::iota(parents_.begin(), parents_.end(), 0);
        for (const Joint& joint : model.joints) {
            const int a = body_of(joint.a.anchor);
            const int b = body_of(joint.b.anchor);
            if (a >= 0 && b >= 0) unite(a, b);
        }
        for (const Gear& gear : model.gears) {
            const int first = body_of(model.joints[gear.sides[0].joint]);
            const int second = body_of(model.joints[gear.sides[1].joint]);
            if (first >= 0 && second >= 0) unite(first, second);
        }
    }

    std::vector<Mechanism> list() {
        std::map<int, Mechanism> by_first;
        for (int index = 0; index < static_cast<int>(model_.joints.size()); ++index)
            add_joint(index, by_first);
        for (int index = 0; index < static_cast<int>(model_.gears.size()); ++index) add_gear(index, by_first);
        for (int body = 0; body < static_cast<int>(model_.bodies.size()); ++body) {
            if (body_of_node_[model_.bodies[body].node] != body) continue;
            const auto found = by_first.find(find(body));
            if (found != by_first.end()) found->second.bodies.push_back(body);
        }
        std::vector<Mechanism> mechanisms;
        for (auto& [first, mechanism] : by_first) mechanisms.push_back(std::move(mechanism));
        return mechanisms;
    }

  private:
    // The body that carries an anchor, if its node is of no rod; or −1.
    int body_of(const Anchor& anchor) const { return anchor.is_ground() ? -1 : body_of_node_[anchor.node]; }

    int find(int body) {
        while (parents_[body] != body) body = parents_[body] = parents_[parents_[body]];
        return body;
    }

    void add_joint(int index, std::map<int, Mechanism>& by_first) {
        const Joint& joint = model_.joints[index];
        const int a = body_of(joint.a.anchor);
        const int b = body_of(joint.b.anchor);
        if (a < 0 && b < 0) return;
        Mechanism& mechanism = by_first[find(std::max(a, b))];
        const auto is_of_rod = [](const Anchor& anchor, int body) { return !anchor.is_ground() && body < 0; };
        if (is_of_rod(joint.a.anchor, a) || is_of_rod(joint.b.anchor, b)) {
            ++mechanism.joints_to_rods;
            return;
        }
        mechanism.joints.push_back(index);
        mechanism.motors += int(joint.turn.motion.has_value()) + int(joint.slide.motion.has_value());
    }

    // A body that the joint ties, and −1 if it also ties a point of a rod, or no body.
    int body_of(const Joint& joint) const {
        for (const JointSide* side : {&joint.a, &joint.b}) {
            if (!side->anchor.is_ground() && body_of(side->anchor) < 0) return -1;
        }
        return body_of(joint.moving_anchor());
    }

    // One with a joint of rods is among what the numbers leave out.
    void add_gear(int index, std::map<int, Mechanism>& by_first) {
        const std::array<GearSide, 2>& sides = model_.gears[index].sides;
        const int first = body_of(model_.joints[sides[0].joint]);
        const int second = body_of(model_.joints[sides[1].joint]);
        if (first >= 0 && second >= 0) by_first[find(first)].gears.push_back(index);
    }

    void unite(int a, int b) {
        const auto [first, second] = std::minmax({find(a), find(b)});
        parents_[second] = first;
    }

    const Model& model_;
    std::vector<int> body_of_node_;
    std::vector<int> parents_;
};

std::string count_words(int number, const char* one, const char* several) {
    return fmt::format("{} {}", number, number == 1 ? one : several);
}

// Of a joint, or of a gear behind them.
std::string name_of(int index, const Model& model) {
    const int joints = static_cast<int>(number_of(model, TieKind::gear, 0));
    return index < joints ? model.joints[index].name : "gear " + model.gears[index - joints].name;
}

std::string list_names(const std::vector<int>& joints, const Model& model) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(joints.size(), most); ++i)
        names.push_back(name_of(joints[i], model));
    const std::string text = fmt::format("{}", fmt::join(names, ", "));
    return joints.size() > most ? fmt::format("{} and {} more", text, joints.size() - most) : text;
}

std::string describe_freedom(const Mechanism& mechanism) {
    if (mechanism.joints_to_rods > 0) return "";
    std::string text = ": " + count_words(mechanism.free_motions, "free motion", "free motions");
    if (mechanism.motors == 0) return text;
    text += ", with " + count_words(mechanism.motors, "motor", "motors");
    return mechanism.unmoved == 0
               ? text
               : text + fmt::format(
                            " that {} {}", mechanism.motors == 1 ? "leaves" : "leave", mechanism.unmoved);
}

std::string describe_redundancy(const Mechanism& mechanism, const Model& model) {
    if (mechanism.redundant == 0) return "";
    return fmt::format(
        "; {} redundant (joints {}{}): the motion is unique, forces and moments of these joints are one "
        "choice "
        "of many",
        mechanism.redundant == 1 ? "1 equation is" : fmt::format("{} equations are", mechanism.redundant),
        list_names(mechanism.redundant_joints, model),
        mechanism.has_redundant_supports ? ", supports" : "");
}

// `name` tells it from others; "" of the only one.
std::string describe(const Mechanism& mechanism, const std::string& name, const Model& model) {
    std::string text = fmt::format("mechanism{}: {}, {}",
                                   name,
                                   count_words(static_cast<int>(mechanism.bodies.size()), "body", "bodies"),
                                   count_words(static_cast<int>(mechanism.joints.size()), "joint", "joints"));
    if (!mechanism.gears.empty())
        text += ", " + count_words(static_cast<int>(mechanism.gears.size()), "gear", "gears");
    if (mechanism.joints_to_rods > 0) text += fmt::format(" and {} to rods", mechanism.joints_to_rods);
    if (!mechanism.is_counted) return text + "; too many to count free motions\n";
    text += fmt::format(", {}", count_words(mechanism.equations, "equation", "equations"));
    if (mechanism.redundant > 0)
        text += fmt::format(" of rank {}", mechanism.equations - mechanism.redundant);
    return text + describe_freedom(mechanism) + describe_redundancy(mechanism, model) + "\n";
}

}  // namespace

std::vector<Mechanism> find_mechanisms(const Model& model) {
    if (model.joints.empty()) return {};
    std::vector<Mechanism> mechanisms = BodySets(model).list();
    for (Mechanism& mechanism : mechanisms) count(model, mechanism);
    return mechanisms;
}

ItemList list_mechanisms(const Model& model) {
    ItemList list{"mechanisms", {}};
    const std::vector<Mechanism> mechanisms = find_mechanisms(model);
    for (const Mechanism& mechanism : mechanisms) {
        const std::string& first = model.bodies[mechanism.bodies.front()].name;
        list.items.push_back(describe(mechanism, mechanisms.size() > 1 ? " with body " + first : "", model));
    }
    return list;
}

std::vector<std::string> find_motor_conflicts(const Model& model) {
    std::vector<std::string> sentences;
    for (const Mechanism& mechanism : find_mechanisms(model)) {
        if (mechanism.conflicting_motors.empty()) continue;
        const bool is_one = mechanism.conflicting_motors.size() == 1;
        sentences.push_back(
            fmt::format("the motor{} of {} move{} what joints, supports or other motors hold or "
                        "move already; leave one out, or drive it by `drive`",
                        is_one ? "" : "s",
                        list_names(mechanism.conflicting_motors, model),
                        is_one ? "s" : ""));
    }
    return sentences;
}

}  // namespace gxrod
