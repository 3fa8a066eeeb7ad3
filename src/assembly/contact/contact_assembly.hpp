#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contact/contact_exceptions.hpp"
#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contact_overlap.hpp"
#include "assembly/contact/contact_pairs.hpp"
#include "assembly/contact/contact_places.hpp"
#include "assembly/contact/contact_work.hpp"
#include "assembly/contact/impulse_direction.hpp"
#include "assembly/contribution.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "constraints/step_differences.hpp"
#include "contact/impact_law.hpp"
#include "contact/obstacle_surface.hpp"
#include "linear/sparse_pattern.hpp"
#include "loads/distributed_load.hpp"
#include "parallel/thread_team.hpp"
#include "state/contact_touch.hpp"
#include "state/memory_slice.hpp"
#include "state/values/obstacle_values.hpp"

namespace gxrod {

// Contact of rods and bodies with obstacles: forces, their tangent, and the largest share of a motion without
// penetration. Each place of a rod or body (ContactPlaces) touches each obstacle by itself. Forces belong to
// State::trial. If State::contact has parameters, the tangents treat the forces as separate unknowns.
class ContactAssembly : public Contribution {
  public:
    // All must outlive it. For small motions contact has no impulses, and its tangents include those of rods
    // that touch each other.
    ContactAssembly(const Model& model,
                    const ThreadTeam& team,
                    const ScaleGroups& groups,
                    bool is_for_small_motions = false);
    void lay_out(const Layout& layout) override;

    // Does resolve_contact(System&).
    void resolve();
    // Whether contact is an impulse of each step.
    bool has_impacts() const { return has_impacts_; }
    // Computes the power of a motion in which contact is not an impulse, at the trial motions.
    ContactPower compute_power(const State& state, double time) const;

    bool empty() const { return (places_.places.empty() || surfaces_.empty()) && pairs_.empty(); }
    // Contact of rods with each other.
    const ContactPairs& pairs() const { return pairs_; }
    // The numbers in State::memory: friction from obstacles at each place, per length, spatial; places of the
    // first obstacle, then of the next. With restitution, then the speed at which each element met each
    // obstacle, 0 where it does not touch, and those of pairs.
    std::size_t memory_count() const override {
        return 3 * traction_count() + numbers_.size() + pairs_.memory_count();
    }
    MemorySlice memory() const { return memory_; }

