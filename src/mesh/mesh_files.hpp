#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/deck_record.hpp"

namespace gxrod {

// Finds the files that a deck names: next to the deck, or, for a deck from a results file, as stored bytes,
// in a temporary folder that lives as long as this.
class MeshFiles {
  public:
    explicit MeshFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
    // Throws FileError if there is no space for the files.
    explicit MeshFiles(const std::vector<MeshRecord>& records);
    ~MeshFiles();
    MeshFiles(const MeshFiles&) = delete;
    MeshFiles& operator=(const MeshFiles&) = delete;

    // Returns the path of a file that the deck names, without a check that it exists in a folder. Throws
    // FileError if it is not stored, or stored but neither .msh nor .stl.
    std::filesystem::path find(const std::string& file) const;

  private:
    void write(const std::vector<MeshRecord>& records);
    void remove();

    std::filesystem::path folder_;
    bool is_kept_ = false;  // folder_ is a temporary one, or empty
    std::map<std::string, std::filesystem::path> kept_;
};

}  // namespace gxrod
