#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "constraints/supports.hpp"
#include "state/motion.hpp"

namespace gxrod {

// Unknowns that belong to no node, such as the multipliers of a joint, and the node whose unknowns they
// follow.
struct AttachedUnknowns {
    int node = 0;
    int count = 0;
};

// The equation of each unknown: six for each node (δr, δφ), −1 where a support holds it, followed by the
// unknowns attached to the node. If a node's support has its own axes, its unknowns are in these axes.
class EquationNumbers {
  public:
    // The supports must outlive it.
    explicit EquationNumbers(const Supports& supports, std::span<const AttachedUnknowns> attached = {});

    std::int64_t count() const { return firsts_.back(); }
    std::size_t node_count() const { return firsts_.size() - 1; }
    std::array<std::int64_t, 6> of_node(int node) const {
        const HeldComponents& held = supports_->held(node);
        std::array<std::int64_t, 6> numbers;
        std::int64_t next = firsts_[node];
        for (int i = 0; i < 6; ++i) numbers[i] = held[i] ? -1 : next++;
        return numbers;
    }
    // Whether a node has all six unknowns, in global axes: then their numbers are consecutive.
    bool is_free(int node) const { return free_count(node) == 6 && !supports_->has_own_axes(node); }
    // The equations of a node and its attached unknowns: from first_of to end_of.
    std::int64_t first_of(int node) const { return firsts_[node]; }
    std::int64_t end_of(int node) const { return firsts_[node + 1]; }
    // The first equation of attached unknowns.
    std::int64_t of_attached(std::size_t index) const { return attached_firsts_[index]; }
    std::int64_t attached_count() const { return attached_count_; }
    const Supports& supports() const { return *supports_; }

    struct Unknown {
        int node;           // node; for attached unknowns, the node that they follow
        int component;      // 0 … 5: x y z rx ry rz; −1: attached
        int attached = -1;  // index of the attached group
        int place = -1;     // place within that group
    };
    // Finds the unknown of an equation by search: not for use in loops over equations.
    Unknown unknown(std::int64_t equation) const;

    // Turn global components of a node into the axes of its unknowns, and back.
    Vec6 to_own_axes(int node, const Vec6& global) const;
    Vec6 to_global_axes(int node, const Vec6& own) const;
    // Makes the velocities of a node zero where a support holds it.
    void hold_rates(int node, NodeMotion& motion) const;
    // The increment (δr, δφ) of a node, global components, zero where held.
    Vec6 increment_of(int node, const Eigen::VectorXd& solution) const;

  private:
    std::int64_t free_count(int node) const;

    const Supports* supports_;
    std::vector<std::int64_t> firsts_;  // first equation of each node, and the number of all
    std::vector<AttachedUnknowns> attached_;
    std::vector<std::int64_t> attached_firsts_;
    std::int64_t attached_count_ = 0;
};

}  // namespace gxrod
