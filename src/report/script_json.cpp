#include "report/script_json.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace gxrod {

std::string write_script_json(const nlohmann::ordered_json& json) {
    const std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    std::string safe;
    safe.reserve(text.size());
    // Outside of strings, JSON does not have these characters.
    for (const char c : text) {
        switch (c) {
            case '<':
                safe += "\\u003c";
                break;
            case '>':
                safe += "\\u003e";
                break;
            case '&':
                safe += "\\u0026";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

void write_description(std::ostream& out, const nlohmann::ordered_json& json) {
    out << "<script type=\"application/json\" id=\"report\">" << write_script_json(json) << "</script>\n";
}

}  // namespace gxrod
