#pragma once

#include <utility>
#include <vector>

#include "deck/reading/function_reader.hpp"

namespace gxrod {

// Reads rows of numbers, names and functions.
class RowReader : public FunctionReader {
  public:
    using FunctionReader::FunctionReader;
    std::optional<TimeTable> time_table(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedPairs> pairs(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedProfile> profile(const DeckNode& node, const std::string& path) const;
    std::optional<std::vector<CheckedStation>> stations(const DeckNode& node, const std::string& path) const;
    // y and z as functions of s, or rows.
    std::optional<CheckedTendonPath> tendon_path(const DeckNode& node, const std::string& path) const;

  private:
    // From 0 to 1; where the same fraction stands twice, what follows it jumps. read(row, path, fraction)
    // takes what stands behind the fraction, and returns whether it is right.
    template <class Read>
    bool fractions(const DeckNode& node, const std::string& path, const Read& read) const;
    std::optional<CheckedTendonPath> tendon_rows(const DeckNode& node, const std::string& path) const;
    std::optional<std::pair<double, double>> table_row(const DeckNode& row,
                                                       const std::string& path,
                                                       const std::string& expected) const;
};

}  // namespace gxrod
