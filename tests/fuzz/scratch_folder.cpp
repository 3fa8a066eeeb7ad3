#include "fuzz/scratch_folder.hpp"

#include <stdlib.h>

#include <fstream>
#include <stdexcept>

namespace gxrod::fuzz {

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gxrod_fuzz_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    // A new file: what HDF5 could not close still holds the lock of the one before.
    std::filesystem::remove(path);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
    return path;
}

}  // namespace gxrod::fuzz
