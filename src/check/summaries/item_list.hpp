#pragma once

#include <string>
#include <string_view>
#include <vector>

// Lists of repeated things, in full or shortened.
namespace gxrod {

// Things of one kind.
struct ItemList {
    std::string kind;                // in the plural: "rods"
    std::vector<std::string> items;  // texts of one line or several, with line ends
    std::string sum = {};            // a sum for readers who do not see each item; can be ""
};

enum class Detail { all, shortened };

// Describes the items; of a long list the first two and a sum: "and 382 more rods; all 384: …".
std::string describe(const ItemList& list, Detail detail);

// Shortens sentences: of sentences that differ only in names and numbers, keeps the first and counts the
// others.
std::vector<std::string> sum_up_repeats(const std::vector<std::string>& sentences);

long count_lines(std::string_view text);

}  // namespace gxrod
