#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/deck_record.hpp"

namespace gxrod {

// Where the files are that a deck names: next to the deck, or, for a deck from a results file, the bytes that
// are kept with it, in a temporary folder that lives as long as this.
class MeshFiles {
  public:
    explicit MeshFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
    // Throws FileError if there is no space for them.
    explicit MeshFiles(const std::vector<MeshRecord>& records);
    ~MeshFiles();
    MeshFiles(const MeshFiles&) = delete;
    MeshFiles& operator=(const MeshFiles&) = delete;

    // The place of a file as the deck names it; whether there is one in a folder is not asked. Throws
    // FileError if it is not kept, or kept but neither .msh
    // nor .stl.
    std::filesystem::path find(const std::string& file) const;

  private:
    void write(const std::vector<MeshRecord>& records);
    void remove();

    std::filesystem::path folder_;
    bool is_kept_ = false;  // folder_ is a temporary one, or empty
    std::map<std::string, std::filesystem::path> kept_;
};

}  // namespace gxrod
