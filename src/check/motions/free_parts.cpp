#include "check/motions/free_parts.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "check/mechanism/joint_gradient.hpp"
#include "constraints/joints/list_wide_rows.hpp"
#include "elements/tie_elements.hpp"
#include "model/ties/ties.hpp"
#include "numerics/singular_values.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Of rows with entries up to 1, and of what a motion of length 1 moves a part: zero.
constexpr double round_off = 1e-9;
// So many parts that springs, bushings and joints tie to each other are not examined: it would take longer
// than a user waits.
constexpr std::size_t most_parts = 200;

// Parts that springs, bushings and joints tie to each other. A motion of theirs is (v, size · ω) about the
// centre of each, one after the other.
class TiedParts {
  public:
    TiedParts(const Model& model, std::vector<ModelPart> parts) : model_(model), parts_(std::move(parts)) {
        for (const ModelPart& part : parts_) extents_.push_back(measure(model, part));
    }

    const std::vector<ModelPart>& parts() const { return parts_; }

    // Columns: the free motions.
    Eigen::MatrixXd find_free_motions(const ModelPart& whole) const {
        std::vector<Eigen::MatrixXd> blocks;
        Eigen::Index count = 0;
        const auto add = [&](Eigen::MatrixXd rows) {
            count += rows.rows();
            blocks.push_back(std::move(rows));
        };
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Eigen::MatrixXd own = build_support_rows(model_, parts_[i]);
            Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(own.rows(), unknowns());
            rows.middleCols(6 * static_cast<Eigen::Index>(i), 6) = own;
            add(std::move(rows));
        }
        for_each_element_list(model_, [&](TieKind kind, const auto& ties) {
            const auto build = [&](const auto& element) { return build_rows(element); };
            for (const int index : whole.ties(kind)) add(visit_element(ties[index], build));
        });
        for (const int index : whole.ties(TieKind::joint)) {
            const Joint& joint = model_.joints[index];
            add(carry(joint, compute_start_gradient(model_, joint)));
            add(carry(joint, find_sprung_gradients(joint)));
        }
        for (const auto& rows : list_wide_rows(model_)) {
            const WideGradient gradient = compute_start_gradient(model_, *rows);
            if (std::ranges::binary_search(whole.nodes, gradient.nodes.front())) add(carry(gradient));
        }
        for (const int index : whole.ties(TieKind::gear)) {
            if (model_.gears[index].teeth && *model_.gears[index].teeth->upper == 0.0)
                add(carry(compute_mesh_gradient(model_, index)));
        }
        for (const int index : whole.ties(TieKind::sleeve)) {
            if (model_.sleeves[index].slide.stiffness > 0.0)
                add(carry(compute_slide_gradient(model_, index)));
        }
        if (count == 0) return Eigen::MatrixXd::Identity(unknowns(), unknowns());
        Eigen::MatrixXd all(count, unknowns());
        Eigen::Index row = 0;
        for (const Eigen::MatrixXd& rows : blocks) {
            all.middleRows(row, rows.rows()) = rows;
            row += rows.rows();
        }
        // What is left of the space of the rows.
        const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> space(all.transpose());
        Eigen::Index rank = 0;
        const auto pivots = space.matrixQR().diagonal().cwiseAbs();
        while (rank < pivots.size() && pivots[rank] > round_off) ++rank;
        const Eigen::MatrixXd Q = space.householderQ();
        return Q.rightCols(unknowns() - rank);
    }

    // Whether a motion moves the sides of a joint against each other.
    bool moves(const Joint& joint, const Eigen::VectorXd& motion) const {
        Eigen::Matrix<double, Eigen::Dynamic, 12> relative = Eigen::Matrix<double, 6, 12>::Zero();
        const auto fill = [&](const Anchor& anchor, double sign, Eigen::Index column) {
            const Vec3 arm = anchor.is_ground() ? Vec3::Zero() : anchor.arm;
            relative.block<3, 3>(0, column) = sign * Mat3::Identity();
            relative.block<3, 3>(0, column + 3) = -sign * spin(arm);
            relative.block<3, 3>(3, column + 3) = sign * Mat3::Identity();
        };
        fill(joint.a.anchor, -1.0, 0);
        fill(joint.b.anchor, 1.0, 6);
        return (carry(joint, relative) * motion).norm() > round_off;
    }

  private:
    Eigen::Index unknowns() const { return 6 * static_cast<Eigen::Index>(parts_.size()); }

    std::size_t part_of(int node) const {
        std::size_t part = 0;
        while (!std::ranges::binary_search(parts_[part].nodes, node)) ++part;
        return part;
    }

    // (δr, δφ) of a node by the motion of its part.
    Mat6 carry(std::size_t part, int node) const {
        const double size = extents_[part].size;
        Mat6 moved = Mat6::Identity();
        moved.topRightCorner<3, 3>() = -spin(model_.nodes[node].position - extents_[part].centre) / size;
        moved.bottomRightCorner<3, 3>() /= size;
        return moved;
    }

    // Rows by (δr, δφ) of a joint's A and B, as rows by the motions of the parts, with entries up to 1.
    Eigen::MatrixXd carry(const Joint& joint, const Eigen::Matrix<double, Eigen::Dynamic, 12>& rows) const {
        Eigen::MatrixXd carried = Eigen::MatrixXd::Zero(rows.rows(), unknowns());
        const auto add = [&](const Anchor& anchor, Eigen::Index column) {
            if (anchor.is_ground()) return;
            const std::size_t part = part_of(anchor.node);
            carried.middleCols<6>(6 * static_cast<Eigen::Index>(part)) +=
                rows.middleCols<6>(column) * carry(part, anchor.node);
        };
        add(joint.a.anchor, 0);
        add(joint.b.anchor, 6);
        scale_rows(carried);
        return carried;
    }
    Eigen::MatrixXd carry(const WideGradient& gradient) const {
        Eigen::MatrixXd carried = Eigen::MatrixXd::Zero(gradient.rows.rows(), unknowns());
        for (std::size_t i = 0; i < gradient.nodes.size(); ++i) {
            const std::size_t part = part_of(gradient.nodes[i]);
            carried.middleCols<6>(6 * static_cast<Eigen::Index>(part)) +=
                gradient.rows.middleCols<6>(6 * static_cast<Eigen::Index>(i)) *
                carry(part, gradient.nodes[i]);
        }
        scale_rows(carried);
        return carried;
    }

    static void scale_rows(Eigen::MatrixXd& rows) {
        for (Eigen::Index row = 0; row < rows.rows(); ++row) {
            const double largest = rows.row(row).cwiseAbs().maxCoeff();
            if (largest > 0.0) rows.row(row) /= largest;
        }
    }

    // Of the coordinates that springs of the joint hold.
    Eigen::Matrix<double, Eigen::Dynamic, 12> find_sprung_gradients(const Joint& joint) const {
        Eigen::Matrix<double, Eigen::Dynamic, 12> rows = compute_coordinate_gradients(model_, joint);
        const Eigen::Index turns = joint.has_turn() ? 1 : 0;
        if (joint.turn.stiffness == 0.0) rows.topRows(turns).setZero();
        if (joint.slide.stiffness == 0.0) rows.bottomRows(rows.rows() - turns).setZero();
        return rows;
    }

    // The tangent at t = 0 of a tie's element, of these motions, with entries up to 1; no rows if it is zero.
    template <class E>
    Eigen::MatrixXd build_rows(const E& element) const {
        constexpr int Nodes = E::node_count;
        std::array<NodeMotion, Nodes> at_start;
        Motions<Nodes> motions;
        Eigen::MatrixXd carried = Eigen::MatrixXd::Zero(6 * Nodes, unknowns());
        for (int i = 0; i < Nodes; ++i) {
            const int node = element.nodes[i];
            at_start[i].r = model_.nodes[node].position;
            motions[i] = &at_start[i];
            const std::size_t part = part_of(node);
            carried.block<6, 6>(6 * i, 6 * static_cast<Eigen::Index>(part)) = carry(part, node);
        }
        const NodeLinearization placement{.placement = 1.0};
        Linearizations<Nodes> linearizations;
        linearizations.fill(&placement);
        NodalMatrix<Nodes> tangent = NodalMatrix<Nodes>::Zero();
        element.add_internal_tangent(motions, {}, linearizations, tangent);
        const Eigen::MatrixXd rows = carried.transpose() * tangent * carried;
        const double largest = rows.cwiseAbs().maxCoeff();
        return largest > 0.0 ? Eigen::MatrixXd(rows / largest) : Eigen::MatrixXd(0, unknowns());
    }

    const Model& model_;
    std::vector<ModelPart> parts_;
    std::vector<PartExtent> extents_;
};

