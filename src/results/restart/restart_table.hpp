#pragma once

#include <optional>

#include "results/file/hdf5_objects.hpp"
#include "results/file/hdf5_reader.hpp"
#include "state/records/restart_record.hpp"

namespace gxrod {

// /restart: the state from which to resume. It is written into two slots in turn, so that one is always
// whole; /restart@slot names the whole one. Throws Hdf5Error.
class RestartTable {
  public:
    // Opens or creates the group.
    explicit RestartTable(const Hdf5Handle& root);

    // Writes the slot that is not in use.
    void write(const RestartPlace& place);
    // Puts the slot that was written last in use.
    void switch_slot();

  private:
    Hdf5Handle group_;
    Hdf5Handle slot_attribute_;
    std::int64_t slot_ = -1;  // in use; -1: none
    bool is_written_ = false;
};

// Reads the record; nullopt if the file has no complete one. Throws Hdf5Error, and std::runtime_error if it
// is damaged.
std::optional<RestartPlace> read_restart(const Hdf5Reader& file);

}  // namespace gxrod
