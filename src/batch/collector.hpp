#pragma once

#include <limits>
#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/problem.hpp"
#include "run/run.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// Adds a fault for everything in the collections that a case's deck does not have: histories, quantities,
// components, times.
void check_collections(const std::vector<Collection>& collections, const Problem& problem, FaultList& faults);

// Describes a column: "largest z of position of tip".
std::string describe(const Collection& collection);

// Takes a number from a function of time that is known at steps and linear between them.
class TakenNumber {
  public:
    TakenNumber(Take take, std::optional<double> at) : take_(take), at_(at) {}

    void add(double time, double value);
    // Returns the number; NaN if no step was added, or none at the requested time.
    double value() const;

  private:
    void add_interval(double time, double value);

    Take take_;
    std::optional<double> at_;
    bool has_step_ = false;
    double first_time_ = 0.0;
    double last_time_ = 0.0;
    double last_ = 0.0;
    double least_ = std::numeric_limits<double>::infinity();
    double largest_ = -std::numeric_limits<double>::infinity();
    double integral_ = 0.0;         // ∫ of the value
    double square_integral_ = 0.0;  // ∫ of its square
    double at_value_ = std::numeric_limits<double>::quiet_NaN();
};

// Counts the cycles of a function of time that is known at steps.
class TakenFatigue {
  public:
    explicit TakenFatigue(const FatigueCount& count) : count_(&count) {}

    void add(double time, double value);
    // Returns the damage or the equivalent range; NaN if no step was added, if a value was not finite, or if
    // a mean reaches the ultimate stress.
    double value() const;

  private:
    const FatigueCount* count_;
    bool has_step_ = false;
    RainflowCounter cycles_;
};

// Collects the numbers of a plan from a run, step by step.
class Collector {
  public:
    // Call it if check_collections has found no fault. Plan and problem must outlive the collector.
    Collector(const std::vector<Collection>& collections, const Problem& problem);

    // Adds an accepted state, t = 0 included.
    void add(const Snapshot& snapshot, const LedgerRow& ledger);
    // Adds the results of stages, once the run has ended.
    void add(const RunSummary& summary);
    // Returns the numbers in the order of the collections; NaN if no step gave one, or a stage did not find
    // it.
    std::vector<double> values() const;

  private:
    struct Column {
        const Collection& collection;
        std::optional<HistoryWatch> watch;
        const Quantity* quantity;  // of the history
        TakenNumber number;
        std::optional<TakenFatigue> fatigue;
        double found = std::numeric_limits<double>::quiet_NaN();
    };
    std::vector<Column> columns_;
};

}  // namespace gxrod
