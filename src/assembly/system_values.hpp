#pragma once

#include <span>
#include <vector>

#include "assembly/system.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"
#include "state/values/section_values.hpp"
#include "state/values/tendon_values.hpp"

namespace gxrod {

// The values of a system's parts that frames and histories show.
class SystemValues {
  public:
    // The system must outlive it.
    explicit SystemValues(const System& system) : system_(&system) {}

    // Computes values of all rod elements at the trial motions, rods in the order of the model, from start to
    // end.
    std::vector<SectionValues> compute_section_values(const State& state) const;
    // Computes values of all tendons at the trial motions and multipliers, in the order of the model.
    std::vector<TendonValues> compute_tendon_values(const State& state, double time) const;
    // Computes for each rod ∫ δE (C δE) ds, component by component (Γx Γy Γz Kx Ky Kz), where δE are the
    // first-order strain increments for increments (δr, δφ) of the nodes at the trial motions.
    std::vector<Vec6> compute_strain_work(const State& state, const std::vector<Vec6>& increments) const;
    // Computes values of points of rods at the trial motions; section forces belong to an equilibrium at
    // `time`.
    std::vector<PointValues> compute_point_values(const State& state,
                                                  double time,
                                                  const std::vector<RodPlace>& places) const;
    // Computes the surroundings of Model::bodies at the trial motions; empty without surroundings.
    std::vector<PointSurroundings> compute_body_surroundings(const State& state, double time) const;
    // Computes p_i A_i − p_o A_o at the middles of all rod elements at the trial motions, and the force of
    // the ground per length at each node; both are valid until the next call. Empty where the model has no
    // such surroundings.
    std::span<const double> compute_pressure_forces(const State& state, double time) const;
    std::span<const Vec3> compute_bed_forces(const State& state, double time) const;
    // Calls visit(block, instant) for the elements of each kind, with what acts within sections at the trial
    // motions.
    template <class Visit>
    void visit_elements(const State& state, double time, const Visit& visit) const {
        const Instant now = system_->instant(state, time);
        for_each_block(system_->blocks_, [&](const auto& block) { visit(block, now); });
    }

  private:
    // Computes values of places of one element.
    void compute_points_of_element(const State& state,
                                   double time,
                                   std::span<const RodPlace> places,
                                   std::span<PointValues> values) const;

    const System* system_;
};

}  // namespace gxrod
