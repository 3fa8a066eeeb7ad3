#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "deck/text/deck_tree.hpp"
#include "mesh/mesh_files.hpp"
#include "model/problem.hpp"

// Turns the text of a deck into a problem to run. docs/deck.md is the reference of the text.
namespace gxrod {

// Reads a deck. `overrides` are the "KEY=VALUE" of --set, applied in their order. Throws DeckError if the
// deck is wrong and FileError if it cannot be read.
Problem read_problem(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {});

// Reads a deck from a text; faults name `file`, and meshes are relative to its folder.
Problem read_problem_text(std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides = {});

// A deck that is read once and built many times, each time with other overrides.
class DeckTemplate {
  public:
    // Throws DeckError if the text is not TOML, and FileError if it cannot be read.
    explicit DeckTemplate(const std::filesystem::path& deck);
    // Reads a deck from a text; faults name `file`, and meshes are relative to its folder.
    DeckTemplate(std::string text, const std::filesystem::path& file);

    // Builds the deck as read_problem does; one that is only a variation of another one, which is built so,
    // without the record's text and sweeps.
    Problem build(const std::vector<std::string>& overrides, bool is_varied = false) const;

    const std::string& file() const { return file_; }  // the file as the user named it
    const std::string& text() const { return text_; }
    const DeckNode& tree() const { return tree_; }

  private:
    std::string file_;
    std::string text_;
    DeckNode tree_;
    MeshFiles meshes_;
};

// Reads the problem that resumes a run of `before` where it stopped: its own deck, or the one in the file
// `deck`, with overrides. Throws DeckError with each key that differs but must not
// (deck/text/resumption.hpp).
Problem read_resumption(const DeckRecord& before,
                        const std::filesystem::path& deck,
                        const std::vector<std::string>& overrides);

// Rebuilds the problem of results, with the meshes that are kept in them. Throws DeckError if the deck is not
// valid with this version or these overrides.
Problem rebuild_problem(const DeckRecord& record, const std::vector<std::string>& overrides = {});

}  // namespace gxrod
