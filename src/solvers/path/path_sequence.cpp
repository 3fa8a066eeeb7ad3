#include "solvers/path/path_sequence.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// Of a step of so many iterations, how much longer the next one is.
double compute_growth(int iterations) {
    constexpr double goal = 4.0;
    constexpr double exponent = 0.7;
    return std::clamp(std::pow(goal / std::max(iterations, 1), exponent), 0.5, 2.0);
}

// Of the longest step, below which one is short; and how many in a row make a path crawl. Together they are
// not as long as a fifth of the longest.
constexpr double short_part = 1e-3;
constexpr long most_short_steps = 200;

}  // namespace

PathSequence::PathSequence(const PathSettings& settings) : settings_(settings) {
    plan(settings.first_step.value_or(settings.max_step));
}

void PathSequence::start(double step) {
    plan(settings_.first_step.value_or(step));
    first_tried_ = planned_;
}

void PathSequence::plan(double step) {
    planned_ = std::clamp(step, settings_.min_step, settings_.max_step);
    step_ = planned_;
    if (!settings_.arc) return;
    const double rest = *settings_.arc - arc_;
    // No sliver is left for a step of its own.
    if (step_ > rest * (1.0 - 1e-6)) step_ = rest;
}

void PathSequence::end_at(double step) {
    step_ = step;
    is_cut_ = true;
}

bool PathSequence::is_crawling() const {
    const bool has_other_end = settings_.least_load || settings_.greatest_load || settings_.arc ||
                               settings_.points || (settings_.control && settings_.control->to);
    return (!settings_.steps || has_other_end) && short_steps_ >= most_short_steps;
}

void PathSequence::accept() {
    longest_ = std::max(longest_, step_);
    // Steps that end at what was asked for are as short as that has it.
    if (!is_cut_) short_steps_ = step_ < short_part * longest_ ? short_steps_ + 1 : 0;
    const bool is_end = settings_.arc && !is_cut_ && arc_ + step_ >= *settings_.arc;
    arc_ = is_end ? *settings_.arc : arc_ + step_;
    ++accepted_;
    is_marked_ = is_cut_;
    is_cut_ = false;
    if (is_end || (settings_.steps && accepted_ >= *settings_.steps)) is_finished_ = true;
    plan(planned_ * compute_growth(iterations_));
    first_tried_ = planned_;
}

bool PathSequence::reject() {
    is_cut_ = false;
    has_failed_ = step_ <= settings_.min_step || is_crawling();
    if (!has_failed_) plan(0.5 * step_);
    return !has_failed_;
}

double PathSequence::part_done() const {
    const double of_steps =
        settings_.steps ? static_cast<double>(accepted_) / static_cast<double>(*settings_.steps) : 0.0;
    const double of_arc = settings_.arc ? arc_ / *settings_.arc : 0.0;
    return is_finished_ ? 1.0 : std::min(1.0, std::max({of_steps, of_arc, part_}));
}

StepMemory PathSequence::memory() const {
    StepMemory memory;
    memory.has_failed = has_failed_;
    memory.time = arc_;
    memory.step = planned_;
    memory.accepted = accepted_;
    return memory;
}

bool PathSequence::resume(const StepMemory& memory) {
    if (settings_.arc && memory.time > *settings_.arc) return false;
    arc_ = memory.time;
    accepted_ = memory.accepted;
    is_finished_ =
        (settings_.arc && arc_ >= *settings_.arc) || (settings_.steps && accepted_ >= *settings_.steps);
    plan(memory.has_failed ? settings_.max_step : memory.step);
    first_tried_ = planned_;
    return true;
}

}  // namespace gxrod
