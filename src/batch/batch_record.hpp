#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/cases/case_list.hpp"
#include "deck/problem.hpp"

// The description of a batch in the file batch.json of its folder.
namespace gxrod {

// SHA-256 of each mesh file that the cases of a deck read, by its name in the deck.
using MeshDigests = std::map<std::string, std::string>;
MeshDigests digest_meshes(const std::vector<MeshRecord>& meshes);

struct BatchDeck {
    std::string name;  // as in the plan or the command
    std::string text;
    MeshDigests meshes;
};

struct BatchColumn {
    std::string name;
    std::string description;
};

struct BatchRecord {
    std::string version;  // version of gxrod
    std::string plan;     // file name; "" for a list of decks
    std::string plan_text;
    std::string title;    // title of the first deck
    std::string combine;  // the plan's word, or "decks"
    std::uint64_t seed = 0;
    long cases = 0;
    std::string cases_digest;  // SHA-256 of the overrides of all cases
    std::vector<BatchDeck> decks;
    std::vector<std::string> parameters;
    std::vector<BatchColumn> columns;  // collected values
};

// Makes a record from the title of the first case and the meshes of each deck.
BatchRecord make_batch_record(const Plan& plan,
                              const CaseList& cases,
                              const std::deque<DeckTemplate>& decks,
                              const std::string& title,
                              const std::vector<MeshDigests>& meshes);

// Checks that a plan continues the batch in the folder. Throws DeckError, at the keys of the new plan and
// decks, or FileError if cases, decks, meshes or columns differ. Limits and the choice of kept results may
// differ.
void check_same_batch(const BatchRecord& before,
                      const BatchRecord& now,
                      const Plan& plan,
                      const std::deque<DeckTemplate>& decks,
                      const std::filesystem::path& folder);

// Returns the path of batch.json.
std::filesystem::path record_path(const std::filesystem::path& folder);
bool is_batch_folder(const std::filesystem::path& folder);
// Write and read the record. Throw FileError.
void write_batch_record(const BatchRecord& record, const std::filesystem::path& folder);
BatchRecord read_batch_record(const std::filesystem::path& folder);

}  // namespace gxrod
