#pragma once

#include <vector>

#include "analyses/contact_record.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// The last accepted step as it was before it was committed, to see the model at times between its ends.
// Motions are those of the scheme's interpolant. Forces and strains of sections, reactions and multipliers
// are not those of these motions, whose errors a stiff section would multiply: they are interpolated between
// those at the start, the stages and the end of the step (docs/theory/newmark.md, (D3)).
class StepInterior {
  public:
    // These must outlive it.
    StepInterior(const System& system, const Integrator& integrator);

    // Of the trial that is accepted, at `end_time`; whether the state has settled at the step's start, so
    // that it has no rates there.
    void keep(const State& state, double end_time, bool is_settled = false);
    // At a time between; valid until the next call. With the sections of all elements only if asked for.
    Snapshot snapshot(double time,
                      bool with_elements,
                      const std::vector<RodPlace>& watched,
                      const std::vector<ContactWatch>& watched_contacts = {});

  private:
    // Values at one of the places between which they are interpolated; found when they are asked for.
    struct Place {
        std::vector<SectionValues> sections;
        std::vector<PointValues> points;
        std::vector<Vec6> reactions;
        bool has_sections = false, has_others = false;
    };

    void find_first_rates();
    // Of the places' values.
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
    std::vector<double> fractions_;  // 0, of the stages, 1
    State state_;                    // the step
    double end_time_ = 0.0;
    // A quasi-static stage starts without rates, and so not in equilibrium: its first step has the forces at
    // its end.
    bool starts_at_rest_ = false;
    std::vector<Place> places_;
    // Of the end of the step: contact is an impulse of it.
    ContactRecord contact_record_;
    bool has_contacts_ = false, has_frame_contacts_ = false;

    State between_;  // the same, with the trial at the time asked for
    std::vector<SectionValues> sections_;
    std::vector<PointValues> points_;
    std::vector<Vec6> reactions_;
    std::vector<PointSurroundings> bodies_;
    std::vector<JointValues> joints_;
    std::vector<TendonValues> tendons_;
};

}  // namespace gxrod
