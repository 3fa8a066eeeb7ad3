#pragma once

#include "model/settings/settings.hpp"
#include "solvers/steps/step_sequence.hpp"

namespace gxrod {

// Steps along a path, whose time is the arc length. The next step is longer or shorter if the last one took
// few or many iterations. The path itself decides on ends other than by its arc or steps.
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

    // Sets the first step, if the settings leave it open.
    void start(double step);
    // Returns whether many last steps were all short compared with the longest one. A path that ends only by
    // its number of steps may take them.
    bool is_crawling() const;
    // Return whether the next step cannot be cut, and whether it is so short, compared with the first try,
    // that a cut would show nothing new within it.
    bool is_shortest() const { return planned_ <= 2.0 * settings_.min_step; }
    bool is_short() const { return is_shortest() || planned_ <= first_tried_ / 60.0; }
    // Makes the trial end there, where a frame is due. The step after it is as long as it would have been.
    void end_at(double step);
    // Notes the iterations of a step before it is accepted.
    void adapt(int iterations) { iterations_ = iterations; }
    void finish() { is_finished_ = true; }
    // Notes the part of the path, 0 … 1, that is done by criteria other than its steps.
    void note_part(double part) { part_ = part; }

  private:
    // Plans the next step within the rest of the path.
    void plan(double step);

    PathSettings settings_;
    double arc_ = 0.0;
    double step_ = 0.0;
    double planned_ = 0.0;
    double first_tried_ = 0.0;  // since the last accepted step
    double longest_ = 0.0;      // longest accepted step
    long short_steps_ = 0;      // number of last accepted steps that were short compared with it
    int iterations_ = 0;
    std::int64_t accepted_ = 0;
    bool is_marked_ = true;  // whether the accepted point was requested
    bool is_cut_ = false;    // whether the trial was cut
    bool has_failed_ = false;
    bool is_finished_ = false;
    double part_ = 0.0;
};

}  // namespace gxrod
