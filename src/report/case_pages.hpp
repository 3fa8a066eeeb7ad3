#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "batch/batch_record.hpp"
#include "batch/cases/case_table.hpp"

// Pages of the cases of a batch, in its folder reports/.
namespace gxrod {

// Which cases get a page, and how many of those at most.
struct CaseChoice {
    CaseRange range{1, std::numeric_limits<long>::max()};
    std::size_t most = 200;
};

struct CasePages {
    std::vector<long> numbers;  // of the cases that have a page of their present results, rising
    std::size_t written = 0;
    std::size_t kept = 0;             // that had one of their results already
    std::size_t passed_over = 0;      // that the choice left out for there were too many
    std::size_t lost = 0;             // whose results the table names, but are not there
    std::vector<std::string> faults;  // of results that cannot be shown, a sentence each
};

// How many of how many pages are written.
using PageProgress = std::function<void(std::size_t written, std::size_t all)>;

// "0017.html" of case 17: as wide as the numbers of kept results.
std::string case_page_name(long number, long cases);

// Writes the pages of cases whose results were kept, each of at most so many bytes; those that failed come
// first, if there are too many. A page that is not older than its results stays as it is. Results that cannot
// be shown keep no other page from being written. Throws FileError if the folder cannot be created.
CasePages write_case_pages(const std::filesystem::path& folder,
                           const BatchRecord& record,
                           const std::vector<CaseRow>& rows,
                           const CaseChoice& choice,
                           std::size_t most_bytes,
                           const PageProgress& progress);

}  // namespace gxrod
