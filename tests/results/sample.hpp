#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "state/records/restart_record.hpp"
#include "state/records/step_record.hpp"

// A made-up model and motion, known at every time, to write results of.
namespace gxrod::sample {

// Nodes 0–2: rod "beam" of two elements, with body "tip" on node 2; node 3: body "gyro".
Model make_model();
// Histories "middle" (beam node 1), "root" (beam node 0), "tip" (body on node 2) and "gyro", with all
// quantities that suit them.
OutputSettings make_output();
DeckRecord make_deck();

// The motion at a time, as an analysis would hand it over.
struct Motion {
    explicit Motion(double time);
    Snapshot snapshot() const { return {time, nodes, elements, reactions, points}; }

    double time;
    std::vector<NodeMotion> nodes;
    std::vector<SectionValues> elements;
    std::vector<Vec6> reactions;
    std::vector<PointValues> points;  // "middle" and "root"
};
LedgerRow make_ledger(double time);
SolverRow make_solver(double time);
// All nodes at (t, 2t, 3t).
RestartRecord make_restart(double time);

// A folder that is removed with all that is in it.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace gxrod::sample
