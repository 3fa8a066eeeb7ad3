#include "results/resumable_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "machine/file_error.hpp"
#include "results/deck_reading.hpp"
#include "results/find_changes.hpp"
#include "results/output_file.hpp"
#include "results/restart_table.hpp"
#include "results/survey.hpp"

namespace gxrod {

namespace {

constexpr const char* failure = "cannot be resumed: ";
constexpr const char* anew = "if its run was stopped before it first wrote, gxrod run --force begins it anew";

struct Contents {
    RestartPlace place;
    DeckRecord deck;
    bool is_complete;
};

Contents read_contents(const std::filesystem::path& path) {
    survey_file(path);
    std::string reason;
    std::string hint;
    try {
        if (H5Fis_hdf5(path.c_str()) == 0) hint = anew;
        const Hdf5Reader file(path);
        if (!file.has_attribute("/", "gxrod_version")) {
            reason = "it is not a results file of gxrod";
        } else if (std::optional<RestartPlace> place = read_restart(file)) {
            const std::vector<std::string> changes = find_changes(file, *place);
            if (changes.empty()) {
                return {*std::move(place),
                        read_deck_record(file),
                        file.text_attribute("/", "status") == "complete"};
            }
            reason = fmt::format("{}", fmt::join(changes, "; "));
            hint = "gxrod run --force begins it anew";
        } else {
            reason = "it has no state to go on from";
            hint = anew;
        }
    } catch (const std::exception& error) {
        reason = error.what();
    }
    throw FileError(path, failure + reason, hint);
}

}  // namespace

ResumableFile::ResumableFile(const std::filesystem::path& path)
    : path_(path), descriptor_(open_output_file(path)) {
    try {
        Contents contents = read_contents(path);
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
