#pragma once

#include <array>
#include <optional>

#include "results/hdf5_objects.hpp"
#include "results/hdf5_reader.hpp"
#include "state/restart_record.hpp"

namespace gxrod {

// /restart: the state to go on from. It is written into two slots by turns, so that one is always whole;
// /restart@slot names that one. Throws Hdf5Error.
class RestartTable {
  public:
    // Opens or creates the group.
    explicit RestartTable(const Hdf5Handle& root);

    // Writes the slot that is not in use …
    void write(const RestartPlace& place);
    // … which is in use from here on.
    void switch_slot();
    // The checksum of the file's structure, once it and the slot in use are of each other; none before.
    void write_structure_sum(std::uint32_t sum);
    // That of all, once the run has ended.
    void write_end_sum(std::uint32_t sum);

  private:
    Hdf5Handle group_;
    Hdf5Handle slot_attribute_, structure_attribute_, end_attribute_;
    std::int64_t slot_ = -1;  // in use; -1: none
    bool is_written_ = false;
};

// Before anything changes in a file with such a group: then no checksums stand for it.
void clear_file_sums(const Hdf5Handle& root);

// Whether its states are such as this version writes.
bool has_known_form(const Hdf5Reader& file);

// Whether what lies beside their numbers is what this version writes: names, labels, types, headers.
bool has_known_structure(const Hdf5Reader& file);

// Nothing if the file has no whole record. Throws Hdf5Error, and std::runtime_error if it is damaged.
std::optional<RestartPlace> read_restart(const Hdf5Reader& file);

// Checksums of a file that stand beside those of its state; 0 if there is none yet.
struct FileSums {
    std::uint32_t structure = 0;
    std::uint32_t end = 0;
};
FileSums read_file_sums(const Hdf5Reader& file);

}  // namespace gxrod
