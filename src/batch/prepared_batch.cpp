#include "batch/prepared_batch.hpp"

#include "batch/batch_folder.hpp"
#include "batch/cases/case_check.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;

std::deque<DeckTemplate> read_decks(const Plan& plan) {
    std::deque<DeckTemplate> decks;
    for (const fs::path& deck : plan.decks) decks.emplace_back(deck);
    return decks;
}

}  // namespace

PreparedBatch::PreparedBatch(Plan plan,
                             const std::optional<CaseRange>& only,
                             const std::function<void(long, long)>& report)
    : plan_(std::move(plan)), cases_(plan_), decks_(read_decks(plan_)) {
    const CaseRange range = only.value_or(all());
    CheckedCases checked = check_cases(context(""), range, [&](long examined) {
        if (report) report(examined, range.count());
    });
    meshes_ = std::move(checked.meshes);
    kept_ = checked.kept;
    record_ = make_batch_record(plan_, cases_, decks_, checked.title, meshes_);
}

std::vector<CaseRow> PreparedBatch::read_rows(const fs::path& folder) const {
    check_batch_folder(folder);
    if (!is_batch_folder(folder)) return {};
    check_same_batch(read_batch_record(folder), record_, plan_, decks_, folder);
    return read_case_rows(folder, record_);
}

std::vector<CaseRow> PreparedBatch::open_folder(const fs::path& folder, bool begin_anew) const {
    remove_leftovers(folder);
    if (begin_anew) clear_batch_folder(folder);
    std::vector<CaseRow> rows;
    if (!begin_anew) rows = read_rows(folder);
    if (begin_anew || !is_batch_folder(folder)) write_batch_record(record_, folder);
    return rows;
}

}  // namespace gxrod
