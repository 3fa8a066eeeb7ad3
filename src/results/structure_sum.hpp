#pragma once

#include <hdf5.h>

#include <cstdint>

#include "state/restart_record.hpp"

namespace gxrod {

// The checksum of what a results file has beside rows that grow and /restart: names of all objects, their
// types and attributes, and what is written once. Left out is what changes while a run goes on: the status
// with its reason, and the number of frames. Never 0. Throws Hdf5Error, and std::runtime_error where
// something is none of what gxrod writes.
std::uint32_t sum_structure(hid_t root);

// The checksum of what is left out above, and of all rows, when a run has ended. Never 0.
std::uint32_t sum_end(hid_t root, const PlaceSums& rows);

}  // namespace gxrod
