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
    // Reads y and z as functions of s, or rows.
    std::optional<CheckedTendonPath> tendon_path(const DeckNode& node, const std::string& path) const;

  private:
    // Reads rows of fractions from 0 to 1; the values jump where the same fraction stands twice. read(row,
    // path, fraction) reads the values after the fraction and returns whether they are right.
    template <class Read>
    bool fractions(const DeckNode& node, const std::string& path, const Read& read) const;
    std::optional<CheckedTendonPath> tendon_rows(const DeckNode& node, const std::string& path) const;
    std::optional<std::pair<double, double>> table_row(const DeckNode& row,
                                                       const std::string& path,
                                                       const std::string& expected) const;
};

}  // namespace gxrod
