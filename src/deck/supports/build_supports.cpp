#include "deck/supports/build_supports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/checks/check_moves.hpp"
#include "deck/joints/ends.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/plane.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/supports/support_merge.hpp"

namespace gxrod {
namespace {

NodeSupport& find_support(int node, std::vector<NodeSupport>& supports, std::vector<int>& by_node) {
    if (by_node[node] < 0) {
        by_node[node] = static_cast<int>(supports.size());
        supports.push_back({{.node = node}, {}, {}});
    }
    return supports[by_node[node]];
}

// Fixing one rotation alone would leave open what the other two mean once the point has turned.
void report_lone_fix(const NodeSupport& supported, std::size_t component, const BuildContext& context) {
    const CheckedTable& table = *supported.holders[component];
    for (const CheckedWord& word : table.get<std::vector<CheckedWord>>("fix")) {
        if (word.word != component_names[component]) continue;
        return context.faults.add(
            word.place,
            word.path,
            fmt::format(
                "{} alone cannot be fixed: what stays free would depend on the path of the motion; "
                "expected two of rx, ry, rz (a hinge about the third axis), all three or none; or, for "
                "the turn about one axis, a joint of type \"free\" from the ground with move = {{ turn = 0 "
                "}}",
                word.word));
    }
}

// A rotation vector has a meaning as a whole only.
void report_incomplete_move(const NodeSupport& supported,
                            std::size_t component,
                            const BuildContext& context) {
    std::vector<std::string> free;
    for (std::size_t i = 3; i < 6; ++i) {
        if (!supported.support.holds(static_cast<int>(i))) free.emplace_back(component_names[i]);
    }
    const CheckedTimeFunction& value = *moves_of(*supported.holders[component])[component];
    const char* hint = free.size() == 2
                           ? "; or, for the turn about one axis, a joint of type \"free\" from the "
                             "ground with move = { turn = … }"
                           : "";
    context.faults.add(
        value.place,
        value.path,
        fmt::format("where a rotation moves, the other two must be fixed or moved too; free: {}{}",
                    plain_list(free),
                    hint));
}

void check_rotations(const NodeSupport& supported, const BuildContext& context) {
    const Support& support = supported.support;
    int held = 0;
    for (int i = 3; i < 6; ++i) held += support.holds(i) ? 1 : 0;
    if (held == 0 || held == 3) return;
    for (std::size_t i = 3; i < 6; ++i) {
        if (support.moved[i]) return report_incomplete_move(supported, i, context);
    }
    for (std::size_t i = 3; i < 6; ++i) {
        if (support.fixed[i] && held == 1) return report_lone_fix(supported, i, context);
    }
}

// A model without an unknown is a mistake, unless its supports move it.
void check_freedom(const std::vector<NodeSupport>& supports, const BuildContext& context) {
    const auto is_clamped = [](const NodeSupport& supported) {
        const auto& fixed = supported.support.fixed;
        return std::find(fixed.begin(), fixed.end(), false) == fixed.end();
    };
    const bool all_supported = !supports.empty() && supports.size() == context.model.nodes.size();
    if (!all_supported || !std::all_of(supports.begin(), supports.end(), is_clamped)) return;
    context.add_fault(
        *supports.front().tables.front(), "fix", "every node of the deck is fixed; nothing can move");
}

}  // namespace

void build_supports(BuildContext& context) {
    std::vector<NodeSupport> supports;
    std::vector<int> by_node(context.model.nodes.size(), -1);
    const double model_size = measure_size(context.model, {});
    for (const CheckedTable& table : context.deck.tables("support")) {
        if (!acts_in_stage(table, context)) continue;
        const std::optional<PlacedPoint> point = context.place(table.get<std::string>("at"));
        if (point) merge_support(table, find_support(point->node, supports, by_node), context);
        const auto moves = moves_of(table);
        for (std::size_t i = 0; i < moves.size(); ++i) {
            if (moves[i] != nullptr) check_move(*moves[i], i < 3 ? model_size : 1.0, context);
        }
    }
    for (NodeSupport& supported : supports) {
        if (context.model.plane) hold_plane(supported, context);
        check_rotations(supported, context);
        context.model.supports.push_back(supported.support);
    }
    check_freedom(supports, context);
}

}  // namespace gxrod
