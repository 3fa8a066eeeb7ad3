#pragma once

#include <span>
#include <string>
#include <vector>

#include "face/simulation.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

// Simulations of one deck that are driven side by side: threads share them, and each is advanced by one
// thread, with the numbers that it would have alone.
class SimulationGroup {
  public:
    // The inputs that are set, and the quantities that are observed, of every member.
    struct Plan {
        std::vector<std::string> inputs;
        std::vector<RecordedQuantity> observed;
    };

    // Saves the state of each member, to which `reset` returns. The members must outlive the group. Throws
    // UnknownNameError.
    SimulationGroup(std::vector<Simulation*> members, Plan plan, int threads);

    std::size_t size() const { return members_.size(); }
    // Returns how many numbers are observed of each member.
    std::size_t width() const { return width_; }

    // Sets the inputs [size, inputs] and advances each member to its time [size]; NaN leaves a member as it
    // is. A step that fails leaves its member at the last accepted state; the text of the failure is in the
    // result [size], which is "" of all others.
    std::vector<std::string> advance(std::span<const double> inputs, std::span<const double> until);
    // Returns these members to the states that they had when the group was made.
    void reset(const std::vector<std::size_t>& members);
    // Observes these members again, after their inputs have been changed.
    void observe(const std::vector<std::size_t>& members);

    // Returns what was observed of each member at its last accepted state [size, width].
    const std::vector<double>& observations() const { return observations_; }

  private:
    std::string advance_one(std::size_t member, std::span<const double> inputs, double until);
    void observe_one(std::size_t member);

    std::vector<Simulation*> members_;
    Plan plan_;
    ThreadTeam team_;
    std::vector<Checkpoint> starts_;
    std::size_t width_ = 0;
    std::vector<double> observations_;
};

}  // namespace gxrod
