#include "batch/plan/read_fatigue.hpp"

namespace gxrod {
namespace {

SNCurve draw_curve(const DamageTable& given) {
    SNCurve curve = given.detail ? make_eurocode_curve(*given.detail) : SNCurve{};
    curve.factor = given.factor;
    if (given.detail) return curve;
    curve.lines.push_back({*given.slope, *given.cycles, *given.at});
    if (given.second_slope) curve.lines.push_back({*given.second_slope, *given.cycles, *given.at});
    curve.limit = given.limit.value_or(0.0);
    return curve;
}

}  // namespace

std::optional<FatigueCount> read_fatigue(const CollectTable& table, FaultList& faults) {
    FatigueCount count;
    if (table.range) {
        count.slope = table.range->slope;
        count.cycles = table.range->cycles;
        count.from = table.range->from;
        return count;
    }
    const DamageTable& given = *table.damage;
    const bool is_whole = given.detail || (given.slope && given.cycles && given.at);
    if (!is_whole) return std::nullopt;
    count.curve = draw_curve(given);
    count.category = given.detail;
    count.ultimate = given.ultimate.value_or(0.0);
    count.from = given.from;
    const std::string fault = find_fault(*count.curve);
    if (fault.empty()) return count;
    faults.add(given.place_of(&given.limit), given.path_of(&given.limit), fault);
    return std::nullopt;
}

}  // namespace gxrod
