#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "face/fmu_variables.hpp"
#include "face/simulation.hpp"

namespace gxrod {

// An instance of an FMU: a run of its deck whose variables are set and read by their references. The run
// begins when its values are first asked for, or with the first step; parameters are set before.
class FmuRun {
  public:
    // Reads deck.toml and the files that it names from the folder of the FMU's resources. Throws FileError
    // and DeckError.
    explicit FmuRun(const std::filesystem::path& resources);

    // Throw std::invalid_argument for a reference that the FMU does not have, or that cannot be set.
    double get(std::size_t reference);
    void set(std::size_t reference, double value);

    // Sets the time of the master at which the run begins.
    void begin(double start) { start_ = start; }
    // Builds the run at t = 0 if it is not there yet. Throws DeckError, ConvergenceError, EvaluationError.
    void initialize();
    // Advances to a time of the master. Throws ConvergenceError, EvaluationError, and std::out_of_range if
    // the deck ends before.
    void advance(double until);
    // Returns to the numbers of the deck, before t = 0.
    void reset();
    double time() const { return start_ + (simulation_ ? simulation_->time() : 0.0); }

    // An accepted state, with the inputs.
    struct State {
        Checkpoint checkpoint;
        std::map<std::size_t, double> inputs;
    };
    State save();
    void restore(const State& state);

  private:
    const FmuVariable& find(std::size_t reference) const;
    Problem build() const;

    DeckRecord record_;
    std::vector<FmuVariable> variables_;
    std::map<std::size_t, double> parameters_;  // that were set
    std::map<std::size_t, double> inputs_;      // that were set
    double start_ = 0.0;
    std::unique_ptr<Simulation> simulation_;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> seen_;  // since the last step
};

// Lists the files of an FMU of this problem, without its library: {path in the archive, bytes}.
std::map<std::string, std::string> list_fmu_files(const Problem& problem);

}  // namespace gxrod
