#include <algorithm>

#include "batch/cases/case_list.hpp"
#include "batch/plan/plan.hpp"
#include "deck/text/fault.hpp"
#include "fuzz/expectation.hpp"
#include "fuzz/inputs.hpp"
#include "fuzz/scratch_folder.hpp"
#include "machine/file_error.hpp"

namespace gxrod::fuzz {
namespace {

constexpr std::string_view deck = "[analysis]\nkind = \"static\"\n";
constexpr std::string_view table = "EI,load,note\n1,2,a\n\"3\",4e3,\"b, c\"\n5,-6,\n";

// A table that the input brings along, after a separating line.
constexpr std::string_view table_mark = "\n#table\n";

const ScratchFolder& folder() {
    static const ScratchFolder all;
    return all;
}

void check_cases(const Plan& plan) {
    const CaseList cases(plan);
    expect(cases.count() >= 1, "a plan without cases");
    for (const long number : {1L, (cases.count() + 1) / 2, cases.count()}) {
        expect(cases.overrides(number).size() == plan.variations.size(), "a case without all its overrides");
        expect(cases.parameters(number).size() == cases.parameter_names().size(),
               "a case without all its values");
        (void)cases.describe(number);
    }
}

}  // namespace

void try_plan(std::string_view input) {
    const std::size_t mark = input.find(table_mark);
    folder().write("deck.toml", deck);
    folder().write("table.csv",
                   mark == std::string_view::npos ? table : input.substr(mark + table_mark.size()));
    const std::filesystem::path file = folder().write("plan.toml", input.substr(0, mark));
    try {
        (void)is_plan(file);
    } catch (const DeckError&) {
        // It may be neither.
    } catch (const FileError&) {
        return;  // such as one that is not in UTF-8
    }
    try {
        check_cases(read_plan(file));
    } catch (const DeckError& error) {
        expect(!error.faults.empty(), "a plan is refused without a reason");
    } catch (const FileError&) {
        return;
    }
}

}  // namespace gxrod::fuzz
