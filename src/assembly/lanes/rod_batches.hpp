#pragma once

#include "assembly/element_block.hpp"
#include "assembly/residual.hpp"
#include "elements/lanes/kernels.hpp"

namespace gxrod {

// Elements `objective` of one number of nodes, evaluated several at once, except their inertia and damping
// lumped at nodes.
template <int Nodes>
class RodBatches {
  public:
    using Block = ElementBlock<ObjectiveElement<Nodes>>;

    explicit RodBatches(const Kernels& kernels)
        : width_(kernels.width), kernels_(std::get<RodKernels<Nodes>>(kernels.rods)) {}

    // The block, with its places, and the equations must outlive this.
    void build(const Block& block, const EquationNumbers& equations, const DriveValues& drives);

    // Adds internal, damping and inertial forces of one part of the block's elements.
    void add_forces(std::size_t part,
                    const State& state,
                    const Instant& instant,
                    const Vec3& gravity,
                    std::vector<Vec6>& nodal,
                    const PartScales& scales) const;
    // Adds damping forces alone.
    void add_damping_forces(std::size_t part,
                            const State& state,
                            const Instant& instant,
                            std::vector<Vec6>& nodal) const;
    // Adds the derivatives of all forces.
    void add_tangents(std::size_t part,
                      const State& state,
                      const Instant& instant,
                      const Vec3& gravity,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;

  private:
    using Rows = RodKernels<Nodes>;

    // Elements of one part that share all branches of the kernels; the last element fills the lanes that are
    // left.
    struct Batch {
        std::size_t section;  // where its rows begin
        bool is_general;      // whether its sections are general
        bool is_damped;
        // Whether its elements are evaluated one by one: kernels have no masses off the axis without inertia,
        // and no sections that are not linear.
        bool is_alone;
        int count;
        // Lanes whose tangents go to whole blocks, and whose order of addition stays the same if they are
        // added together.
        int first_block, last_block;
        std::array<int, most_lanes> elements;
        std::array<std::array<int, Nodes>, most_lanes> nodes;
    };

    bool is_alone(int element, const DriveValues& drives) const;
    void add_part(std::size_t part, const DriveValues& drives);
    void add_to_batches(int element, const DriveValues& drives);
    void write_sections();
    void write_constants();
    void find_blocks(Batch& batch) const;
    const double* constants(std::size_t batch) const {
        return &constants_[batch * Rows::constant_rows * width_];
    }
    const typename Rows::OfSections& kernels_of(const Batch& batch) const {
        return batch.is_general ? kernels_.general : kernels_.plain;
    }
    const double* section(const Batch& batch) const { return &sections_[batch.section]; }
    // Write the inputs of kernels.
    void write_motions(const Batch& batch,
                       const std::vector<NodeMotion>& motions,
                       const Vec3& gravity,
                       double* rows) const;
    void write_linearizations(const Batch& batch,
                              const std::vector<NodeMotion>& motions,
                              const Vec3& gravity,
                              const std::vector<NodeLinearization>& linearizations,
                              double* rows) const;
    // Adds the forces of the first lanes to their nodes.
    void add_lanes(const Batch& batch, const double* forces, std::vector<Vec6>& nodal) const;
    // Add contributions of elements one by one, also if nodes are turned too far for the kernels.
    void add_forces_alone(const Batch& batch,
                          const State& state,
                          const Instant& instant,
                          const Vec3& gravity,
                          std::vector<Vec6>& nodal,
                          const PartScales& scales) const;
    void add_damping_forces_alone(const Batch& batch,
                                  const State& state,
                                  const Instant& instant,
                                  std::vector<Vec6>& nodal) const;
    void add_tangents_alone(const Batch& batch,
                            const State& state,
                            const Instant& instant,
                            const Vec3& gravity,
                            const std::vector<NodeLinearization>& linearizations,
                            std::vector<double>& values) const;
    void add_lanes(const Batch& batch, const double* tangents, std::vector<double>& values) const;
    void add_tangent_of_lane(const double* tangents, int element, std::vector<double>& values) const;
    void add_tangent(NodalMatrix<Nodes>& tangent, int element, std::vector<double>& values) const;

    int width_;
    RodKernels<Nodes> kernels_;
    const Block* block_ = nullptr;
    const EquationNumbers* equations_ = nullptr;
    std::vector<double> sections_;  // shared rows and section rows, once for all batches of a kind
    std::vector<Batch> batches_;
    std::vector<std::size_t> first_batch_;  // first batch of each part, and the number of batches
    std::vector<double> constants_;         // constants of each batch, by rows
};

using AllRodBatches = std::tuple<RodBatches<2>, RodBatches<3>, RodBatches<4>, RodBatches<5>>;

// Whether there are batches for a kind of element.
template <class E>
constexpr bool is_batched = std::is_same_v<E, ObjectiveElement<E::node_count>>;

extern template class RodBatches<2>;
extern template class RodBatches<3>;
extern template class RodBatches<4>;
extern template class RodBatches<5>;

}  // namespace gxrod
