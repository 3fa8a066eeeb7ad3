#include <cmath>

#include "deck/problem.hpp"
#include "deck/reading/validation.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/text/overrides.hpp"
#include "deck/text/toml_writing.hpp"
#include "fuzz/expectation.hpp"
#include "fuzz/inputs.hpp"
#include "machine/file_error.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod::fuzz {
namespace {

const std::string file = "deck.toml";

// The values of "#set KEY=VALUE" lines.
std::vector<std::string> overrides_of(std::string_view text) {
    constexpr std::string_view mark = "#set ";
    constexpr std::size_t most = 8;
    std::vector<std::string> overrides;
    while (!text.empty() && overrides.size() < most) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(mark)) overrides.emplace_back(line.substr(mark.size()));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return overrides;
}

// Elements that the deck asks for, as far as it is a deck. Large models are right and slow.
long count_elements(std::string_view text, const std::vector<std::string>& overrides) {
    long count = 0;
    try {
        DeckNode tree = read_toml(text, file);
        FaultList faults(file, overrides);
        apply_overrides(overrides, tree, faults);
        const CheckedTable deck = check_deck(tree, faults);
        faults.throw_if_any();
        for (const RodTable& rod : rods_of(deck)) count += rod.elements.value_or(0);
    } catch (const DeckError&) {
        return 0;
    }
    return count;
}

// A deck that is accepted is also accepted as it is kept in a results file, and makes the same model.
void check_again(const Problem& problem, const std::string& text) {
    Problem again;
    try {
        again = read_problem_text(text, file);
    } catch (const DeckError& error) {
        throw BrokenPromise("written again, the deck is refused: " + std::string(error.what()) + "\n" + text);
    }
    expect(again.model.nodes.size() == problem.model.nodes.size(), "written again, the deck has other nodes");
    expect(again.model.loads.size() == problem.model.loads.size(), "written again, the deck has other loads");
    for (std::size_t i = 0; i < problem.model.nodes.size(); ++i) {
        expect(again.model.nodes[i].position == problem.model.nodes[i].position,
               "written again, the deck has nodes elsewhere");
    }
}

// What loads and moves are at a few times is finite, or an EvaluationError.
void evaluate(const Model& model) {
    for (const double time : {0.0, 0.3, 1.0, 1e9}) {
        const auto check = [&](const TimeFunction& function) {
            try {
                expect(std::isfinite(function(time)), "a function is not finite");
            } catch (const EvaluationError&) {
                return;
            }
        };
        for (const NodalLoad& load : model.loads) {
            for (const TimeFunction& component : load.force) check(component);
            for (const TimeFunction& component : load.moment) check(component);
        }
        for (const Support& support : model.supports) {
            for (const TimeFunction& component : support.motion) check(component);
        }
    }
}

void check_model(const Model& model) {
    for (const Node& node : model.nodes) {
        expect(node.position.allFinite(), "the node " + node.name + " is nowhere");
        expect(node.velocity.allFinite(), "the node " + node.name + " has no velocity");
    }
    for (const Rod& rod : model.rods) {
        for (const Quat& axes : rod.triads) {
            expect(std::abs(axes.norm() - 1.0) < 1e-9,
                   "the rod " + rod.name + " has axes that are no rotation");
        }
    }
}

void check_message(const DeckError& error) {
    expect(!error.faults.empty(), "a deck is refused without a reason");
    for (const DeckFault& fault : error.faults) {
        expect(!fault.message.empty(), "a fault without a message");
        expect(fault.line >= 0 && fault.column >= 0, "a fault is nowhere: " + describe(fault));
    }
}

}  // namespace

void try_deck(std::string_view input) {
    constexpr long most_elements = 1000;
    Problem problem;
    const std::vector<std::string> overrides = overrides_of(input);
    if (count_elements(input, overrides) > most_elements) return;
    try {
        problem = read_problem_text(input, file, overrides);
    } catch (const DeckError& error) {
        return check_message(error);
    } catch (const FileError&) {
        return;
    }
    check_model(problem.model);
    evaluate(problem.model);
    check_again(problem, problem.record.text);
    if (overrides.empty()) check_again(problem, write_toml(read_toml(input, file)));
}

}  // namespace gxrod::fuzz