// Rows whose product with the columns is zero: what the motions that the columns span leave held.
Eigen::MatrixXd find_held_rows(const Eigen::MatrixXd& columns) {
    if (columns.cols() == 0) return Eigen::MatrixXd::Identity(6, 6);
    const SingularValues svd = find_singular_values(columns);
    const Eigen::Index rank = (svd.values.array() > round_off).count();
    return svd.left.rightCols(6 - rank).transpose();
}

bool has_ties(const ModelPart& part) {
    return std::ranges::any_of(part.ties_by_kind, [](const auto& ties) { return !ties.empty(); });
}

bool has_joints(const ModelPart& part) { return part.has(TieKind::joint) || part.has(TieKind::sleeve); }

// Calls visit(parts tied by rods, the whole part) for each part of the model.
template <class Visit>
void for_each_whole(const Model& model, Visit&& visit) {
    const std::vector<ModelPart> tied_by_rods = find_parts(model, Ties::rods);
    std::vector<std::size_t> part_of(model.nodes.size());
    for (std::size_t part = 0; part < tied_by_rods.size(); ++part) {
        for (const int node : tied_by_rods[part].nodes) part_of[node] = part;
    }
    for (const ModelPart& whole : find_parts(model)) {
        std::vector<ModelPart> parts;
        for (const int node : whole.nodes) {
            const ModelPart& part = tied_by_rods[part_of[node]];
            if (part.nodes.front() == node) parts.push_back(part);
        }
        visit(parts, whole);
    }
}

}  // namespace

