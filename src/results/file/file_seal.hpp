#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

// The seal of a results file: the checksum of all bytes after the first 512, which hold the seal itself (a
// "user block" of HDF5). It is read without HDF5, before HDF5 reads anything.
namespace gxrod {

inline constexpr std::size_t seal_block_bytes = 512;
using SealBlock = std::array<std::byte, seal_block_bytes>;

struct FileSeal {
    bool is_open = true;      // the file is being changed, or was when its writer was killed
    std::uint64_t bytes = 0;  // size of the file when it was sealed
    std::uint32_t sum = 0;    // checksum of these bytes, as in PageSums
};

SealBlock write_seal(const FileSeal& seal);
// Reads a seal; nullopt unless write_seal makes exactly these bytes.
std::optional<FileSeal> read_seal(const SealBlock& block);
// Returns whether a block at least begins like a seal.
bool begins_like_seal(const SealBlock& block);

// `kept`: the file is, to the bit, as it was sealed; `violated`: it is not; `open`: its bits are not known;
// `missing`: another program or an earlier version wrote it.
enum class SealState { kept, violated, open, missing };
// Reads the whole file and checks its seal. If another process writes meanwhile, the result is `kept` or
// `open`. Throws std::system_error.
SealState look_at_seal(const std::filesystem::path& path);

}  // namespace gxrod
