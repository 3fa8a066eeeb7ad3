#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "model/time/time_function.hpp"

namespace gxrod {

// The course of an input from one value to the next.
enum class InputHold {
    step,   // a jump: constant over the steps that follow
    linear  // a straight line over the steps until the next value is due
};

// The value of an input that was set; part of the data for resuming a run.
struct InputState {
    double is_set = 0.0;   // 1; otherwise the deck's value applies
    double planned = 0.0;  // the deck's value at t = 0, which detects a changed deck
    // A change from one value to another between two times of the present stage.
    double from_time = 0.0, from = 0.0;
    double to_time = 0.0, to = 0.0;
};

// A number that the driver of a run changes while it runs, [input.NAME]: a function of time whose course is
// not known beforehand. Expressions of a deck read it wherever they can use t. Each problem built from a deck
// has its own inputs, so each simulation has.
class Input {
  public:
    explicit Input(std::string name) : name_(std::move(name)) {}

    const std::string& name() const { return name_; }
    InputHold hold() const { return hold_; }
    // The place of a signal among the signals, each after those that it reads; −1 of any other input. The run
    // itself sets signals, by what it measures.
    int signal_rank() const { return signal_rank_; }
    bool is_signal() const { return signal_rank_ >= 0; }
    void make_signal(int rank) { signal_rank_ = rank; }
    // Sets the deck's value, which applies until the input is set.
    void plan(TimeFunction value, InputHold hold) {
        planned_ = std::move(value);
        hold_ = hold;
    }

    double operator()(double time) const {
        if (state_.is_set == 0.0) return planned_(time);
        if (time >= state_.to_time) return state_.to;
        if (time <= state_.from_time) return state_.from;
        const double part = (time - state_.from_time) / (state_.to_time - state_.from_time);
        return state_.from + part * (state_.to - state_.from);
    }

    // Sets the value at this time of the stage; a linear change reaches it at `until`.
    void set(double value, double time, double until) {
        const double from = hold_ == InputHold::linear ? (*this)(time) : value;
        state_ = {1.0, planned_(0.0), time, from, std::max(time, until), value};
    }
    // Sets its course within a step, a straight line, and returns where that ends.
    void lead(double time, double from, double until, double to) {
        state_ = {1.0, planned_(0.0), time, from, until, to};
    }
    double end() const { return state_.to; }
    // Restarts at t = 0 of the next stage.
    void begin_stage() {
        if (state_.is_set != 0.0) state_ = {1.0, state_.planned, 0.0, state_.to, 0.0, state_.to};
    }

    InputState state() const {
        InputState state = state_;
        state.planned = planned_(0.0);
        return state;
    }
    // Restores a state, unless the deck's value has changed since; then the deck's value applies.
    void recall(const InputState& state) {
        state_ = {};
        if (state.planned == planned_(0.0)) state_ = state;
    }

  private:
    std::string name_;
    TimeFunction planned_;
    InputHold hold_ = InputHold::step;
    InputState state_;
    int signal_rank_ = -1;
};

}  // namespace gxrod
