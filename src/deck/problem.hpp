#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "deck/text/deck_tree.hpp"
#include "mesh/mesh_files.hpp"
#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

// From the text of a deck to what is run. docs/deck.md is the reference of the text.
namespace gxrod {

// A deck, read, checked and built.
struct Problem {
    DeckRecord record;
    Model model;                    // with what acts in the first stage
    AnalysisSettings analysis;      // of the first stage
    std::vector<StagePlan> stages;  // one at least
    OutputSettings output;
    std::vector<std::string> notes;  // choices that the reader made for the user, a line each
};

// Reads a deck. `overrides` are the "KEY=VALUE" of --set, applied in their order. Throws DeckError if the
// deck is wrong and FileError if it cannot be read.
Problem read_problem(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {});

// The same for a text; `file` is what faults name, and meshes are relative to its folder.
Problem read_problem_text(std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides = {});

// A deck that is read once and built many times, each time with other overrides.
class DeckTemplate {
  public:
    // Throws DeckError if the text is not TOML, and FileError if it cannot be read.
    explicit DeckTemplate(const std::filesystem::path& deck);
    // The same for a text; `file` is what faults name, and meshes are relative to its folder.
    DeckTemplate(std::string text, const std::filesystem::path& file);

    // As read_problem does.
    Problem build(const std::vector<std::string>& overrides) const;

    const std::string& file() const { return file_; }  // as the user named it
    const std::string& text() const { return text_; }
    const DeckNode& tree() const { return tree_; }

  private:
    std::string file_;
    std::string text_;
    DeckNode tree_;
    MeshFiles meshes_;
};

// The problem that resumes where a run of `before` stopped: its own deck, or the one in the file `deck`, with
// overrides. Throws DeckError that names each key that must not differ but does
// (deck/text/resumption.hpp).
Problem read_resumption(const DeckRecord& before,
                        const std::filesystem::path& deck,
                        const std::vector<std::string>& overrides);

// The problem that results came from, with the meshes that are kept with them. Throws DeckError if the deck
// is not valid with this version or these overrides.
Problem rebuild_problem(const DeckRecord& record, const std::vector<std::string>& overrides = {});

}  // namespace gxrod
