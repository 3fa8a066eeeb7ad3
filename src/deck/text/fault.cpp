#include "deck/text/fault.hpp"

#include <fmt/format.h>

#include "machine/printable.hpp"

namespace gxrod {
namespace {

std::string describe_all(const std::vector<DeckFault>& faults) {
    std::string lines;
    for (const DeckFault& fault : faults) {
        if (!lines.empty()) lines += '\n';
        lines += describe(fault);
    }
    return lines;
}

}  // namespace

std::string describe(const DeckFault& fault) {
    std::string line = fault.file;
    if (fault.line > 0) line += fmt::format(":{}:{}", fault.line, fault.column);
    if (!fault.key.empty()) line += ": " + fault.key;
    return printable(line + ": " + fault.message);
}

DeckError::DeckError(std::vector<DeckFault> all)
    : std::runtime_error(describe_all(all)), faults(std::move(all)) {}

}  // namespace gxrod
