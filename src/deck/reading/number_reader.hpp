#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "deck/reading/reading_context.hpp"
#include "deck/schema/schema.hpp"
#include "deck/text/deck_tree.hpp"
#include "rotation/types.hpp"

namespace gxrod {

// Reads numbers, vectors and matrices as the value of a key; elements of arrays have their own place and
// path.
class NumberReader {
  public:
    NumberReader(const KeySpec& key, const ReadingContext& context) : key_(key), context_(context) {}
    std::optional<double> number(const DeckNode& node, const std::string& path) const;
    // Reads a finite number, whether it is in the range of the key or not.
    std::optional<double> finite_number(const DeckNode& node, const std::string& path) const;
    std::optional<long> integer(const DeckNode& node, const std::string& path) const;
    std::optional<Vec3> vector(const DeckNode& node, const std::string& path) const;
    std::optional<Mat3> square_matrix(const DeckNode& node, const std::string& path) const;
    std::optional<Mat3> matrix(const DeckNode& node, const std::string& path) const;
    std::optional<bool> flag(const DeckNode& node, const std::string& path) const;
    static bool is_array_of(const DeckNode& node, std::size_t size) {
        return node.array() != nullptr && node.array()->size() == size;
    }

    static bool is_matrix(const DeckNode& node) {
        return is_array_of(node, 3) &&
               std::any_of(node.array()->begin(), node.array()->end(), [](const DeckNode& row) {
                   return row.array() != nullptr;
               });
    }

  protected:
    void add(const DeckNode& node, const std::string& path, const std::string& message) const;
    void expect(const DeckNode& node, const std::string& path, const std::string& expected) const;
    std::optional<double> in_range(const DeckNode& node, const std::string& path, double value) const;
    // Returns the number as in the deck, with its value if it is an expression.
    static std::string found_value(const DeckNode& node, double value);
    // Describes the expected number; components of vectors and tables are described as plain numbers.
    std::string number_expected() const;
    std::string remark() const { return key_.remark.empty() ? "" : "; " + key_.remark; }

    const KeySpec& key_;
    const ReadingContext& context_;
};

}  // namespace gxrod
