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

// The cases that get a page, and the largest number of pages.
struct CaseChoice {
    CaseRange range{1, std::numeric_limits<long>::max()};
    std::size_t most = 200;
};

struct CasePages {
    std::vector<long> numbers;  // cases that have a page of their present results, ascending
    std::size_t written = 0;
    std::size_t kept = 0;             // pages that were up to date already
    std::size_t passed_over = 0;      // cases that the choice left out, as there were too many
    std::size_t lost = 0;             // cases in the table whose results do not exist
    std::vector<std::string> faults;  // faults of results that cannot be shown, a sentence each
};

// Reports how many of all pages are written.
using PageProgress = std::function<void(std::size_t written, std::size_t all)>;

// Returns the name of a case's page, "0017.html" for case 17: as wide as the numbers of kept results.
std::string case_page_name(long number, long cases);

// Writes the pages of cases whose results were kept, each of at most so many bytes; if there are too many,
// failed cases first. A page that is not older than its results stays. Results that cannot be shown do not
// prevent other pages. Throws FileError if the folder cannot be created.
CasePages write_case_pages(const std::filesystem::path& folder,
                           const BatchRecord& record,
                           const std::vector<CaseRow>& rows,
                           const CaseChoice& choice,
                           std::size_t most_bytes,
                           const PageProgress& progress);

}  // namespace gxrod
