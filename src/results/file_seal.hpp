#pragma once

#include <cstdint>

#include "results/hdf5_objects.hpp"
#include "results/hdf5_reader.hpp"

// A results file's seal: the checksum of all its bytes but its own, /restart/checksum_of_file.
namespace gxrod {

inline const DatasetLabel seal_label{"checksum_of_file",
                                     "of all bytes of the file but these eight; -1 while it is being changed",
                                     "none",
                                     "1"};

// Its place in the file, by the group /restart. Throws Hdf5Error, and std::runtime_error if it has none.
std::uint64_t find_seal(const Hdf5Handle& restart);

// `kept`: the file is, to the bit, the one that was sealed; `violated`: it is not. One whose writer was
// killed while it changed the file is `broken`, which says nothing of its bits.
enum class SealState { kept, violated, broken };
// Reads the whole file. Throws like Hdf5Reader, and std::system_error.
SealState look_at_seal(const Hdf5Reader& file);

}  // namespace gxrod
