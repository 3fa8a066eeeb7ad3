#include "mesh/mesh_files.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "machine/file_error.hpp"
#include "machine/temporary_folder.hpp"
#include "mesh/triangles/triangle_file.hpp"

namespace gxrod {

namespace fs = std::filesystem;

MeshFiles::MeshFiles(const std::vector<MeshRecord>& records) : is_kept_(true) {
    if (records.empty()) return;
    folder_ = make_temporary_folder("mesh");
    try {
        write(records);
    } catch (...) {
        remove();
        throw;
    }
}

MeshFiles::~MeshFiles() { remove(); }

// Each in a folder of its own: two can have the same name, and Gmsh finds the format by the name.
void MeshFiles::write(const std::vector<MeshRecord>& records) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        const fs::path path = folder_ / std::to_string(i) / fs::path(records[i].file).filename();
        fs::create_directory(path.parent_path());
        std::ofstream stream(path, std::ios::binary);
        stream.write(records[i].bytes.data(), static_cast<std::streamsize>(records[i].bytes.size()));
        stream.close();
        if (!stream) throw FileError(path, "cannot be written", std::generic_category().message(errno));
        kept_[records[i].file] = path;
    }
}

void MeshFiles::remove() {
    std::error_code ignored;
    if (is_kept_ && !folder_.empty()) fs::remove_all(folder_, ignored);
}

// A geometry script can run commands; whose results these are is not known.
fs::path MeshFiles::find(const std::string& file) const {
    if (!is_kept_) return folder_ / file;
    if (fs::path(file).extension() != ".msh" && !is_stl(file)) {
        throw FileError(file,
                        "is a geometry script, which is not run from a results file",
                        "give the deck that it belongs to");
    }
    const auto found = kept_.find(file);
    if (found == kept_.end()) throw FileError(file, "is not kept in the results file");
    return found->second;
}

}  // namespace gxrod
