#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "analyses/stepped_analysis.hpp"
#include "sensitivity/forward_sensitivity.hpp"
#include "sensitivity/side_inputs.hpp"

namespace gxrod {

// The derivatives of an analysis in steps by several numbers, carried along from step to step.
class Sensitivities {
  public:
    // Throws std::invalid_argument if the steps of the analysis cannot be differentiated: along a path, or in
    // steady rotation. The analysis and the models must outlive it.
    Sensitivities(const SteppedAnalysis& analysis,
                  const AnalysisSettings& settings,
                  const std::vector<VariedModels>& models);
    ~Sensitivities();

    // Continues with another analysis of the same model and settings, which takes the place of the first.
    void follow(const SteppedAnalysis& analysis);

    // Sets what acts on the varied systems in the steps to come, and must outlive this; nullptr: nothing.
    void set_inputs(SideInputs* inputs) { inputs_ = inputs; }

    void start();
    // Starts a stage that follows another one, whose derivatives were carried along to its end.
    void start_after(const Sensitivities& earlier);
    // Call these before each step, and after it has been accepted.
    void note_before() { before_ = analysis_->state(); }
    void advance();

    std::size_t count() const { return all_.size(); }
    const ForwardSensitivity& by(std::size_t number) const { return all_[number]; }
    ForwardSensitivity& by(std::size_t number) { return all_[number]; }
    // How the analysis starts, and the scheme of its steps.
    StartOfAnalysis find_start() const;
    const Integrator& integrator() const { return *integrator_; }

    // The derivatives at an accepted state, to return to that state.
    struct Record {
        std::vector<ForwardSensitivity::Record> all;
        Pieces pieces;
        std::vector<double> inputs;  // SideInputs::record
        std::size_t stage = 0;       // of the deck
    };
    Record record() const;
    void recall(const Record& record);

    // Throws std::invalid_argument, as the constructor, if steps by these settings cannot be differentiated.
    static void check_settings(const AnalysisSettings& settings);
    // Throws std::invalid_argument, as the constructor, if steps of this model cannot be differentiated.
    static void check_model(const Model& model);

  private:
    // Whether there is no derivative by any number anymore.
    bool have_ended() const;
    void take_step();
    // Takes the last step of the analysis on all sides, until their inputs fit.
    void take_sides();
    // Ends derivatives where other ropes and stops hold on a side at the start of a motion.
    void check_stops();
    // Carries the derivatives along while the analysis settles from this accepted state.
    void settle(const State& before);
    // Moves the varied systems to the states next to this one, lets `take` advance them, and takes over the
    // states that they reach.
    template <class Take>
    void carry(const State& before, const Take& take);

    const SteppedAnalysis* analysis_;
    SideInputs* inputs_ = nullptr;
    std::unique_ptr<Integrator> integrator_;
    std::unique_ptr<TangentLinearStep> step_;
    std::deque<ForwardSensitivity> all_;
    bool projects_start_ = false;
    bool has_time_ = false;  // whether it is not static
    LinearSolverKind linear_solver_ = LinearSolverKind::automatic;
    State before_;
    Pieces pieces_;  // pieces at the end of the last step
};

}  // namespace gxrod
