#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "deck/problem.hpp"

// What a batch is, as its folder says in batch.json.
namespace gxrod {

// SHA-256 of each mesh file that cases of a deck read, by its name in the deck.
using MeshDigests = std::map<std::string, std::string>;
MeshDigests digest_meshes(const std::vector<MeshRecord>& meshes);

struct BatchDeck {
    std::string name;  // as the plan or the command has it
    std::string text;
    MeshDigests meshes;
};

struct BatchColumn {
    std::string name;
    std::string description;
};

struct BatchRecord {
    std::string version;  // of gxrod
    std::string plan;     // file name; "" for a list of decks
    std::string plan_text;
    std::string title;    // of the first deck
    std::string combine;  // the plan's word, or "decks"
    std::uint64_t seed = 0;
    long cases = 0;
    std::string cases_digest;  // SHA-256 of what differs between them
    std::vector<BatchDeck> decks;
    std::vector<std::string> parameters;
    std::vector<BatchColumn> columns;  // that are collected
};

// `title` is that of the first case, `meshes` are those of each deck.
BatchRecord make_batch_record(const Plan& plan,
                              const CaseList& cases,
                              const std::deque<DeckTemplate>& decks,
                              const std::string& title,
                              const std::vector<MeshDigests>& meshes);

// Throws DeckError, at the keys of the new plan and decks, or FileError, if they do not continue what the
// folder holds: other cases, decks, meshes or columns. Limits and what is kept may differ.
void check_same_batch(const BatchRecord& before,
                      const BatchRecord& now,
                      const Plan& plan,
                      const std::deque<DeckTemplate>& decks,
                      const std::filesystem::path& folder);

// batch.json.
std::filesystem::path record_path(const std::filesystem::path& folder);
bool is_batch_folder(const std::filesystem::path& folder);
// Throw FileError.
void write_batch_record(const BatchRecord& record, const std::filesystem::path& folder);
BatchRecord read_batch_record(const std::filesystem::path& folder);

}  // namespace gxrod
