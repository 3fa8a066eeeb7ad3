#include "run/path_follower.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gxrod {
namespace {

// Whether two equilibria are the same point of a path.
bool is_same_place(const std::vector<NodeMotion>& a, const std::vector<NodeMotion>& b, double length) {
    constexpr double close = 1e-5;
    double farthest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, (a[i].r - b[i].r).norm());
    return farthest < close * length;
}

}  // namespace

PathFollower::PathFollower(const PathSettings& settings, std::string name) : settings_(settings) {
    record_.push_back({.name = std::move(name)});
}

void PathFollower::note(const PathAnalysis& path, std::int64_t row) {
    record_.back().rows.resize(path.critical_points().size(), row);
}

void PathFollower::end(const PathAnalysis& path, const std::string& cause) {
    const auto index = static_cast<int>(record_.size()) - 1;
    FollowedPath& ended = record_.back();
    ended.points = path.critical_points();
    ended.findings = path.list_findings();
    ended.cause = cause;
    const double length = path.system().length_scale();
    // Where a branch meets another bifurcation it is the branch to both sides of that.
    std::erase_if(waiting_, [&](const Waiting& one) {
        return index > 0 && std::any_of(ended.points.begin(), ended.points.end(), [&](const auto& point) {
                   return is_critical(point.kind) &&
                          is_same_place(point.nodes, one.start.state.previous, length);
               });
    });
    if (generation_ >= settings_.branches) return;
    const std::size_t known = origins_.size();
    for (const BranchStart& start : path.branches()) {
        const auto end = origins_.begin() + static_cast<std::ptrdiff_t>(known);
        if (std::any_of(origins_.begin(), end, [&](const auto& origin) {
                return is_same_place(origin, start.state.previous, length);
            }))
            continue;
        const std::string name =
            fmt::format("{}.{}{}", ended.name, start.point + 1, start.side > 0 ? "+" : "−");
        waiting_.push_back({start,
                            {.name = name, .parent = index, .point = start.point, .side = start.side},
                            generation_ + 1});
    }
    for (const BranchStart& start : path.branches()) origins_.push_back(start.state.previous);
}

std::optional<BranchStart> PathFollower::enter_next() {
    if (waiting_.empty()) return std::nullopt;
    Waiting next = std::move(waiting_.front());
    waiting_.pop_front();
    generation_ = next.generation;
    record_.push_back(std::move(next.path));
    return std::move(next.start);
}

bool PathFollower::has_points() const {
    return std::any_of(
        record_.begin(), record_.end(), [](const FollowedPath& path) { return !path.rows.empty(); });
}

}  // namespace gxrod
