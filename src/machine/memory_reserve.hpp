#pragma once

#include <cstddef>

namespace gxrod {

// HDF5 can crash if an allocation of its own fails. So it is only called if there is memory for the data that
// the caller passes and, in addition, for these bytes.
inline constexpr std::size_t hdf5_reserve = std::size_t{4} << 20;

// Throws std::bad_alloc if the process cannot have so many bytes more.
void require_memory(std::size_t bytes);

}  // namespace gxrod
