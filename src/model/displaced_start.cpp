#include "model/displaced_start.hpp"

#include <algorithm>

#include "model/ties/joint_card.hpp"
#include "model/ties/ties.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Relative to the model's size: how far points of a joint may be apart.
constexpr double apart_in_start = 1e-9;

double distance_of(const Model& model, const std::array<Anchor, 2>& ends) {
    return (find_place(model, ends[1]) - find_place(model, ends[0])).norm();
}

class StartDisplacer {
  public:
    StartDisplacer(const StartChange& change, Model& model) : change_(change), model_(model) {}

    std::string displace() {
        std::vector<double> lengths;
        for (const Spring& spring : model_.springs) lengths.push_back(distance_of(model_, spring.ends));
        for_each_element_tie(model_, [&](TieKind, auto& tie) { move_ground(tie.ends[0], tie.ends[1]); });
        for (Joint& joint : model_.joints) move_ground(joint.a.anchor, joint.b.anchor);
        for_each_anchor(model_, [&](Anchor& anchor) {
            if (!anchor.is_ground()) anchor.arm = turn_of(anchor.node) * anchor.arm;
        });
        move_nodes();
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            Spring& spring = model_.springs[i];
            if (spring.length > 0.0)
                spring.length = std::max(0.0, spring.length + distance_of(model_, spring.ends) - lengths[i]);
        }
        return find_parted_joint();
    }

  private:
    Quat turn_of(int node) const { return exp_quaternion(change_.turns[static_cast<std::size_t>(node)]); }

    // By how much a node moves a point that it carries, before anything has moved.
    Vec3 shift_of(const Anchor& anchor) const {
        return change_.displacements[static_cast<std::size_t>(anchor.node)] +
               turn_of(anchor.node) * anchor.arm - anchor.arm;
    }

    void move_ground(Anchor& a, Anchor& b) const {
        if (a.is_ground() && !b.is_ground()) a.arm += shift_of(b);
        if (b.is_ground() && !a.is_ground()) b.arm += shift_of(a);
    }

    void move_nodes() {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            model_.nodes[i].position += change_.displacements[i];
        for (std::size_t r = 0; r < model_.rods.size(); ++r) {
            std::vector<Quat>& triads = model_.rods[r].triads;
            for (std::size_t i = 0; i < triads.size(); ++i) {
                const Vec3& turn = change_.section_turns[r][i];
                if (!turn.isZero(0.0)) triads[i] = (exp_quaternion(turn) * triads[i]).normalized();
            }
        }
        for (Body& body : model_.bodies) body.attitude = turn_of(body.node) * body.attitude;
    }

    std::string find_parted_joint() const {
        double size = 0.0;
        for (const Node& node : model_.nodes) size = std::max(size, node.position.norm());
        for (const Joint& joint : model_.joints) {
            if (card_of(joint.kind).is_at_one_place &&
                distance_of(model_, {joint.a.anchor, joint.b.anchor}) > apart_in_start * size)
                return joint.name;
        }
        return "";
    }

    const StartChange& change_;
    Model& model_;
};

}  // namespace

StartChange::StartChange(const Model& model)
    : displacements(model.nodes.size(), Vec3::Zero()), turns(model.nodes.size(), Vec3::Zero()) {
    for (const Rod& rod : model.rods) section_turns.emplace_back(rod.triads.size(), Vec3::Zero());
}

std::string explain_fixed_start(const Model& model) {
    for (const Rod& rod : model.rods) {
        if (!rod.starts_free_of_stress()) return "rod " + rod.name + " does not start free of stress";
    }
    if (!model.gears.empty()) return "gears hold their parts where the deck has them";
    if (!model.sleeves.empty()) return "sleeves are where the deck has them";
    return "";
}

std::string displace_start(const StartChange& change, Model& model) {
    return StartDisplacer(change, model).displace();
}

}  // namespace gxrod
