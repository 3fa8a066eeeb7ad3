#pragma once

#include <optional>
#include <string>

#include "batch/plan/plan_words.hpp"
#include "deck/table/kinds.hpp"

// The tables of a plan.
namespace gxrod {

// A range of equally likely values.
struct UniformTable : TableHead {
    std::optional<double> from, to;
};

// A normal distribution, of values or of their logarithms.
struct NormalTable : UniformTable {
    double mean = 0.0;
    double deviation = 0.0;
};

// An entry of [vary] that is not a list of values.
struct VariationTable : TableHead {
    std::optional<double> from, to;
    std::optional<long> count;
    std::optional<Spacing> spacing;
    std::optional<UniformTable> uniform;
    std::optional<NormalTable> normal, lognormal;
    std::optional<std::string> column;
};

// The damage that cycles of a stress do.
struct DamageTable : TableHead {
    std::optional<double> detail;
    std::optional<double> slope, cycles, at, second_slope;
    std::optional<double> limit;
    double factor = 1.0;
    std::optional<double> ultimate;
    double from = 0.0;
};

// The range of equal cycles that do the same damage.
struct EquivalentTable : TableHead {
    double slope = 0.0;
    double cycles = 0.0;
    double from = 0.0;
};

struct CollectTable : TableHead {
    std::optional<std::string> history;
    std::optional<ChosenWord> quantity, ledger;
    std::optional<std::string> stage;
    std::optional<ChosenWord> found;
    long number = 1;
    std::optional<Component> component;
    std::optional<Take> take;
    std::optional<double> at;
    std::optional<DamageTable> damage;
    std::optional<EquivalentTable> range;
    std::optional<double> reference;
};

struct KeepTable : TableHead {
    Keeping results = Keeping::all;
};

struct PlanTable : TableHead {
    std::optional<std::string> deck;
    Combination combine = Combination::grid;
    std::optional<long> count;
    long seed = 1;
    std::optional<std::string> table;
    std::optional<double> time_limit;
    std::optional<double> memory_limit;
    std::optional<KeepTable> keep;
};

}  // namespace gxrod
