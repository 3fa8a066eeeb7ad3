#pragma once

#include "assembly/element_block.hpp"
#include "assembly/residual.hpp"
#include "elements/lanes/kernels.hpp"

namespace gxrod {

// Elements `objective` of one number of nodes, evaluated several at once, but for their rotary inertia.
// Elements whose centre of mass lies beside their nodes are left out; what damps is added by the elements
// themselves.
template <int Nodes>
class RodBatches {
  public:
    using Block = ElementBlock<ObjectiveElement<Nodes>>;

    explicit RodBatches(const Kernels& kernels)
        : width_(kernels.width), kernels_(std::get<RodKernels<Nodes>>(kernels.rods)) {}

    // The block, with its places, and the equations must outlive this.
    void build(const Block& block, const EquationNumbers& equations);
    bool has(std::size_t element) const { return is_member_[element]; }

    // Adds internal and inertial forces of one part of the block's elements.
    void add_forces(std::size_t part,
                    const std::vector<NodeMotion>& motions,
                    const Vec3& gravity,
                    std::vector<Vec6>& nodal,
                    const PartScales& scales) const;
    // Adds the derivatives of these.
    void add_tangents(std::size_t part,
                      const std::vector<NodeMotion>& motions,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;

  private:
    using Rows = RodKernels<Nodes>;
    using Section = std::array<double, Rows::section_rows>;

    // Elements of one part with the same section; the last one fills the lanes that are left.
    struct Batch {
        std::size_t section;
        int count;
        std::array<int, most_lanes> elements;
        std::array<std::array<int, Nodes>, most_lanes> nodes;
    };

    void add_part(std::size_t part);
    void add_to_batches(int element);
    void write_constants();
    const double* constants(std::size_t batch) const {
        return &constants_[batch * Rows::constant_rows * width_];
    }
    // Of elements one by one, where nodes are turned too far for the kernels.
    void add_forces_alone(const Batch& batch,
                          const std::vector<NodeMotion>& motions,
                          const Vec3& gravity,
                          std::vector<Vec6>& nodal,
                          const PartScales& scales) const;
    void add_tangents_alone(const Batch& batch,
                            const std::vector<NodeMotion>& motions,
                            const std::vector<NodeLinearization>& linearizations,
                            std::vector<double>& values) const;
    void add_tangent_of_lane(const double* tangents, int element, std::vector<double>& values) const;
    void add_tangent(NodalMatrix<Nodes>& tangent, int element, std::vector<double>& values) const;

    int width_;
    RodKernels<Nodes> kernels_;
    const Block* block_ = nullptr;
    const EquationNumbers* equations_ = nullptr;
    std::vector<bool> is_member_;
    std::vector<Section> sections_;
    std::vector<Batch> batches_;
    std::vector<std::size_t> first_batch_;  // of each part, and the number of batches
    std::vector<double> constants_;         // of each batch, by rows
};

using AllRodBatches = std::tuple<RodBatches<2>, RodBatches<3>, RodBatches<4>, RodBatches<5>>;

// Whether an element of a block of any kind is in a batch.
template <class E>
bool is_in_batch(const AllRodBatches& batches, const ElementBlock<E>&, std::size_t element) {
    if constexpr (std::is_same_v<E, ObjectiveElement<E::node_count>>) {
        return std::get<RodBatches<E::node_count>>(batches).has(element);
    }
    return false;
}

extern template class RodBatches<2>;
extern template class RodBatches<3>;
extern template class RodBatches<4>;
extern template class RodBatches<5>;

}  // namespace gxrod
