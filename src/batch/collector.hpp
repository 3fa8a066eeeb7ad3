#pragma once

#include <limits>
#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/problem.hpp"
#include "results/histories/history_point.hpp"
#include "run/run.hpp"

namespace gxrod {

// Adds to the list whatever the collections name that a case's deck does not have: histories, quantities,
// components, times.
void check_collections(const std::vector<Collection>& collections, const Problem& problem, FaultList& faults);

// What a column holds: "largest z of position of tip".
std::string describe(const Collection& collection);

// A number taken from a function of time that is known at steps, straight between them.
class TakenNumber {
  public:
    TakenNumber(Take take, std::optional<double> at) : take_(take), at_(at) {}

    void add(double time, double value);
    // NaN if no step was added, or none at the time asked for.
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
    double integral_ = 0.0;         // of the value
    double square_integral_ = 0.0;  // of its square
    double at_value_ = std::numeric_limits<double>::quiet_NaN();
};

// Takes the numbers of a plan from a run, step by step.
class Collector {
  public:
    // check_collections has found nothing; plan and problem must outlive the collector.
    Collector(const std::vector<Collection>& collections, const Problem& problem);

    // Each accepted step, t = 0 included.
    void add(const Snapshot& snapshot, const LedgerRow& ledger);
    // What stages have found, once the run has ended.
    void add(const RunSummary& summary);
    // In the order of the collections; NaN for what no step gave, and for what was not found.
    std::vector<double> values() const;

  private:
    struct Column {
        const Collection& collection;
        std::optional<HistoryPoint> point;
        TakenNumber number;
        double found = std::numeric_limits<double>::quiet_NaN();
    };
    std::vector<Column> columns_;
};

}  // namespace gxrod
