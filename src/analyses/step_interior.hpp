#pragma once

#include <vector>

#include "analyses/contact_record.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Keeps the last accepted step as it was before it was committed, to show the model at times between its
// ends. Motions come from the scheme's interpolant. Forces and strains of sections, reactions and multipliers
// are interpolated between their values at the start, the stages and the end of the step; computed from the
// interpolated motions, they would have errors that a stiff section multiplies (docs/theory/newmark.md,
// (D3)).
class StepInterior {
  public:
    // The system and the integrator must outlive this.
    StepInterior(const System& system, const Integrator& integrator);

    // Keeps the accepted trial, which ends at `end_time`. `is_settled`: the state has settled at the start of
    // the step, so it has no rates there.
    void keep(const State& state, double end_time, bool is_settled = false);
    // Returns the snapshot at a time in between; valid until the next call. Sections of all elements are
    // included only if asked for.
    Snapshot snapshot(double time,
                      bool with_elements,
                      const std::vector<RodPlace>& watched,
                      const std::vector<ContactWatch>& watched_contacts = {});

  private:
    // Values at one of the places between which they are interpolated; computed on demand.
    struct Place {
        std::vector<SectionValues> sections;
        std::vector<PointValues> points;
        std::vector<Vec6> reactions;
        bool has_sections = false, has_others = false;
    };

    void find_first_rates();
    // Returns the weights of the places' values.
    std::vector<double> weights_at(double fraction) const;
    State state_at(std::size_t place) const;
    void find_contacts(bool is_for_frame, const std::vector<ContactWatch>& watched);
    void find_values(bool with_elements, const std::vector<RodPlace>& watched);
    void mix_joints(const std::vector<double>& weights);
    void mix_sections(const std::vector<double>& weights);
    void mix_points(const std::vector<double>& weights);
    void mix_reactions(const std::vector<double>& weights);

    const System& system_;
    const Integrator& integrator_;
    std::vector<double> fractions_;  // 0, those of the stages, 1
    State state_;                    // the trial is the end of the step
    double end_time_ = 0.0;
    // A quasi-static stage starts without rates, and so not in equilibrium: its first step uses the forces at
    // its end.
    bool starts_at_rest_ = false;
    std::vector<Place> places_;
    // The contact at the end of the step: contact acts as an impulse over the whole step.
    ContactRecord contact_record_;
    bool has_contacts_ = false, has_frame_contacts_ = false;

    State between_;  // the same state, with the trial at the requested time
    std::vector<SectionValues> sections_;
    std::vector<PointValues> points_;
    std::vector<Vec6> reactions_;
    std::vector<PointSurroundings> bodies_;
    TieValues ties_;
    std::vector<JointValues> joints_;
    std::vector<TendonValues> tendons_;
};

}  // namespace gxrod
