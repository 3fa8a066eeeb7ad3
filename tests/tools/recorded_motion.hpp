#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

namespace gxrod::tools {

// A complete run of a deck: its histories, and what they share. Interrupted after so many steps and resumed,
// if that is asked for.
class RecordedMotion {
  public:
    using Row = std::vector<double>;

    RecordedMotion(const std::string& deck,
                   const std::vector<std::string>& overrides = {},
                   int interrupted_after = -1) {
        const Problem problem = test::read(deck, overrides);
        const std::filesystem::path path = folder_ / "run.vtkhdf";
        summary_ = run_problem(problem, path, interrupted_after);
        if (interrupted_after >= 0) {
            REQUIRE(summary_.status != RunStatus::complete);
            summary_ = resume_problem(problem, path);
        }
        INFO(summary_.reason);
        REQUIRE(summary_.status == RunStatus::complete);
        file_.emplace(path);
    }

    // A quantity of a history at this time.
    Row at(double time, const std::string& name) const {
        const std::vector<double> times = file_->numbers("/histories/time");
        const std::vector<double> values = file_->numbers("/histories/" + name);
        const std::size_t columns = values.size() / times.size();
        std::size_t step = 0;
        while (times.at(step) < time - 1e-9) ++step;
        REQUIRE(std::abs(times[step] - time) < 1e-9);
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(step * columns);
        return {first, first + static_cast<std::ptrdiff_t>(columns)};
    }
    // Any step's.
    double largest(const std::string& name) const {
        double largest = 0.0;
        for (const double value : file_->numbers(name)) largest = std::max(largest, std::abs(value));
        return largest;
    }
    // Of all steps.
    Row all(const std::string& name) const { return file_->numbers(name); }

  private:
    sample::ScratchFolder folder_;
    RunSummary summary_;
    std::optional<Hdf5Reader> file_;
};

}  // namespace gxrod::tools
