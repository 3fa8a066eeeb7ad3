#pragma once

#include "model/settings/settings.hpp"
#include "solvers/steps/step_sequence.hpp"

namespace gxrod {

// Steps along a path, whose time is the arc length. The next one is longer or shorter as the last one took
// few or many iterations; what ends the path in other ways than by its arc or steps is for the path to say.
class PathSequence : public StepSequence {
  public:
    explicit PathSequence(const PathSettings& settings);

    double time() const override { return arc_; }
    double next_time() const override { return arc_ + step_; }
    double time_step() const override { return step_; }
    bool finished() const override { return is_finished_; }
    void accept() override;
    bool reject() override;

    long steps_done() const override { return static_cast<long>(accepted_); }
    long steps_in_all() const override { return settings_.steps.value_or(0); }
    double part_done() const override;
    bool is_frame_due(long every) const override { return is_marked_ || accepted_ % every == 0; }

    StepMemory memory() const override;
    bool resume(const StepMemory& memory) override;

    // The first step, where the settings leave it open.
    void start(double step);
    // Whether the last steps, many of them, were all short compared with the longest one. A path that ends by
    // its number of steps alone may take them.
    bool is_crawling() const;
    // Whether the next step cannot be cut; and whether that is no use to find out what happens within it, for
    // it is short compared with what was tried first.
    bool is_shortest() const { return planned_ <= 2.0 * settings_.min_step; }
    bool is_short() const { return is_shortest() || planned_ <= first_tried_ / 60.0; }
    // The trial ends there instead; a frame is due there. The step after it is as long as if it had not.
    void end_at(double step);
    // What the step took, before it is accepted.
    void adapt(int iterations) { iterations_ = iterations; }
    void finish() { is_finished_ = true; }
    // How much of the path is done by what the steps do not know, 0 … 1.
    void note_part(double part) { part_ = part; }

  private:
    // Within what is left.
    void plan(double step);

    PathSettings settings_;
    double arc_ = 0.0;
    double step_ = 0.0;
    double planned_ = 0.0;
    double first_tried_ = 0.0;  // since the last accepted step
    double longest_ = 0.0;      // of the accepted steps
    long short_steps_ = 0;      // the last accepted ones that were short compared with it
    int iterations_ = 0;
    std::int64_t accepted_ = 0;
    bool is_marked_ = true;  // whether the accepted point was asked for
    bool is_cut_ = false;    // the trial
    bool has_failed_ = false;
    bool is_finished_ = false;
    double part_ = 0.0;
};

}  // namespace gxrod
