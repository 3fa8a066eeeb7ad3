#include "batch/gathering.hpp"

#include <algorithm>
#include <system_error>

#include "batch/cases/case_table.hpp"
#include "batch/plan/plan_schema.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> list_idle_parts(const fs::path& folder, const BatchLock& lock) {
    std::vector<fs::path> parts = list_parts(folder);
    std::erase_if(parts,
                  [&](const fs::path& part) { return !lock.list_running(*range_of_part(part)).empty(); });
    return parts;
}

}  // namespace

bool has_idle_parts(const fs::path& folder, const BatchLock& lock) {
    return !list_idle_parts(folder, lock).empty();
}

std::vector<CaseRow> gather_parts(const fs::path& folder, const BatchRecord& record, const BatchLock& lock) {
    // Those that are idle now get no more rows: a slice begins one under the table's lock.
    const std::vector<fs::path> idle_parts = list_idle_parts(folder, lock);
    std::vector<CaseRow> rows = read_case_rows(folder, record);
    write_case_table(folder, record, rows);
    std::error_code ignored;
    for (const fs::path& part : idle_parts) fs::remove(part, ignored);
    if (!lock.list_running({1, largest_case_count}).empty()) return rows;
    // Those that nothing is in.
    for (const char* name : {"parts", "cases"}) fs::remove(folder / name, ignored);
    return rows;
}

}  // namespace gxrod
