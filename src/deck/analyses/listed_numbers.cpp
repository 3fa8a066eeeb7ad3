#include "deck/analyses/listed_numbers.hpp"

#include <cmath>

namespace gxrod {

std::vector<double> list_numbers(const NumbersTable& table, const BuildContext& context) {
    if (table.values) return *table.values;
    const double from = *table.from, to = table.to;
    const bool is_log = table.spacing == Spacing::log;
    if (from == to) context.add_fault(table, table.to, "expected another number than that of from");
    if (is_log && from == 0.0) {
        context.add_fault(table, table.from, "equal ratios cannot begin at 0");
    } else if (is_log && from * to <= 0.0) {
        context.add_fault(table, table.to, "equal ratios need two numbers of one sign that are not 0");
    }
    std::vector<double> values;
    for (long i = 0; i < table.count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(table.count - 1);
        values.push_back(is_log ? from * std::pow(to / from, part) : from + part * (to - from));
    }
    values.back() = to;
    return values;
}

}  // namespace gxrod
