#include "deck/output/line_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "deck/output/history_place.hpp"
#include "deck/output/history_table.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"
#include "watch/line_end_words.hpp"

namespace gxrod {
namespace {

// Makes a name of a history: letters, digits, _ and -.
std::string name_line_end(const std::string& rod, const char* end) {
    std::string name = rod + "_" + end;
    std::ranges::replace_if(
        name,
        [](char letter) { return letter != '-' && std::isalnum(static_cast<unsigned char>(letter)) == 0; },
        '_');
    return name;
}

bool has_history(const BuildContext& context, const std::string& name) {
    return std::ranges::any_of(tables_of<HistoryKeys>(context.deck, history_table()),
                               [&](const HistoryKeys& history) { return history.name == name; });
}

}  // namespace

void add_line_ends(const TableHead& table,
                   const TableNames& field,
                   const BuildContext& context,
                   std::vector<HistoryRequest>& histories) {
    const auto add = [&](const std::string& rod, const char* what, const std::string& at) {
        HistoryRequest request{.name = name_line_end(rod, what), .at = at};
        const std::vector<WatchedText> found = find_watched(at, context);
        if (found.empty()) return;
        request.target = found.front().thing;
        request.quantities = list_line_end_words(request.target, context.model);
        if (request.quantities.empty()) return;
        if (has_history(context, request.name)) {
            context.add_fault(
                table,
                field,
                fmt::format("a [[history]] has the name \"{}\", which is that of {}; give it another",
                            request.name,
                            at));
        }
        histories.push_back(std::move(request));
    };
    for (const Part& part : find_parts(table, field, context)) {
        const std::string& rod = context.model.rods[static_cast<std::size_t>(part.rod)].name;
        add(rod, "start", rod + ".start");
        add(rod, "end", rod + ".end");
        if (context.model.surroundings.seabed) add(rod, "ground", rod);
    }
}

}  // namespace gxrod
