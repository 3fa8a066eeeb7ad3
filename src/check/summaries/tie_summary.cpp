#include "check/summaries/tie_summary.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "check/summaries/joint_summary.hpp"
#include "model/spring_law.hpp"
#include "model/ties/ties.hpp"
#include "model/ties/yielding_supports.hpp"

namespace gxrod {

namespace {

std::string describe_tie(const Model& model, const Spring& spring) {
    const Vec3 d = find_place(model, spring.ends[1]) - find_place(model, spring.ends[0]);
    const double force = compute_elastic_tension(spring, d.norm());
    constexpr double round_off = 1e-12;
    const bool is_free = std::abs(force) <= round_off * find_stiffness(spring) * d.norm();
    std::string text =
        fmt::format("spring {}: between {} and {}, stiffness {:.6g}, damping {:.6g}, length {:.6g}",
                    spring.name,
                    describe_anchor(model, spring.ends[0]),
                    describe_anchor(model, spring.ends[1]),
                    spring.stiffness,
                    spring.damping,
                    spring.length);
    if (spring.law) text += spring.law->has_rate() ? ", a force by length and rate" : ", a force by length";
    if (!is_free)
        text += fmt::format("; at t = 0 {:.6g} long, {} by {:.6g}",
                            d.norm(),
                            force < 0.0 ? "it pushes" : "it pulls",
                            std::abs(force));
    return text + "\n";
}

// The components that a bushing's matrix resists, with their diagonal entries: "x 100, rz 2".
std::string describe_diagonal(const Mat6& matrix) {
    std::string text;
    for (int i = 0; i < 6; ++i) {
        if (matrix(i, i) == 0.0) continue;
        text += fmt::format("{}{} {:.6g}", text.empty() ? "" : ", ", component_names[i], matrix(i, i));
    }
    return text.empty() ? "none" : text;
}

std::string describe_yielding(const Model& model, const Bushing& bushing) {
    std::string text = fmt::format("support at {}: yields, stiffness {}, damping {}",
                                   describe_anchor(model, bushing.ends[1]),
                                   describe_diagonal(bushing.stiffness),
                                   describe_diagonal(bushing.damping));
    if (!bushing.axes.isApprox(Quat::Identity(), 0.0)) text += ", in its own axes";
    return text + "\n";
}

std::string describe_tie(const Model& model, const Bushing& bushing) {
    if (is_support(bushing)) return describe_yielding(model, bushing);
    static constexpr std::array<const char*, 4> carriers{
        "", ", axes that turn with A", ", axes that turn with B", ", axes fixed in space"};
    return fmt::format("bushing {}: between {} and {}{}, stiffness {}, damping {}\n",
                       bushing.name,
                       describe_anchor(model, bushing.ends[0]),
                       describe_anchor(model, bushing.ends[1]),
                       carriers[static_cast<std::size_t>(bushing.carrier)],
                       describe_diagonal(bushing.stiffness),
                       describe_diagonal(bushing.damping));
}

}  // namespace

std::vector<ItemList> list_element_summaries(const Model& model) {
    std::vector<ItemList> lists;
    for_each_element_list(model, [&](TieKind kind, const auto& ties) {
        lists.push_back({card_of(kind).names, {}});
        for (const auto& tie : ties) lists.back().items.push_back(describe_tie(model, tie));
    });
    return lists;
}

}  // namespace gxrod
