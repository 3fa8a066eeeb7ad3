#include "batch/collector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "batch/component_row.hpp"
#include "batch/counted_quantity.hpp"
#include "check/findings/found_values.hpp"
#include "deck/schema/suggestion.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

ComponentRow values_of(const LedgerColumn& column, const LedgerRow& row) {
    const std::array<double, 3> numbers = numbers_of(column, row);
    return {{numbers[0], numbers[1], numbers[2]}, column.width()};
}

const HistoryRequest* find_history(const Problem& problem, const std::string& name) {
    const auto& histories = problem.output.histories;
    const auto found = std::find_if(histories.begin(), histories.end(), [&](const HistoryRequest& request) {
        return request.name == name;
    });
    return found == histories.end() ? nullptr : &*found;
}

// The name of a stage as results have it.
std::string name_of(const StagePlan& stage) {
    return stage.name.empty() ? kind_of(stage.analysis) : stage.name;
}

void check_stage(const Collection& collection, const Problem& problem, FaultList& faults) {
    std::vector<std::string> names;
    for (const StagePlan& stage : problem.stages) {
        names.push_back(name_of(stage));
        if (names.back() != collection.stage) continue;
        const std::string kind = kind_of(stage.analysis);
        const auto* eigenvalues = std::get_if<EigenvalueSettings>(&stage.analysis);
        const bool sweeps = eigenvalues != nullptr && eigenvalues->sweep;
        if (has_found_quantity(kind, sweeps, collection.found)) return;
        return faults.add(collection.place,
                          collection.path() + ".found",
                          fmt::format("stage \"{}\" of the deck, of kind {}{}, finds no {}",
                                      collection.stage,
                                      kind,
                                      sweeps ? " with a sweep" : "",
                                      collection.found));
    }
    const std::string hint = did_you_mean(collection.stage, names);
    faults.add(collection.place,
               collection.path() + ".stage",
               fmt::format("the deck has no stage \"{}\"{}",
                           collection.stage,
                           hint.empty() ? "; it has " + quoted_list(names) : hint));
}

void check_history(const Collection& collection, const Problem& problem, FaultList& faults) {
    const HistoryRequest* history = find_history(problem, collection.history);
    if (history == nullptr) {
        std::vector<std::string> names;
        for (const HistoryRequest& request : problem.output.histories) names.push_back(request.name);
        const std::string hint = did_you_mean(collection.history, names);
        const std::string known = names.empty() ? "; it has none" : "; it has " + quoted_list(names);
        return faults.add(
            collection.place,
            collection.path() + ".history",
            fmt::format("the deck has no history \"{}\"{}", collection.history, hint.empty() ? known : hint));
    }
    const auto& quantities = history->quantities;
    const std::string& word = collection.quantity;
    if (std::find(quantities.begin(), quantities.end(), word) == quantities.end()) {
        return faults.add(collection.place,
                          collection.path() + ".quantity",
                          fmt::format("history \"{}\" of the deck does not record {}; it has {}",
                                      collection.history,
                                      word,
                                      plain_list(quantities)));
    }
    const std::string wrong =
        explain_component(collection.component, quantity_of(history->target, word).columns);
    if (!wrong.empty())
        return faults.add(collection.place, collection.path() + ".component", word + " " + wrong);
    if (!collection.fatigue) return;
    const auto [key, message] = find_count_fault(collection, *history);
    if (!message.empty()) faults.add(collection.place, collection.path() + "." + key, message);
}

}  // namespace

void check_collections(const std::vector<Collection>& collections,
                       const Problem& problem,
                       FaultList& faults) {
    for (const Collection& collection : collections) {
        if (!collection.stage.empty()) {
            check_stage(collection, problem, faults);
            continue;
        }
        if (!collection.history.empty()) {
            check_history(collection, problem, faults);
        } else {
            const std::string wrong = explain_component(collection.component, collection.ledger->width());
            if (!wrong.empty()) {
                faults.add(collection.place,
                           collection.path() + ".component",
                           std::string(collection.ledger->name) + " " + wrong);
            }
        }
        const double end = find_axis_end(problem.stages);
        const auto check_time = [&](double time, const char* key) {
            if (time <= end) return;
            faults.add(
                collection.place, collection.path() + key, fmt::format("{} is after the end, {}", time, end));
        };
        if (collection.at) check_time(*collection.at, ".at");
        if (const auto& fatigue = collection.fatigue)
            check_time(fatigue->from, fatigue->curve ? ".damage.from" : ".range.from");
    }
}

namespace {

// "damage of ", as the description of a column begins.
std::string describe_count(const FatigueCount& count) {
    const std::string from = count.from > 0.0 ? fmt::format(" from t = {} on", count.from) : "";
    if (!count.curve)
        return fmt::format("equivalent range{}, slope {}, {} cycles, of ", from, count.slope, count.cycles);
    const SNCurve::Line& line = count.curve->lines.front();
    const std::string curve =
        count.category ? fmt::format("detail category {}", *count.category)
                       : fmt::format("slope {}, {} cycles at {}", line.slope, line.cycles, line.at);
    return fmt::format("damage{}, {}, of ", from, curve);
}

}  // namespace

