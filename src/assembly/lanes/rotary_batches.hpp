#pragma once

#include "assembly/element_block.hpp"
#include "assembly/residual.hpp"
#include "elements/lanes/kernels.hpp"
#include "parallel/work_phases.hpp"

namespace gxrod {

// Rotary inertia, or the factors of its damping, that rods lump at their nodes, summed over the elements of a
// node and evaluated for several nodes at once.
class RotaryBatches {
  public:
    // The kernels, `width` lanes wide, turn the inertia into inertial moments, or into damping in proportion
    // to it. The equations must outlive this.
    RotaryBatches(const RotaryKernels& kernels, int width, const EquationNumbers& equations);

    // Adds inertia in the global axes of t = 0, before lay_out; `group` is the node's group in ScaleGroups.
    void add(int node, int group, const Mat3& inertia);
    void lay_out(const SparsePattern& pattern);

    // Each node is in one of the parts.
    std::size_t part_count() const { return (nodes_.size() + part_size - 1) / part_size; }

    // The groups that the nodes of a part belong to.
    std::span<const int> groups(std::size_t part) const { return part_groups_[part]; }

    // Adds moments of the nodes of a part; `scales` are of its groups.
    void add_forces(std::size_t part,
                    const std::vector<NodeMotion>& motions,
                    std::vector<Vec6>& nodal,
                    std::span<ForceScales> scales) const;
    // Adds the derivatives of these moments.
    void add_tangents(std::size_t part,
                      const std::vector<NodeMotion>& motions,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;

  private:
    static constexpr std::size_t part_size = WorkPhases::part_size;  // whole batches of any width

    std::size_t last_of(std::size_t part) const { return std::min(nodes_.size(), (part + 1) * part_size); }
    // The node of a lane; the last node fills the lanes that are left.
    int node_of(std::size_t lane) const { return nodes_[std::min(lane, nodes_.size() - 1)]; }
    void add_tangent(const double* tangents, std::size_t lane, std::vector<double>& values) const;

    void find_part_groups();

    int width_;
    RotaryKernels kernels_;
    const EquationNumbers* equations_;
    std::vector<int> nodes_;   // nodes with rotary inertia
    std::vector<int> groups_;  // for each of these nodes: its place among the groups of its part
    std::vector<std::vector<int>> part_groups_;
    std::vector<ElementPlaces<1>> places_;  // for each of these nodes
    std::vector<double> constants_;         // inertia for each batch, by rows
    // Before lay_out: for each node its index among nodes_, −1 for none; and for each of nodes_ its inertia.
    std::vector<int> index_;
    std::vector<Mat3> inertias_;
};

}  // namespace gxrod
