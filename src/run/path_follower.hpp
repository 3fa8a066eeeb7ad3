#pragma once

#include <deque>
#include <memory>

#include "analyses/path/path.hpp"

namespace gxrod {

// The paths that a stage has found, and the branches that are still to be followed.
class PathFollower {
  public:
    // Starts with the main path, called `name`; the settings bound the generations of branches.
    PathFollower(const PathSettings& settings, std::string name);

    // Notes that the current path begins with this row of the histories.
    void begin(std::int64_t row) { record_.back().first_row = row; }
    // Notes the row of the last accepted step of the current path.
    void note(const PathAnalysis& path, std::int64_t row);
    // Ends the current path, or gives it up because of `cause`, and queues its branches.
    void end(const PathAnalysis& path, const std::string& cause);
    // Makes the next branch the current path and returns its start; nullopt if there are no more.
    std::optional<BranchStart> enter_next();

    const PathRecord& record() const { return record_; }
    // Returns whether any path has met a critical point.
    bool has_points() const;

  private:
    struct Waiting {
        BranchStart start;
        FollowedPath path;
        int generation;
    };

    PathSettings settings_;
    PathRecord record_;
    int generation_ = 0;  // generation of the current path
    std::deque<Waiting> waiting_;
    std::vector<std::vector<NodeMotion>> origins_;  // starts of branches that were queued
};

}  // namespace gxrod
