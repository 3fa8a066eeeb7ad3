#include "batch/batch_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "batch/batch_folder.hpp"
#include "batch/cases/case_table.hpp"
#include "batch/collector.hpp"
#include "deck/rods/imperfections.hpp"
#include "deck/text/csv_reading.hpp"
#include "deck/text/deck_comparison.hpp"
#include "deck/text/text_file.hpp"
#include "machine/digest.hpp"
#include "machine/file_error.hpp"
#include "model/version.hpp"

namespace gxrod {
namespace {

using Json = nlohmann::ordered_json;

std::string digest_cases(const CaseList& cases) {
    std::string all;
    for (long number = 1; number <= cases.count(); ++number) {
        for (const std::string& text : cases.overrides(number)) all += text + "\n";
        all += "\n";
    }
    return sha256_hex(all);
}

bool have_same_cases(const BatchRecord& before, const BatchRecord& now) {
    const auto same_column = [](const BatchColumn& a, const BatchColumn& b) {
        return a.name == b.name && a.description == b.description;
    };
    return before.cases == now.cases && before.cases_digest == now.cases_digest &&
           before.parameters == now.parameters && before.decks.size() == now.decks.size() &&
           std::ranges::equal(before.columns, now.columns, same_column);
}

std::string hint_for(const std::filesystem::path& folder) {
    return fmt::format("; -o starts another batch, --force restarts {}", folder.string());
}

// Of those that both have: a slice reads the meshes of its own cases.
void check_same_meshes(const MeshDigests& before,
                       const MeshDigests& now,
                       const std::string& deck,
                       const std::filesystem::path& folder) {
    for (const auto& [file, digest] : now) {
        const auto earlier = before.find(file);
        if (earlier == before.end() || earlier->second == digest) continue;
        throw FileError(deck,
                        fmt::format("its mesh {} is another one than that of the batch in {}{}",
                                    file,
                                    folder.string(),
                                    hint_for(folder)));
    }
}

// Where the plans' texts are the same, but not their cases.
[[noreturn]] void refuse(const std::filesystem::path& folder,
                         const BatchRecord& before,
                         const BatchRecord& now) {
    if (before.combine == "decks" || now.combine == "decks")
        throw FileError(folder, "holds a batch of other decks" + hint_for(folder));
    std::string reason = "the plan's values are written in another way";
    if (before.version != now.version) reason = fmt::format("gxrod {} made them", before.version);
    if (before.combine == "table") reason = "the plan's table has changed";
    if (before.parameters != now.parameters) reason = "[vary] has its keys in another order";
    if (before.cases_digest == now.cases_digest) reason = "[collect] has its columns in another order";
    throw FileError(folder, "holds a batch of other cases: " + reason + hint_for(folder));
}

}  // namespace

MeshDigests digest_meshes(const std::vector<MeshRecord>& meshes) {
    MeshDigests digests;
    for (const MeshRecord& mesh : meshes) {
        // Shapes that each case finds are no files.
        if (!mesh.file.starts_with(found_shape_prefix)) digests.emplace(mesh.file, sha256_hex(mesh.bytes));
    }
    return digests;
}

BatchRecord make_batch_record(const Plan& plan,
                              const CaseList& cases,
                              const std::deque<DeckTemplate>& decks,
                              const std::string& title,
                              const std::vector<MeshDigests>& meshes) {
    BatchRecord record;
    record.version = version;
    record.plan = std::filesystem::path(plan.file).filename().string();
    record.plan_text = plan.text;
    record.title = title;
    record.combine =
        plan.combination == Combination::decks ? "decks" : word_of(combination_choices, plan.combination);
    record.seed = plan.seed;
    record.cases = cases.count();
    record.cases_digest = digest_cases(cases);
    for (std::size_t i = 0; i < decks.size(); ++i)
        record.decks.push_back({decks[i].file(), decks[i].text(), meshes[i]});
    record.parameters = cases.parameter_names();
    for (const Collection& collection : plan.collections)
        record.columns.push_back({collection.name, describe(collection)});
    return record;
}

void check_same_batch(const BatchRecord& before,
                      const BatchRecord& now,
                      const Plan& plan,
                      const std::deque<DeckTemplate>& decks,
                      const std::filesystem::path& folder) {
    const ComparisonRules in_plan{{"time_limit", "memory_limit", "keep"},
                                  fmt::format("the batch in {} has ", folder.string())};
    const ComparisonRules in_deck{{"title", "units"}, in_plan.before_has};
    std::vector<DeckFault> differences;
    const auto compare = [&](const std::string& text,
                             const DeckNode& tree,
                             const std::string& file,
                             const ComparisonRules& rules) {
        FaultList faults(file, {});
        compare_decks(read_toml(text, file), tree, rules, faults);
        const std::vector<DeckFault> found = faults.list();
        differences.insert(differences.end(), found.begin(), found.end());
    };
    if (before.plan.empty() != now.plan.empty()) {
        throw FileError(
            folder,
            (before.plan.empty() ? "holds a batch of decks, not of a plan"
                                 : "holds a batch of the plan " + before.plan + ", not of decks") +
                hint_for(folder));
    }
    if (!have_same_cases(before, now)) {
        compare(before.plan_text, plan.tree, plan.file, in_plan);
        if (differences.empty()) refuse(folder, before, now);
    }
    for (std::size_t i = 0; i < std::min(decks.size(), before.decks.size()); ++i) {
        const BatchDeck& deck = before.decks[i];
        if (deck.text != decks[i].text()) compare(deck.text, decks[i].tree(), decks[i].file(), in_deck);
        check_same_meshes(deck.meshes, now.decks[i].meshes, decks[i].file(), folder);
    }
    if (differences.empty()) return;
    differences.push_back({folder.string(), 0, 0, "", "holds another batch" + hint_for(folder)});
    throw DeckError(std::move(differences));
}

std::filesystem::path record_path(const std::filesystem::path& folder) { return folder / "batch.json"; }

bool is_batch_folder(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(record_path(folder), ignored);
}

void write_batch_record(const BatchRecord& record, const std::filesystem::path& folder) {
    Json json{{"gxrod_version", record.version},
              {"plan", record.plan},
              {"plan_text", record.plan_text},
              {"title", record.title},
              {"combine", record.combine},
              {"seed", record.seed},
              {"cases", record.cases},
              {"cases_sha256", record.cases_digest}};
    json["decks"] = Json::array();
    for (const BatchDeck& deck : record.decks) {
        json["decks"].push_back({{"name", deck.name},
                                 {"sha256", sha256_hex(deck.text)},
                                 {"text", deck.text},
                                 {"meshes_sha256", deck.meshes}});
    }
    json["parameters"] = record.parameters;
    json["columns"] = Json::array();
    for (const BatchColumn& column : record.columns)
        json["columns"].push_back({{"name", column.name}, {"description", column.description}});
    replace_file(record_path(folder), json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

BatchRecord read_batch_record(const std::filesystem::path& folder) {
    const std::filesystem::path path = record_path(folder);
    const std::string text = read_text_file(path);
    try {
        const Json json = Json::parse(text);
        BatchRecord record;
        json.at("gxrod_version").get_to(record.version);
        json.at("plan").get_to(record.plan);
        json.at("plan_text").get_to(record.plan_text);
        json.at("title").get_to(record.title);
        json.at("combine").get_to(record.combine);
        json.at("seed").get_to(record.seed);
        json.at("cases").get_to(record.cases);
        json.at("cases_sha256").get_to(record.cases_digest);
        for (const Json& deck : json.at("decks"))
            record.decks.push_back(
                {deck.at("name"), deck.at("text"), deck.at("meshes_sha256").get<MeshDigests>()});
        json.at("parameters").get_to(record.parameters);
        for (const Json& column : json.at("columns"))
            record.columns.push_back({column.at("name"), column.at("description")});
        return record;
    } catch (const Json::exception& error) {
        throw FileError(path, std::string("is no record of a batch: ") + error.what());
    }
}

}  // namespace gxrod
