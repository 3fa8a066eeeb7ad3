#include "deck/output/listed_values.hpp"

#include <cmath>

namespace gxrod {

std::vector<double> list_values(const CheckedTable& table, const BuildContext& context) {
    if (table.gives("values")) return table.get<std::vector<double>>("values");
    const double from = table.get<double>("from"), to = table.get<double>("to");
    const bool is_log = table.get<std::string>("spacing") == "log";
    if (from == to) context.add_fault(table, "to", "expected another number than that of from");
    if (is_log && from * to <= 0.0) {
        context.add_fault(table,
                          from == 0.0 ? "from" : "to",
                          from == 0.0 ? "equal ratios cannot begin at 0"
                                      : "equal ratios need two numbers of one sign that are not 0");
    }
    const long count = table.get<long>("count");
    std::vector<double> values;
    for (long i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        values.push_back(is_log ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    values.back() = to;
    return values;
}

}  // namespace gxrod