std::string describe(const Collection& collection) {
    constexpr std::array words{"least", "largest", "mean", "rms of", "final", "largest absolute"};
    if (!collection.stage.empty()) {
        const std::string text =
            fmt::format("{} {} of stage {}", collection.found, collection.number, collection.stage);
        return collection.reference ? fmt::format("{}, distance from {}", text, *collection.reference) : text;
    }
    std::string text =
        collection.at ? "" : fmt::format("{} ", words[static_cast<std::size_t>(collection.take)]);
    if (collection.fatigue) text = describe_count(*collection.fatigue);
    if (collection.component) text += word_of(component_choices, *collection.component) + " of ";
    if (collection.history.empty()) {
        text += std::string(collection.ledger->name);
    } else {
        text += fmt::format("{} of {}", collection.quantity, collection.history);
    }
    if (collection.at) text += fmt::format(" at t = {}", *collection.at);
    return collection.reference ? fmt::format("{}, distance from {}", text, *collection.reference) : text;
}

void TakenNumber::add(double time, double value) {
    if (has_step_) {
        add_interval(time, value);
    } else {
        first_time_ = time;
        if (at_ && time == *at_) at_value_ = value;
    }
    has_step_ = true;
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
    last_time_ = time;
    last_ = value;
}

void TakenNumber::add_interval(double time, double value) {
    const double step = time - last_time_;
    integral_ += 0.5 * step * (last_ + value);
    square_integral_ += step * (last_ * last_ + last_ * value + value * value) / 3.0;
    // The last step can miss the end, and so the requested time, by round-off.
    constexpr double round_off = 1e-12;
    if (!at_ || *at_ <= last_time_ || *at_ > time * (1.0 + round_off)) return;
    at_value_ = *at_ >= time ? value : last_ + (value - last_) * (*at_ - last_time_) / step;
}

double TakenNumber::value() const {
    if (!has_step_) return std::numeric_limits<double>::quiet_NaN();
    if (at_) return at_value_;
    const double span = last_time_ - first_time_;
    switch (take_) {
        case Take::least:
            return least_;
        case Take::largest:
            return largest_;
        case Take::largest_absolute:
            return std::max(std::abs(least_), std::abs(largest_));
        case Take::mean:
            return span > 0.0 ? integral_ / span : last_;
        case Take::rms:
            return span > 0.0 ? std::sqrt(square_integral_ / span) : std::abs(last_);
        case Take::last:
            break;
    }
    return last_;
}

void TakenFatigue::add(double time, double value) {
    if (time < count_->from) return;
    has_step_ = true;
    cycles_.add(value);
}

double TakenFatigue::value() const {
    if (!has_step_ || !cycles_.is_finite()) return std::numeric_limits<double>::quiet_NaN();
    const std::vector<RangeCycle> cycles = cycles_.cycles();
    if (!count_->curve) return compute_equivalent_range(cycles, count_->slope, count_->cycles);
    const double damage = compute_damage(cycles, *count_->curve, count_->ultimate);
    return std::isfinite(damage) ? damage : std::numeric_limits<double>::quiet_NaN();
}

Collector::Collector(const std::vector<Collection>& collections, const Problem& problem) {
    const auto& histories = problem.output.histories;
    for (const Collection& collection : collections) {
        std::optional<HistoryWatch> watch;
        const Quantity* quantity = nullptr;
        if (const HistoryRequest* history = find_history(problem, collection.history)) {
            const auto index = static_cast<std::size_t>(history - histories.data());
            watch.emplace(problem.model, histories, index);
            quantity = &quantity_of(history->target, collection.quantity);
        }
        columns_.push_back({collection, std::move(watch), quantity, {collection.take, collection.at}, {}});
        if (collection.fatigue) columns_.back().fatigue.emplace(*collection.fatigue);
    }
}

void Collector::add(const Snapshot& snapshot, const LedgerRow& ledger) {
    for (Column& column : columns_) {
        const Collection& collection = column.collection;
        if (!collection.stage.empty()) continue;
        const ComponentRow values =
            column.watch
                ? ComponentRow{column.watch->compute(*column.quantity, snapshot), column.quantity->columns}
                : values_of(*collection.ledger, ledger);
        const double value = take_component(values, collection.component);
        if (column.fatigue) column.fatigue->add(snapshot.time, value);
        column.number.add(snapshot.time, value);
    }
}

void Collector::add(const RunSummary& summary) {
    for (Column& column : columns_) {
        const Collection& collection = column.collection;
        std::vector<double> found;
        for (const FoundShapes& shapes : summary.shapes) {
            if (shapes.stage == collection.stage) found = list_found_values(shapes.record, collection.found);
        }
        for (const PathRecord& record : summary.paths) {
            if (record.front().name == collection.stage) found = list_found_values(record, collection.found);
        }
        const auto index = static_cast<std::size_t>(collection.number - 1);
        if (index < found.size()) column.found = found[index];
    }
}

std::vector<double> Collector::values() const {
    std::vector<double> values;
    for (const Column& column : columns_) {
        const std::optional<double>& reference = column.collection.reference;
        const double value = column.fatigue                    ? column.fatigue->value()
                             : column.collection.stage.empty() ? column.number.value()
                                                               : column.found;
        values.push_back(reference ? std::abs(value - *reference) : value);
    }
    return values;
}

}  // namespace gxrod
