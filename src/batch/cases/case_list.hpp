#pragma once

#include <string>
#include <vector>

#include "batch/plan/plan.hpp"

namespace gxrod {

// The cases of a plan, numbered from 1. Each is made on request, so many cases take no memory.
class CaseList {
  public:
    // `plan` must outlive the list.
    explicit CaseList(const Plan& plan);

    long count() const { return count_; }
    // Returns the parameters that differ between cases, in the order of the columns: keys of the deck, or
    // "deck".
    std::vector<std::string> parameter_names() const;
    // Returns their values as tables show them: text without its quotes.
    std::vector<std::string> parameters(long number) const;
    // Returns the "KEY=VALUE" of --set.
    std::vector<std::string> overrides(long number) const;
    // Describes a case as "parameters.EI = 100, analysis.beta = 0.25".
    std::string describe(long number) const;
    // Returns the index in Plan::decks.
    std::size_t deck(long number) const;

  private:
    std::string value(std::size_t variation, long number) const;

    const Plan& plan_;
    long count_ = 0;
    std::vector<std::vector<double>> probabilities_;  // for each variation of a Latin hypercube
};

}  // namespace gxrod