std::vector<FreePart> find_free_parts(const Model& model) {
    std::vector<FreePart> free;
    const auto add = [&](const ModelPart& part, std::vector<UnsupportedMotion> motions) {
        if (!motions.empty()) free.push_back({part, std::move(motions)});
    };
    for_each_whole(model, [&](const std::vector<ModelPart>& parts, const ModelPart& whole) {
        if (has_joints(whole)) return;
        if (!has_ties(whole)) return add(parts.front(), find_unsupported_motions(model, parts.front()));
        if (parts.size() > most_parts) return;
        const Eigen::MatrixXd motions = TiedParts(model, parts).find_free_motions(whole);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Eigen::MatrixXd held =
                find_held_rows(motions.middleRows(6 * static_cast<Eigen::Index>(i), 6));
            add(parts[i], find_unsupported_motions(model, parts[i], held));
        }
    });
    return free;
}

std::vector<FreeMechanism> find_free_mechanisms(const Model& model) {
    std::vector<FreeMechanism> free;
    for_each_whole(model, [&](const std::vector<ModelPart>& parts, const ModelPart& whole) {
        if (!has_joints(whole) || parts.size() > most_parts) return;
        const TiedParts tied(model, parts);
        const Eigen::MatrixXd motions = tied.find_free_motions(whole);
        if (motions.cols() == 0) return;
        FreeMechanism found{whole, static_cast<std::size_t>(motions.cols()), {}};
        for (const int joint : whole.ties(TieKind::joint)) {
            bool is_moved = false;
            for (Eigen::Index i = 0; i < motions.cols(); ++i)
                is_moved = is_moved || tied.moves(model.joints[joint], motions.col(i));
            if (is_moved) found.joints.push_back(joint);
        }
        free.push_back(std::move(found));
    });
    return free;
}

std::size_t count_free_motions(const Model& model) {
    std::size_t count = 0;
    for_each_whole(model, [&](const std::vector<ModelPart>& parts, const ModelPart& whole) {
        if (!has_ties(whole)) {
            count += find_unsupported_motions(model, parts.front()).size();
        } else if (parts.size() <= most_parts) {
            count += static_cast<std::size_t>(TiedParts(model, parts).find_free_motions(whole).cols());
        }
    });
    return count;
}

}  // namespace gxrod
