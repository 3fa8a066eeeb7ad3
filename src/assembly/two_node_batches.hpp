#pragma once

#include "assembly/element_block.hpp"
#include "assembly/residual.hpp"
#include "elements/lanes/kernels.hpp"

namespace gxrod {

// Elements `objective` with two nodes, evaluated several at once, and the rotary inertia of their nodes, once
// a node. Elements whose centre of mass lies beside their nodes are left out; what damps is added by the
// elements themselves.
class TwoNodeBatches {
  public:
    using Block = ElementBlock<ObjectiveElement<2>>;

    explicit TwoNodeBatches(const Kernels& kernels) : width_(kernels.width), kernels_(kernels.two_node) {}

    // The block, with its places, and the equations must outlive this.
    void build(const Block& block, const EquationNumbers& equations);
    // Whether an element of any block is among them.
    template <class AnyBlock>
    bool has(const AnyBlock&, std::size_t element) const {
        if constexpr (std::is_same_v<AnyBlock, Block>) return is_member_[element];
        return false;
    }

    // Adds internal and inertial forces.
    void add_forces(const std::vector<NodeMotion>& motions, const Vec3& gravity, Residual& residual) const;
    // Adds the derivatives of these.
    void add_tangents(const std::vector<NodeMotion>& motions,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;

  private:
    template <class T>
    using Lanes = std::array<T, most_lanes>;
    using Section = std::array<double, TwoNodeKernels::section_rows>;

    // Elements with the same section; the last one fills the lanes that are left.
    struct Batch {
        std::size_t section;
        int count;
        Lanes<int> elements;
        Lanes<std::array<int, 2>> nodes;
    };
    void add_to_batches(int element);
    void write_constants();
    const double* constants(std::size_t batch) const {
        return &constants_[batch * TwoNodeKernels::constant_rows * width_];
    }
    void add_tangent(const double* tangents, int element, std::vector<double>& values) const;

    int width_;
    TwoNodeKernels kernels_;
    const Block* block_ = nullptr;
    const EquationNumbers* equations_ = nullptr;
    std::vector<bool> is_member_;
    std::vector<Section> sections_;
    std::vector<Batch> batches_;
    std::vector<double> constants_;  // of each batch, by rows
};

}  // namespace gxrod