    // Forces are multiplied by a weight, which the schemes of time choose (Integrator::contact_weight).
    void subtract_forces(const State& state,
                         double time,
                         const ConstraintRequest& request,
                         Residual& residual) const override;
    void add_tangents(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const override;
    // If the state has parameters: replaces the true forces in the residual by the forces that belong to the
    // tangents, with obstacles at their places at `time`.
    void replace_by_tangent_forces(const State& state, double time, double weight, Residual& residual) const;

    // Finds pieces near the trial; before forces are asked for there outside of an equilibrium.
    void search(State& state) const {
        if (!pairs_.empty()) pairs_.search(0.0, state);
    }
    // Starts the parameters for an equilibrium at `time` with values on the law.
    void start(State& state, double time) const;
    // Advances the parameters by the whole increments of a Newton iteration, before nodes move.
    void advance(const std::vector<Vec6>& deltas, double time, State& state) const;
    // Limits displacements and spins of the trial; obstacles move with them to their places at `time`.
    ContactLimits limit(const std::vector<Vec6>& increments,
                        State& state,
                        double time,
                        Approach approach = Approach::increment) const;

    void commit(State& state, double time) const override;

    // Whether anything pushes at the trial motions, also in a step that leaves an obstacle.
    bool has_forces(const State& state, double time) const;
    // Computes the force on each node at the trial motions.
    std::vector<Vec6> compute_forces(const State& state, double time) const;
    // Computes the energy stored between rods and obstacles, sticking friction included.
    double compute_energy(const State& state, double time) const;
    // Computes the work in the step from the last accepted motions to the trial, at `time`; the energy at its
    // start was `energy_before`. For impulses it is exact; in statics, where only friction dissipates, it
    // takes the mean of the forces at both ends.
    ContactWork compute_work(const State& state, double time, double energy_before) const;
    // Computes the values of Contact::obstacles.
    std::vector<ObstacleValues> compute_obstacle_values(const State& state, double time) const;
    // Lists all touches at the trial motions, sorted by rods and places: one for each place at an obstacle,
    // and one for each two elements of rods.
    std::vector<ContactTouch> list_touches(const State& state, double time) const;
    // Computes for each node the least gap of the places next to it, at most its skin; for nodes without
    // rods, the largest skin.
    std::vector<double> compute_gaps(const State& state, double time) const;
    // Computes the values of a watched contact: forces of all touches on a rod and, if wanted, the least gap.
    ObstacleValues compute_watched(const ContactWatch& watch,
                                   const std::vector<ContactTouch>& touches,
                                   const State& state,
                                   double time) const;
    // Lists rods that at the trial motions are in obstacles, beds left out, or in rods, or touch them without
    // a gap; the deepest first, each pair once.
    std::vector<ContactOverlap> list_overlaps(const State& state, double time) const;
    // Describes the deepest overlap; "" if there is none.
    std::string describe_overlap(const State& state, double time) const;
    ContactCount count(const State& state, double time) const;

  private:
    // The places of obstacles now, and at the last accepted step.
    struct At {
        std::vector<ObstaclePlacement> now, before;
        bool has_impacts = false;
        double damping = 0.0;  // factor of the gap's change in the step: 0 without inertia, or at its start
        double elapsed = 0.0;  // since the last accepted step
        bool damps_rates = false;
        // Factor of the gap's rate, where contact is not an impulse, and what gives the rates of obstacles.
        double rate_damping = 0.0;
        std::array<double, difference_points> difference_weights{}, weights_before{};
        std::vector<std::array<ObstaclePlacement, difference_points>> around{};
    };
    // The rate of a gap, its derivative by the place's position, and the factor by which it damps the force.
    struct GapRate {
        double rate = 0.0;
        Vec3 by_position = Vec3::Zero();
        double damping = 0.0;
        double factor = 1.0;
    };
    struct Touching {
        NormalForce normal;
        CoulombFriction friction;
    };
    // The number of places with friction, at all obstacles.
    std::size_t traction_count() const { return rubs_ ? pair_count() : 0; }
    std::size_t pair_count() const { return surfaces_.size() * places_.places.size(); }
    std::size_t pair(std::size_t obstacle, std::size_t place) const {
        return obstacle * places_.places.size() + place;
    }
    enum class Rates { where_damped, always };
    At find_obstacles(const State& state,
                      double time,
                      double progress,
                      Rates rates = Rates::where_damped) const;
    void set_rates_of_obstacles(const State& state, double time, At& at) const;
    // Computes the velocity of an obstacle's surface at a point of it.
    Vec3 surface_velocity(const At& at, std::size_t obstacle, const Vec3& point) const;
    Vec3 surface_velocity(const At& at,
                          std::size_t obstacle,
                          std::size_t place,
                          const SurfaceTouch& touch,
                          const State& state) const;
    GapRate find_gap_rate(const At& at,
                          std::size_t obstacle,
                          std::size_t place,
                          const SurfaceTouch& touch,
                          const State& state) const;
    void find_restitutions();
    bool damps() const { return model_->contact.damping > 0.0 || !numbers_.empty(); }
    MemorySlice speed_memory(std::size_t obstacle, const ContactElement& element) const {
        return {memory_.first + 3 * traction_count() + obstacle * places_.elements.size() +
                    places_.index_of(element),
                1};
    }
    // Returns the speed at which a place approaches an obstacle at the last accepted step.
    double approach_before(const At& at, std::size_t obstacle, std::size_t place, const State& state) const;
    // Returns τ of (C17), of restitution by the speed at which both met.
    double damping_time(const At& at, std::size_t obstacle, std::size_t place, const State& state) const;
    double impulse_damping(const At& at, std::size_t obstacle, std::size_t place, const State& state) const;
    void keep_tractions(const At& at, State& state) const;
    void keep_speeds(const At& at, State& state) const;
    double find_kept_speed(const At& at,
                           std::size_t obstacle,
                           const ContactElement& element,
                           const State& state) const;
    // Multiplies a force by the factor of its gap's rate.
    NormalForce damp_by_rate(const At& at,
                             std::size_t obstacle,
                             std::size_t place,
                             const SurfaceTouch& touch,
                             const State& state,
                             const NormalForce& normal) const;
    // Whether contact between an obstacle's surface and a place is switched off.
    bool is_off(std::size_t surface, std::size_t place) const {
        return !off_.empty() && is_element_off(surface, places_.element_of(place));
    }
    bool is_element_off(std::size_t surface, const ContactElement& element) const {
        return !off_.empty() && off_[surface * places_.elements.size() + places_.index_of(element)] != 0;
    }
    void find_exceptions();
    // Whether contact between an element and an obstacle is switched off, or the element is too far away to
    // touch it within this distance.
    bool is_far(const At& at,
                std::size_t obstacle,
                const ContactElement& element,
                const State& state,
                double reach = 0.0) const;
    bool is_far(const ObstaclePlacement& placement,
                std::size_t obstacle,
                const ContactElement& element,
                const std::vector<NodeMotion>& motions,
                double reach) const;
    // Whether a place has no force from a mesh: it is further away than its skin, and what its parameter
    // expects is no force. Other shapes are measured at once. `is_beyond` looks at distances alone; a reach
    // adds to the skin.
    bool is_idle(const At& at,
                 std::size_t obstacle,
                 std::size_t place,
                 const Vec3& position,
                 const State& state,
                 double reach = 0.0) const;
    bool is_beyond(const At& at,
                   std::size_t obstacle,
                   std::size_t place,
                   const Vec3& position,
                   const State& state,
                   double reach = 0.0) const;
    bool is_beyond_at(const ObstaclePlacement& placement,
                      std::size_t obstacle,
                      std::size_t place,
                      const Vec3& position,
                      double reach) const;
    // Whether a place touches nothing, and its gap is no less than another one.
    bool has_greater_gap(const At& at,
                         std::size_t obstacle,
                         std::size_t place,
                         const Vec3& position,
                         const State& state,
                         double gap) const;
    // Returns what is remembered of a mesh next to a place or element; nullptr of other shapes.
    MeshMemory* memory_of_place(std::size_t surface, std::size_t place) const {
        return place_memories_.empty() ? nullptr : &place_memories_[pair(surface, place)];
    }
    MeshMemory* memory_of_element(std::size_t surface, const ContactElement& element) const {
        return element_memories_.empty()
                   ? nullptr
                   : &element_memories_[surface * places_.elements.size() + places_.index_of(element)];
    }
    void make_memories();
    SurfaceTouch touch(const At& at, std::size_t obstacle, std::size_t place, const Vec3& position) const;
    // Returns the direction of a place's impulse in a step; in statics forces act along the normal at the
    // end.
    ImpulseDirection impulse_direction(const At& at,
                                       std::size_t obstacle,
                                       std::size_t place,
                                       const SurfaceTouch& touch,
                                       const State& state) const;
    ObstacleDistance distance_before(const At& at,
                                     std::size_t obstacle,
                                     std::size_t place,
                                     const State& state) const;
    double gap_before(const At& at, std::size_t obstacle, std::size_t place, const State& state) const;
    CoulombFriction friction(std::size_t obstacle, std::size_t place, const State& state) const;
    // Returns how its coefficient depends on direction and speed; nullptr if it does not.
    const FrictionShape* find_friction_shape(std::size_t obstacle, const ContactElement& element) const;
    // Returns the impact law of the step, for a rigid obstacle.
    ImpactLaw impact_law(const At& at, std::size_t obstacle, std::size_t place, const State& state) const;
    NormalForce law_force(
        const At& at, std::size_t obstacle, std::size_t place, double gap, const State& state) const;
    NormalForce tangent_force(
        const At& at, std::size_t obstacle, std::size_t place, double gap, const State& state) const;
    CoulombFriction tangent_friction(std::size_t obstacle, std::size_t place, const State& state) const;
    Touching touch_by_law(const At& at,
                          std::size_t obstacle,
                          std::size_t place,
                          const SurfaceTouch& touch,
                          const State& state) const;
    Touching touch_by_parameters(const At& at,
                                 std::size_t obstacle,
                                 std::size_t place,
                                 const SurfaceTouch& touch,
                                 const State& state) const;
    template <class Work>
    void for_each_near(const At& at, const State& state, double reach, State& kept, const Work& work) const;
    void list_element_touches(std::size_t element,
                              const At& at,
                              const State& state,
                              std::vector<ContactTouch>& touches) const;
    double find_least_gap(const ContactWatch& watch, const State& state, double time) const;
    void forget_place(std::size_t obstacle, std::size_t place, State& state) const;
    void keep_slip(const CoulombFriction& friction,
                   std::size_t obstacle,
                   std::size_t place,
                   State& state) const;
    void add_pair_tangents(const State& state,
                           double weight,
                           const std::vector<NodeLinearization>& linearizations,
                           std::vector<double>& values) const;
    // Adds what damping by the rate of the gap adds to the tangent of a place: as in add_tangents, for
    // columns of the element's node `column`.
    void add_rate_tangent(const At& at,
                          std::size_t obstacle,
                          std::size_t place,
                          const SurfaceTouch& surface,
                          const State& state,
                          double weight,
                          const std::vector<NodeLinearization>& linearizations,
                          LoadMatrix& tangent) const;
    // Adds to the tangent of a place, multiplied by the weight, what friction by the direction of the rod
    // adds.
    void add_axis_tangent(std::size_t place,
                          const PlaceForceDerivative& there,
                          const State& state,
                          double weight,
                          LoadMatrix& tangent) const;
    Mat6 take_to_node(const At& at,
                      const ContactPlace& place,
                      const State& state,
                      const Vec3& force,
                      Mat6 derivative) const;
    FreeMotion find_bent_free_motion(std::size_t surface,
                                     const ObstaclePlacement& from,
                                     const ObstaclePlacement& to,
                                     std::size_t place,
                                     const Vec6& increment,
                                     double skin,
                                     const State& state) const;
    template <class Find>
    void add_element_force(
        std::size_t element, const At& at, const State& state, const Find& find, LoadVector& force) const;
    template <class Find>
    std::vector<LoadVector> compute_element_forces(const At& at, const State& state, const Find& find) const;

    const Model* model_;
    const ThreadTeam* team_;
    const ScaleGroups* groups_;
    const EquationNumbers* equations_ = nullptr;
    const SparsePattern* pattern_ = nullptr;
    std::vector<ObstacleSurface> surfaces_;
    ContactPlaces places_;
    ContactPairs pairs_;
    // Flags by surface and element; empty without Contact::exceptions at obstacles.
    std::vector<char> off_;
    std::vector<double> coefficients_;
    // τ v of restitution by surface and element, negative without it; empty if nothing has restitution.
    std::vector<double> numbers_;
    std::vector<const FrictionShape*> friction_shapes_;
    MemorySlice memory_;
    // Memories of meshes by surface and place, and by surface and element; empty without meshes. They do not
    // change results.
    mutable std::vector<MeshMemory> place_memories_, element_memories_;
    bool rubs_ = false;
    bool moves_ = false;
    bool has_impacts_ = false;
    bool is_for_small_motions_ = false;
    bool resolves_ = false;  // contact in motions with inertia that is not an impulse
};

}  // namespace gxrod
