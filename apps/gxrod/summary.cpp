#include "summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "machine/file_error.hpp"
#include "model/version.hpp"
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
    const nlohmann::ordered_json json = {
        {"status", name_of(summary.status)},
        {"reason", summary.reason},
        {"warnings", summary.warnings},
        {"deck", deck},
        {"results", results},
        {"nodes", summary.nodes},
        {"elements", summary.elements},
        {"unknowns", summary.unknowns},
        {"steps", summary.totals.steps},
        {"rejected_steps", summary.totals.rejected_steps},
        {"cuts", summary.cuts},
        {"newton_limit", summary.newton_limit},
        {"newton_iterations", summary.totals.newton_iterations},
        {"time", summary.time},
        {"wall_seconds",
         {{"total", summary.wall_seconds},
          {"setup", summary.phases.setup},
          {"assembly", summary.phases.assembly},
          {"solve", summary.phases.solve},
          {"update", summary.phases.update},
          {"output", summary.phases.output}}},
        {"threads", summary.threads},
        {"version", version},
    };
    write_json(target, json);
}

}  // namespace gxrod
