#include "deck/schema.hpp"

#include <fmt/core.h>

#include <memory>

#include "exit_code.hpp"
#include "verbs.hpp"

namespace gxrod {

void add_schema_verb(CLI::App& program, int& exit_code) {
    auto markdown = std::make_shared<bool>(false);
    CLI::App* verb = program.add_subcommand("schema", "Print the JSON Schema of decks, for editors");
    verb->add_flag("--markdown", *markdown, "Print the deck reference (docs/deck.md) instead");
    verb->callback([markdown, &exit_code] {
        fmt::print("{}\n", *markdown ? deck_reference() : json_schema(deck_schema(), "gxrod deck"));
        exit_code = exit_done;
    });
}

}  // namespace gxrod
