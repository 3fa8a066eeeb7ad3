#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "batch/batch_record.hpp"
#include "batch/cases/case_row.hpp"

namespace gxrod {

// The data that the page of a batch shows.
struct BatchStory {
    const BatchRecord* record = nullptr;
    const std::vector<CaseRow>* rows = nullptr;  // cases that have ended
    std::string folder;                          // its name
    std::string pages;                           // address of the folder of the cases' pages, from the page
    std::vector<long> cases_with_page;
    std::size_t most_bytes = 0;  // largest size of the page
};

// The parts of these data that fit into the page.
struct BatchContent {
    std::size_t rows = 0;   // number of rows, from the first
    std::size_t decks = 0;  // number of cases, from the first, with the text of their decks
};

// Describes these data as JSON: {gxrod_version, folder, plan, plan_text, title, combine, seed, cases,
// finished, seconds, warned, counts, parameters, columns, decks, rows, texts, …}. Rows are columns of equal
// length; status, reason and warning are indices in "statuses" and "texts", as few of them differ. Parameters
// are texts; numbers that are not finite become null.
nlohmann::ordered_json describe_batch(const BatchStory& story, const BatchContent& content);

// Plans as much as fits into so many bytes of script JSON: texts of decks in at most half of them, then rows.
// Throws std::length_error if the rest does not fit.
BatchContent plan_batch(const BatchStory& story, std::size_t bytes);

// Lists what was left out, a sentence each.
std::vector<std::string> list_left_out(const BatchStory& story, const BatchContent& content);

}  // namespace gxrod
