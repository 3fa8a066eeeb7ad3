#pragma once

#include <filesystem>
#include <string>

#include "batch/plan/plan.hpp"

// Small plans that tests change, and what the reader says of them.
namespace gxrod::test {

// An empty folder, gone with this object.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    // Writes a file and returns its path.
    std::filesystem::path write(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

// A cantilever of two elements whose end is pulled sideways in two load steps; history "tip" has position and
// quaternion.
extern const std::string cantilever_deck;

// A plan next to the deck "deck.toml", by default the cantilever.
class PlanFiles {
  public:
    explicit PlanFiles(const std::string& plan, const std::string& deck = cantilever_deck);

    const std::filesystem::path& folder() const { return folder_.path(); }
    Plan read() const { return read_plan(folder() / "plan.toml"); }
    void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    // All faults of the plan and of its cases, a line each, without the folder; "" if there are none.
    std::string faults() const;

  private:
    ScratchFolder folder_;
};

}  // namespace gxrod::test
