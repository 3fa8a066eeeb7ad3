#pragma once

#include "assembly/element_block.hpp"
#include "assembly/residual.hpp"
#include "elements/lanes/kernels.hpp"
#include "parallel/work_phases.hpp"

namespace gxrod {

// What rods lump to their nodes, rotary inertia or the factors of its damping, summed over the elements of a
// node and evaluated for several nodes at once.
class RotaryBatches {
  public:
    // The kernels, `width` lanes wide, say what the inertia makes: inertial moments, or the damping in
    // proportion to it. The equations must outlive this.
    RotaryBatches(const RotaryKernels& kernels, int width, const EquationNumbers& equations);

    // `inertia` is in the global axes of t = 0, `group` that of the node in ScaleGroups. All of it before
    // lay_out.
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
    // Adds the derivatives of these.
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
    std::vector<int> nodes_;   // that have rotary inertia
    std::vector<int> groups_;  // of each of these: its place among those of its part
    std::vector<std::vector<int>> part_groups_;
    std::vector<ElementPlaces<1>> places_;  // of each of these
    std::vector<double> constants_;         // their inertia: of each batch, by rows
    // Until they are laid out: of each node its index among nodes_, −1 of none; and inertias, one of these.
    std::vector<int> index_;
    std::vector<Mat3> inertias_;
};

}  // namespace gxrod
