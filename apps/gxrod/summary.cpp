#include "summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "machine/file_error.hpp"
#include "run/summary_json.hpp"
#include "say.hpp"

namespace gxrod {

void write_json(const std::string& target, const nlohmann::ordered_json& json) {
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
    if (target == "-") {
        say(stdout, "{}\n", text);
        return;
    }
    std::ofstream file(target);
    file << text << '\n';
    file.close();
    if (!file) throw FileError(target, "the summary could not be written");
}

void write_summary(const std::string& target,
                   const RunSummary& summary,
                   const std::string& deck,
                   const std::string& results) {
    write_json(target, describe_summary(summary, deck, results));
}

}  // namespace gxrod
