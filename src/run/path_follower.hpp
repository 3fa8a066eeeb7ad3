#pragma once

#include <deque>
#include <memory>

#include "analyses/path/path.hpp"

namespace gxrod {

// What a stage that goes along a path has found, and which branches are still to be followed.
class PathFollower {
  public:
    // From a start to a number of generations; `name` is the main path's.
    PathFollower(const PathSettings& settings, std::string name);

    // The path at hand begins with this row of the histories.
    void begin(std::int64_t row) { record_.back().first_row = row; }
    // The last accepted step of the path at hand is this row.
    void note(const PathAnalysis& path, std::int64_t row);
    // The path at hand is over, or was given up; its branches are queued.
    void end(const PathAnalysis& path, const std::string& cause);
    // The start of the next branch, which is then the path at hand; nullopt if there are no more.
    std::optional<BranchStart> enter_next();

    const PathRecord& record() const { return record_; }
    // Whether any path has met a critical point.
    bool has_points() const;

  private:
    struct Waiting {
        BranchStart start;
        FollowedPath path;
        int generation;
    };

    PathSettings settings_;
    PathRecord record_;
    int generation_ = 0;  // of the path at hand
    std::deque<Waiting> waiting_;
    std::vector<std::vector<NodeMotion>> origins_;  // where branches begin that were queued
};

}  // namespace gxrod
