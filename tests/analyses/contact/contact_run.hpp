#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Decks with contact that tests run step by step.
namespace gxrod::test {

// A deck, run to its end.
class ContactRun {
  public:
    explicit ContactRun(const std::string& deck)
        : problem_(read(deck)), analysis_(make_analysis(problem_.model, problem_.analysis(), 1)) {
        REQUIRE(analysis_->start().converged());
    }
    void finish() {
        while (!analysis_->finished()) step();
    }
    void step() {
        REQUIRE(analysis_->advance().converged());
        least_gap_ = std::min(least_gap_, analysis_->solver_row().least_gap);
        rejected_ += analysis_->solver_row().rejected_steps;
    }
    bool is_finished() const { return analysis_->finished(); }
    const NodeMotion& at(const std::string& node) const {
        const auto& nodes = problem_.model.nodes;
        const auto found = std::ranges::find(nodes, node, &Node::name);
        REQUIRE(found != nodes.end());
        return analysis_->state().trial[static_cast<std::size_t>(found - nodes.begin())];
    }
    ObstacleValues obstacle(std::size_t index = 0) const {
        return analysis_->snapshot(false).obstacles[index];
    }
    Vec6 reaction(const std::string& node) const {
        const auto& nodes = problem_.model.nodes;
        const auto found = std::ranges::find(nodes, node, &Node::name);
        return analysis_->snapshot(false).reactions[static_cast<std::size_t>(found - nodes.begin())];
    }
    std::vector<ContactTouch> touches() const {
        const Snapshot shown = analysis_->snapshot(true);
        return {shown.touches.begin(), shown.touches.end()};
    }
    LedgerRow ledger() const { return analysis_->ledger_row(); }
    double time() const { return analysis_->state().time; }
    double least_gap() const { return least_gap_; }
    int rejected() const { return rejected_; }

  private:
    Problem problem_;
    std::unique_ptr<SteppedAnalysis> analysis_;
    double least_gap_ = 1.0;
    int rejected_ = 0;
};

inline std::string rod(const char* name, const char* from, const char* to, int elements, int order = 2) {
    return fmt::format(
        "[rod.{}]\nsection = \"s\"\nline = {{ from = [{}], to = [{}] }}\nelements = {}\norder = {}\n",
        name,
        from,
        to,
        elements,
        order);
}

}  // namespace gxrod::test
