#include "report/batch_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "machine/digest.hpp"
#include "report/case_pages.hpp"
#include "report/script_json.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

// Each text once, numbered as they come.
class Texts {
  public:
    std::size_t place(const std::string& text) {
        const auto [found, is_new] = places_.try_emplace(text, places_.size());
        if (is_new) list_.push_back(text);
        return found->second;
    }
    const Json& list() const { return list_; }

  private:
    std::map<std::string, std::size_t> places_;
    Json list_ = Json::array();
};

std::size_t status_place(CaseStatus status) {
    return static_cast<std::size_t>(std::ranges::find(case_statuses, status) - case_statuses.begin());
}

// All cases that have ended, whether or not their rows are in the page.
void add_counts(const std::vector<CaseRow>& rows, Json& json) {
    std::array<std::size_t, case_statuses.size()> counts{};
    double seconds = 0.0;
    std::size_t warned = 0;
    for (const CaseRow& row : rows) {
        ++counts.at(status_place(row.status));
        seconds += row.seconds;
        warned += row.warning.empty() ? 0 : 1;
    }
    json["finished"] = rows.size();
    json["counts"] = counts;
    json["seconds"] = seconds;
    json["warned"] = warned;
    json["statuses"] = Json::array();
    for (const CaseStatus status : case_statuses) json["statuses"].push_back(name_of(status));
}

Json describe_columns(const BatchRecord& record) {
    Json columns = Json::array();
    for (const BatchColumn& column : record.columns) {
        columns.push_back({{"name", column.name}, {"description", column.description}});
    }
    return columns;
}

Json describe_decks(const BatchRecord& record, std::size_t count) {
    Json decks = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        const BatchDeck& deck = record.decks[i];
        decks.push_back({{"name", deck.name}, {"sha256", sha256_hex(deck.text)}, {"text", deck.text}});
    }
    return decks;
}

// One array of each thing that `of` gives for a row.
template <class Of>
Json make_column(const BatchStory& story, std::size_t count, Of&& of) {
    Json column = Json::array();
    for (std::size_t i = 0; i < count; ++i) column.push_back(of((*story.rows)[i]));
    return column;
}

Json describe_rows(const BatchStory& story, std::size_t count, Texts& texts) {
    const auto column = [&](auto&& of) { return make_column(story, count, of); };
    Json json;
    json["case"] = column([](const CaseRow& row) { return row.number; });
    json["status"] = column([](const CaseRow& row) { return status_place(row.status); });
    json["reason"] = column([&](const CaseRow& row) { return texts.place(row.reason); });
    json["warning"] = column([&](const CaseRow& row) { return texts.place(row.warning); });
    json["parameters"] = Json::array();
    for (std::size_t i = 0; i < story.record->parameters.size(); ++i) {
        json["parameters"].push_back(column([&](const CaseRow& row) { return row.parameters.at(i); }));
    }
    json["collected"] = Json::array();
    for (std::size_t i = 0; i < story.record->columns.size(); ++i) {
        json["collected"].push_back(column([&](const CaseRow& row) { return row.collected.at(i); }));
    }
    json["time"] = column([](const CaseRow& row) { return row.time; });
    json["steps"] = column([](const CaseRow& row) { return row.steps; });
    json["newton_iterations"] = column([](const CaseRow& row) { return row.newton_iterations; });
    json["rejected_steps"] = column([](const CaseRow& row) { return row.rejected_steps; });
    json["seconds"] = column([](const CaseRow& row) { return row.seconds; });
    return json;
}

std::size_t count_bytes(const BatchStory& story, const BatchContent& content) {
    return write_script_json(describe_batch(story, content)).size();
}

// The largest number up to `most` for which `fits` is true; 0 if there is none. If a number fits, smaller
// ones do. Tries at most about twice what fits, so that nothing much larger is ever made.
template <class Fits>
std::size_t find_most(std::size_t most, Fits&& fits) {
    std::size_t good = 0, bad = std::min<std::size_t>(most, 1000);
    while (fits(bad)) {
        if (bad == most) return most;
        good = bad;
        bad = std::min(most, 2 * bad);
    }
    while (bad - good > 1) {
        const std::size_t middle = good + (bad - good) / 2;
        (fits(middle) ? good : bad) = middle;
    }
    return good;
}

}  // namespace

Json describe_batch(const BatchStory& story, const BatchContent& content) {
    const BatchRecord& record = *story.record;
    Json json;
    json["gxrod_version"] = record.version;
    json["folder"] = story.folder;
    json["plan"] = record.plan;
    json["plan_text"] = record.plan_text;
    json["title"] = record.title;
    json["combine"] = record.combine;
    json["seed"] = record.seed;
    json["cases"] = record.cases;
    add_counts(*story.rows, json);
    json["parameters"] = record.parameters;
    json["columns"] = describe_columns(record);
    json["decks"] = describe_decks(record, content.decks);
    Texts texts;
    json["rows"] = describe_rows(story, content.rows, texts);
    json["texts"] = texts.list();
    const std::string name = case_page_name(0, record.cases);
    json["pages"] = {{"folder", story.pages}, {"width", name.find('.')}, {"cases", story.cases_with_page}};
    json["left_out"] = list_left_out(story, content);
    json["budget_megabytes"] = static_cast<double>(story.most_bytes) / 1e6;
    return json;
}

BatchContent plan_batch(const BatchStory& story, std::size_t bytes) {
    const std::size_t bare = count_bytes(story, {});
    if (bare > bytes) throw std::length_error("no room for rows");
    BatchContent content;
    const std::size_t half = bare + (bytes - bare) / 2;
    content.decks = find_most(story.record->decks.size(), [&](std::size_t decks) {
        return count_bytes(story, {0, decks}) <= half;
    });
    content.rows = find_most(story.rows->size(), [&](std::size_t rows) {
        return count_bytes(story, {rows, content.decks}) <= bytes;
    });
    return content;
}

std::vector<std::string> list_left_out(const BatchStory& story, const BatchContent& content) {
    std::vector<std::string> sentences;
    const std::size_t rows = story.rows->size();
    const std::size_t decks = story.record->decks.size();
    if (content.rows < rows) {
        sentences.push_back(
            fmt::format("Of {} cases that have ended, the page has the first {}.", rows, content.rows));
    }
    if (content.decks < decks) {
        sentences.push_back(
            fmt::format("Of {} decks, the page has the texts of the first {}.", decks, content.decks));
    }
    return sentences;
}

}  // namespace gxrod
