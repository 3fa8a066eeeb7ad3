#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contribution.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "environment/fluid_field.hpp"
#include "loads/bed_force.hpp"
#include "loads/distributed_load.hpp"
#include "loads/fluid_force.hpp"
#include "model/model.hpp"
#include "parallel/thread_team.hpp"
#include "state/memory_slice.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"

namespace gxrod {

// Adds forces of water, air and the ground on the nodes of rods and bodies. A force per length is computed at
// the nodes of an element and distributed with ∫ N_I N_J ds, like a load that turns with the rod. Each node
// of a rod touches the ground by itself, with its share of the rod's length. The class caches the water at
// the last requested motions, which does not change results.
class SurroundingsAssembly : public Contribution {
  public:
    // The model and the threads must outlive it.
    SurroundingsAssembly(const Model& model, const ThreadTeam& team);
    void lay_out(const Layout& layout) override;

    bool empty() const { return elements_.empty() && bodies_.empty() && contacts_.empty(); }
    // The numbers in State::memory: BedContact of each piece with friction on the ground.
    std::size_t memory_count() const override {
        return rubs_ ? numbers_of_bed_contact * contacts_.size() : 0;
    }
    // Returns the memory of a piece, at each node that can touch.
    BedContact contact_before(std::size_t contact, const State& state) const;

    void subtract_forces(const State& state,
                         double time,
                         const ConstraintRequest& request,
                         Residual& residual) const override;
    void add_tangents(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const override;
    void commit(State& state, double time) const override;
    void forget() const override;
    void subtract_element_forces(const State& state,
                                 double time,
                                 const RodPlace& place,
                                 Eigen::Ref<Eigen::VectorXd> forces) const override;

    // `shapes` are the shape functions at the place.
    PointSurroundings compute_point_value(const State& state,
                                          double time,
                                          const RodPlace& place,
                                          const ShapeValues& shapes) const;
    // Compute for frames p_i A_i − p_o A_o at the middle of each element of the model's rods, and the force
    // of the ground per length at each of its nodes; zero where nothing presses, empty if nothing can. Both
    // are valid until the next call.
    std::span<const double> compute_pressure_forces(const State& state, double time) const;
    std::span<const Vec3> compute_bed_forces(const State& state, double time) const;
    PointSurroundings compute_body_value(const State& state, double time, std::size_t body) const;

  private:
    struct WetElement {
        int rod = 0;
        int element = 0;
        std::vector<int> nodes{};
        std::vector<std::size_t> places{};  // place of each node in places_
        std::vector<Quat> triads{};         // section axes at t = 0
        std::vector<const SectionInFluid*> sections{};
        std::vector<double> weights{};  // ∫ N_I N_J ds, column by column
        std::vector<double> piece_lengths, piece_offsets;
        std::vector<std::int64_t> slots{};
    };
    struct WetBody {
        int body = 0;
        int node = 0;
        BodyInFluid fluid{};  // without added mass if no inertia resists
        std::vector<std::int64_t> slots{};
    };
    // A node of a rod that can touch the ground, with the tangent of the rod at t = 0.
    struct Contact {
        int rod = 0;
        int node = 0;
        double radius = 0.0;
        double area = 0.0;
        Vec3 axis = Vec3::Zero();
        double length = 0.0;
        std::vector<std::int64_t> slots{};
    };
    // The surroundings of a node.
    struct Around {
        Vec3 position = Vec3::Zero();
        WaterAt water{};
        AirAt air{};
        bool has_gradients = false;
    };

    void add_rod(int rod);
    void add_contacts(int rod);
    void move_to(double time) const;
    // Evaluates the fields at the nodes, for the functions below.
    void look_around(const State& state, double time, bool asks_gradients) const;
    void find_fluids(const Vec3& position, bool gradients, Around& around) const;
    FluidsAt fluids_at(const Around& around) const;
    WetPoint wet_point(const WetElement& element, std::size_t node, const NodeMotion& motion) const;
    LoadVector compute_force(const WetElement& element, const State& state) const;
    LoadMatrix compute_tangent(const WetElement& element,
                               const State& state,
                               const std::vector<NodeLinearization>& linearizations) const;
    Around around_body(const WetBody& body, const State& state) const;
    // `factor` is that of the ground, 0 without ground.
    BedForce compute_contact(std::size_t contact, const State& state, double factor) const;
    double bed_factor(double time) const;
    BedPoint bed_point(const Contact& contact, const NodeMotion& motion) const;
    MemorySlice memory_of(std::size_t contact) const {
        return memory_.piece(contact, numbers_of_bed_contact);
    }
    const WetElement* find_element(int rod, int element) const;

    const Model* model_;
    const ThreadTeam* team_;
    const EquationNumbers* equations_ = nullptr;
    const ScaleGroups* groups_ = nullptr;
    std::vector<WetElement> elements_;           // the elements of each rod follow each other
    std::vector<std::ptrdiff_t> first_element_;  // for each rod, index in elements_; −1: dry
    std::vector<WetBody> bodies_;
    std::vector<Contact> contacts_;
    std::vector<int> places_;  // nodes whose surroundings are evaluated, each once
    MemorySlice memory_;
    bool rubs_ = false;
    bool has_fluid_ = false;
    std::unique_ptr<FluidField> field_;
    mutable std::vector<Around> around_;      // for each of places_
    mutable std::vector<LoadVector> forces_;  // for each of elements_
    mutable std::vector<double> pressure_forces_;
    mutable std::vector<Vec3> bed_forces_;
    mutable Vec3 gravity_ = Vec3::Zero();
    mutable double water_factor_ = 1.0;
    mutable double time_ = 0.0;
    mutable bool is_known_ = false;
};

}  // namespace gxrod
