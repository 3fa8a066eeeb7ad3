#include "results/resumable_file.hpp"

#include <unistd.h>

#include <utility>

#include "machine/file_error.hpp"
#include "results/file/guarded_reading.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/file/output_file.hpp"
#include "results/restart/restart_table.hpp"
#include "results/tables/deck_reading.hpp"

namespace gxrod {

namespace {

constexpr const char* failure = "cannot be resumed: ";
constexpr const char* start_again =
    "if its run was stopped before it first wrote, gxrod run --force starts it again";

struct Contents {
    RestartPlace place;
    DeckRecord deck;
    bool is_complete;
};

// Throws std::runtime_error if there is nothing to resume from.
Contents read_contents(const std::filesystem::path& path) {
    const Hdf5Reader file(path);
    if (!file.has_attribute("/", "gxrod_version"))
        throw std::runtime_error("it is not a results file of gxrod");
    std::optional<RestartPlace> place = read_restart(file);
    if (!place) throw std::runtime_error("it has no state to resume from");
    return {*std::move(place), read_deck_record(file), file.text_attribute("/", "status") == "complete"};
}

// Throws FileError if HDF5 crashes or hangs on the file of a run that was killed while it wrote.
void try_contents(const std::filesystem::path& path) {
    read_in_child(path, [&] {
        try {
            read_contents(path);
        } catch (const std::runtime_error&) {
        }
        return std::string();
    });
}

Contents check_contents(const std::filesystem::path& path) {
    const SealState seal = look_at_seal(path);
    if (seal == SealState::missing)
        throw FileError(path,
                        failure + std::string("it is not a results file of gxrod, or of an earlier version"),
                        start_again);
    if (seal == SealState::violated)
        throw FileError(path, failure + describe_doubt(seal), "gxrod run --force starts it again");
    if (seal == SealState::open) try_contents(path);
    try {
        return read_contents(path);
    } catch (const std::runtime_error& error) {
        throw FileError(path, failure + std::string(error.what()), start_again);
    }
}

}  // namespace

ResumableFile::ResumableFile(const std::filesystem::path& path)
    : path_(path), descriptor_(open_output_file(path)) {
    try {
        Contents contents = check_contents(path);
        place_ = std::move(contents.place);
        deck_ = std::move(contents.deck);
        is_complete_ = contents.is_complete;
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

ResumableFile::~ResumableFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

ResumableFile::ResumableFile(ResumableFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      place_(std::move(other.place_)),
      deck_(std::move(other.deck_)),
      is_complete_(other.is_complete_) {}

int ResumableFile::release() { return std::exchange(descriptor_, -1); }

}  // namespace gxrod
