#include "deck/schema/schema.hpp"

#include <memory>

#include "batch/plan/plan_schema.hpp"
#include "exit_code.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {

namespace {

struct SchemaArguments {
    bool plan = false;
    bool markdown = false;
};

std::string write_schema(const SchemaArguments& arguments) {
    if (arguments.markdown) return arguments.plan ? plan_reference() : deck_reference();
    return arguments.plan ? json_schema(plan_schema(), "gxrod plan")
                          : json_schema(deck_schema(), "gxrod deck");
}

}  // namespace

void add_schema_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<SchemaArguments>();
    CLI::App* verb = program.add_subcommand("schema", "Print the JSON Schema of decks or plans, for editors");
    verb->add_flag("--plan", arguments->plan, "Schema of plans, which gxrod batch runs, instead of decks");
    verb->add_flag(
        "--markdown", arguments->markdown, "Print the reference (docs/deck.md, docs/plan.md) instead");
    verb->callback([arguments, &exit_code] {
        say(stdout, "{}\n", write_schema(*arguments));
        exit_code = exit_done;
    });
}

}  // namespace gxrod
