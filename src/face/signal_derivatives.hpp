#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "face/variation.hpp"
#include "run/signal_value.hpp"
#include "run/stepped_run.hpp"
#include "sensitivity/sensitivities.hpp"

namespace gxrod {

// The derivatives of the signals of a run: each side has signals of its own, which measure its own motions
// (docs/theory/sensitivities.md, (G23) to (G25)).
class SignalDerivatives final : public SideInputs {
  public:
    // The run and the variations must outlive it. Throws std::invalid_argument if a signal measures what has
    // no derivative.
    SignalDerivatives(const SteppedRun& run, const std::vector<VariedNumber>& variations);

    // Takes over the derivatives whose sides it sets and measures.
    void follow(Sensitivities& carried);
    // Measures the start of the first stage.
    void start() { measure(); }
    // Restarts at t = 0 of the next stage, before its derivatives start.
    void begin_stage();
    // Must be called before each step.
    void note_before();

    void act() override;
    bool follow() override;
    std::vector<double> record() const override;
    void recall(const std::vector<double>& record) override;

  private:
    // Derivatives of what a signal keeps: of SignalState, and of both ends of its course.
    struct Rates {
        double measured = 0.0, filtered = 0.0, integral = 0.0, from = 0.0, to = 0.0;
    };
    using RatesOfSides = std::array<std::vector<Rates>, 4>;  // the numbers themselves, not derivatives
    // The trials of a step by one number: ends of continuous courses, and what signals were there.
    struct Trials {
        std::vector<std::vector<double>> ends, found;
        bool is_done = false;
    };
    struct Base {
        SignalTimes times;
        std::vector<SignalState> states;
        std::vector<InputState> inputs;
    };

    Base note_base() const;
    // Whether the run has set this signal for its last step.
    bool has_acted(std::size_t signal) const;
    bool has_continuous() const;
    static SignalState move(const SignalState& state, const Rates& rates, double amount);
    // Sets the inputs of a side along the derivative from these of the run.
    void place(std::size_t number, std::size_t side, const std::vector<InputState>& inputs) const;
    void place_all(const std::vector<InputState>& inputs) const;
    void measure();
    // Computes the signals of a side for the step.
    std::vector<Rates> act_on(std::size_t number, std::size_t side, const Base& after);
    // Computes the continuous signals at the end of the step; others are 0.
    std::vector<double> find_ends(std::size_t number, std::size_t side, const Base& after) const;
    bool follow_number(std::size_t number, const Base& after);
    // Extrapolates differences of the four sides.
    double differentiate(std::size_t number, const std::array<double, 4>& values) const;
    // Ends the derivative where these values of a signal have a kink next to the run's own.
    void check_smoothness(std::size_t number,
                          std::size_t signal,
                          const std::array<double, 4>& values,
                          double centre);

    const SteppedRun& run_;
    const std::vector<VariedNumber>& variations_;
    Sensitivities* carried_ = nullptr;
    std::vector<const SignalPlan*> plans_;
    std::vector<std::vector<std::array<const SignalPlan*, 4>>> varied_;  // by number and signal
    std::vector<std::size_t> quantities_;                                // in their histories
    std::vector<std::vector<Rates>> rates_;                              // by number and signal
    Base before_;
    // On which the run was at the start of its step, and at its end.
    std::vector<std::optional<SignalPiece>> pieces_, end_pieces_;
    std::vector<double> ends_;  // of its continuous signals at its end, which their courses meet nearly
    std::vector<Trials> trials_;
};

}  // namespace gxrod
