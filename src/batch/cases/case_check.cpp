#include "batch/cases/case_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "batch/cases/case_groups.hpp"
#include "batch/collector.hpp"
#include "check/model_examination.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/text/overrides.hpp"
#include "results/results_size.hpp"

namespace gxrod {
namespace {

constexpr std::size_t most_faults = 20;
constexpr long most_faulty_cases = 1000;

// Parameters that the deck does not have: --set would add them, and nothing would use them.
void check_parameters(const CaseContext& context, FaultList& faults) {
    for (const Variation& variation : context.plan.variations) {
        const std::string lack = describe_missing_parameter(variation.key, context.decks.front().tree());
        if (!lack.empty())
            faults.add(variation.place, fmt::format("vary.\"{}\"", variation.key), "the deck has no " + lack);
    }
}

// Where a fault was found: in the deck of a case, or in the model that it makes and what is collected of it.
enum class CheckStage { reading, examining };

// Faults of many cases, each once.
class CaseFaults {
  public:
    explicit CaseFaults(const CaseContext& context) : context_(context) {}

    void add(const DeckError& error, CheckStage stage, long number) {
        ++faulty_cases_;
        for (const DeckFault& fault : error.faults) add(place(fault, number), stage, number);
    }
    bool is_enough() const { return found_.size() >= most_faults || faulty_cases_ >= most_faulty_cases; }

    // `built` are the cases whose decks were right, of those that were examined.
    std::vector<DeckFault> list(long examined, long built) const {
        std::vector<DeckFault> faults;
        for (const Found& found : found_) {
            faults.push_back(found.fault);
            // What all cases have is not the fault of one.
            if (found.cases < (found.stage == CheckStage::reading ? examined : built))
                faults.back().message += describe(found);
        }
        return faults;
    }

  private:
    struct Found {
        DeckFault fault;
        CheckStage stage;
        long first = 0;
        long cases = 1;
    };

    void add(const DeckFault& fault, CheckStage stage, long number) {
        const auto same = std::find_if(found_.begin(), found_.end(), [&](const Found& found) {
            const DeckFault& other = found.fault;
            return other.file == fault.file && other.line == fault.line && other.column == fault.column &&
                   other.key == fault.key &&
                   leave_out_numbers(other.message) == leave_out_numbers(fault.message);
        });
        if (same == found_.end()) {
            found_.push_back({fault, stage, number});
        } else {
            ++same->cases;
        }
    }

    // A fault of an override is one of the plan's key that gave it.
    DeckFault place(const DeckFault& fault, long number) const {
        const std::string mark = "--set ";
        if (!fault.file.starts_with(mark)) return fault;
        const std::string text = fault.file.substr(mark.size());
        for (const Variation& variation : context_.plan.variations) {
            if (!text.starts_with(variation.key + "=")) continue;
            const std::string key = fault.key.empty() ? "" : fault.key + ": ";
            if (context_.plan.combination == Combination::table)
                return place_in_table(variation, key + fault.message, number);
            return {context_.plan.file,
                    variation.place.line,
                    variation.place.column,
                    fmt::format("vary.\"{}\"", variation.key),
                    key + fault.message};
        }
        return fault;
    }

    DeckFault place_in_table(const Variation& variation, const std::string& message, long number) const {
        const Column& column = *variation.column;
        const bool is_unknown = message.starts_with("unknown key");
        const std::string hint = fmt::format(
            "; name the column after a key, or give it to one: [vary] \"parameters.{0}\" = {{ column = "
            "\"{0}\" }}",
            column.name);
        const auto row = static_cast<std::size_t>(number - 1);
        const int line = is_unknown ? column.header_line : column.lines[row];
        return {fmt::format("{}:{}", context_.plan.table.string(), line),
                0,
                0,
                "",
                fmt::format("column \"{}\": {}{}",
                            column.name,
                            is_unknown && column.name == variation.key ? "no key of the deck" : message,
                            is_unknown && column.name == variation.key ? hint : "")};
    }

    std::string describe(const Found& found) const {
        const std::string others = found.cases > 1 ? fmt::format(" and {} more", found.cases - 1) : "";
        return fmt::format(" [case {}{}: {}]", found.first, others, context_.cases.describe(found.first));
    }

    const CaseContext& context_;
    std::vector<Found> found_;
    long faulty_cases_ = 0;
};

void examine(const CaseContext& context, const Problem& problem, long number) {
    std::vector<DeckFault> faults;
    for (const Finding& finding : examine_stages(problem.model, problem.stages)) {
        if (finding.severity != Severity::error) continue;
        faults.push_back({context.decks[context.cases.deck(number)].file(), 0, 0, "", finding.message});
    }
    if (!faults.empty()) throw DeckError(std::move(faults));
    FaultList missing(context.plan.file, {});
    check_collections(context.plan.collections, problem, missing);
    missing.throw_if_any();
}

void add_size(const Problem& problem, KeptResults& kept) {
    const ResultsSize size = estimate_results_size(problem.model, problem.stages, problem.output);
    kept.bytes += size.bytes;
    kept.frames += size.frames;
    if (size.steps == 0.0) ++kept.unknown;
}

// What is collected, of the deck as it is: where no case could be built, so that the user need not
// correct the cases first to see it.
void check_deck_itself(const CaseContext& context, FaultList& faults) {
    try {
        check_collections(context.plan.collections, context.decks.front().build({}), faults);
    } catch (const DeckError&) {
        // Cases have these faults, too.
    }
}

}  // namespace

CheckedCases check_cases(const CaseContext& context,
                         const CaseRange& range,
                         const std::function<void(long)>& report) {
    FaultList faults(context.plan.file, {});
    if (context.plan.combination != Combination::decks) check_parameters(context, faults);
    CaseFaults case_faults(context);
    CheckedCases checked;
    checked.meshes.resize(context.decks.size());
    long examined = 0;
    long built = 0;
    const auto check = [&](long number) {
        CheckStage stage = CheckStage::reading;
        try {
            const Problem problem = context.build(number);
            ++built;
            stage = CheckStage::examining;
            if (number == 1) checked.title = problem.record.title;
            checked.meshes[context.cases.deck(number)].merge(digest_meshes(problem.record.meshes));
            examine(context, problem, number);
            if (range.contains(number)) add_size(problem, checked.kept);
        } catch (const DeckError& error) {
            case_faults.add(error, stage, number);
        }
        ++examined;
    };
    if (range.first > 1) check(1);
    for (long number = range.first; number <= range.last && !case_faults.is_enough(); ++number) {
        check(number);
        report(number - range.first + 1);
    }
    if (built == 0 && context.plan.combination != Combination::decks) check_deck_itself(context, faults);
    std::vector<DeckFault> all = faults.list();
    const std::vector<DeckFault> of_cases = case_faults.list(examined, built);
    all.insert(all.end(), of_cases.begin(), of_cases.end());
    if (!all.empty()) throw DeckError(std::move(all));
    return checked;
}

}  // namespace gxrod
