#pragma once

#include <span>
#include <vector>

#include "assembly/residual.hpp"
#include "model/model.hpp"

namespace gxrod {

// The force and the moment with which a residual is compared.
struct ResidualScales {
    double force, moment;
    double of(int component) const { return component < 3 ? force : moment; }
};

// The scales of each node.
class NodeScales {
  public:
    // Takes the same scales for all nodes; or scales for each group, and the group of each node, which must
    // outlive this.
    explicit NodeScales(const ResidualScales& common) : common_(common) {}
    NodeScales(std::vector<ResidualScales> of_groups, const std::vector<int>& group_of_node)
        : of_groups_(std::move(of_groups)), group_of_node_(&group_of_node) {}

    const ResidualScales& of(int node) const {
        return group_of_node_ ? of_groups_[(*group_of_node_)[node]] : common_;
    }

  private:
    ResidualScales common_{0.0, 0.0};
    std::vector<ResidualScales> of_groups_;
    const std::vector<int>* group_of_node_ = nullptr;
};

// Chooses the forces with which a node's residual is compared. A group is a rod, a body, a spring, a bushing,
// or a node that several of them share. A part of the model consists of the groups whose nodes elements
// couple to each other. A residual is small if it is small against the largest force in its part and against
// a thousand times the largest force in its own group, so that a weakly loaded rod next to a strong one is
// solved too. Neither falls below the round-off of forces there.
class ScaleGroups {
  public:
    explicit ScaleGroups(const Model& model);

    std::size_t count() const { return part_of_group_.size(); }
    std::size_t part_count() const { return lengths_.size(); }
    int of_rod(int rod) const { return rod; }
    int of_body(int body) const { return rod_count_ + body; }
    // Takes the place of the spring or bushing in list_element_ties.
    int of_tie(std::size_t tie) const { return first_tie_ + static_cast<int>(tie); }
    int of_node(int node) const { return group_of_node_[node]; }
    int part_of_node(int node) const { return part_of_group_[group_of_node_[node]]; }
    // Returns the length scale of the node's part: its extent or its largest body, whichever is larger; 1 if
    // both are zero.
    double length_at(int node) const { return lengths_[part_of_group_[group_of_node_[node]]]; }

    // Returns the forces in a group and, at a shared node, in the groups that meet there.
    ForceScales acting_in(int group, const Residual& residual) const;
    // Computes the scales of each node from the forces in the groups; valid as long as this.
    NodeScales compute_scales(const Residual& residual) const;

  private:
    void find_nodes(const Model& model);
    void find_parts_of_groups(const Model& model);
    void find_round_off(const Model& model);

    int rod_count_;
    int first_tie_;
    std::vector<int> group_of_node_;
    std::vector<int> part_of_group_;
    std::vector<double> lengths_;  // length scale of each part
    std::vector<std::vector<int>>
        neighbours_;  // for each group that is a shared node: the groups that meet there
    std::vector<ResidualScales> round_off_;  // for each group, the round-off of forces on a node
};

// Relates forces and moments: a force at some length is a moment, so neither falls to round-off of the other.
ResidualScales relate_scales(const ForceScales& scales, double length);

}  // namespace gxrod
