#pragma once

#include <filesystem>
#include <fstream>

#include "results/file_seal.hpp"
#include "results/ordered_file.hpp"

namespace gxrod::test {

// As if its writer had been killed while it changed the file: then the checksum of all of its bytes tells
// nothing, and what else is looked at has to.
inline void break_seal(const std::filesystem::path& path) {
    const std::uint64_t place = [&] {
        const Hdf5Reader file(path);
        return find_seal(Hdf5Handle(H5Gopen2(file.id(), "restart", H5P_DEFAULT), H5Gclose, "opening"));
    }();
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(place));
    file.write(reinterpret_cast<const char*>(&broken_seal), sizeof(broken_seal));
}

}  // namespace gxrod::test
