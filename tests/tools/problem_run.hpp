#pragma once

#include <filesystem>
#include <optional>

#include "deck/problem.hpp"
#include "run/run.hpp"

// Runs of whole decks, with all of their stages.
namespace gxrod::tools {

// Into a file, if one is named; interrupted after so many steps.
inline RunSummary run_problem(const Problem& problem,
                              const std::optional<std::filesystem::path>& file = std::nullopt,
                              int most_steps = -1) {
    RunRequest request{problem};
    if (file) request.results = ResultsFileOptions{*file};
    int steps = 0;
    request.is_interrupted = [&] { return steps++ == most_steps; };
    return run_analysis(request);
}

inline RunSummary resume_problem(const Problem& problem, const std::filesystem::path& path) {
    ResumableFile file(path);
    RunRequest request{problem, {}, &file};
    return run_analysis(request);
}

}  // namespace gxrod::tools
