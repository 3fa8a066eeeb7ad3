#pragma once

#include <string>
#include <string_view>
#include <vector>

// What repeats in a model, in full or in short.
namespace gxrod {

// Things of one kind.
struct ItemList {
    std::string kind;                // in the plural: "rods"
    std::vector<std::string> items;  // texts of one line or several, with line ends
    std::string sum = {};            // of all of them, for readers who are not shown each; can be ""
};

enum class Detail { all, shortened };

// The items, or of a long list the first two and what the rest is: "and 382 more rods; all 384: …".
std::string describe(const ItemList& list, Detail detail);

// The same for sentences: of those that differ in names and numbers alone, the first and how many are like
// it.
std::vector<std::string> sum_up_repeats(const std::vector<std::string>& sentences);

long count_lines(std::string_view text);

}  // namespace gxrod
