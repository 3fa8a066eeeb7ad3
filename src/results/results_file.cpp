#include "results/results_file.hpp"

#include <cassert>
#include <set>
#include <system_error>

#include "machine/file_error.hpp"
#include "results/results_writer.hpp"

namespace gxrod {
const char* name_of(RunStatus status) {
    switch (status) {
        case RunStatus::running:
            return "running";
        case RunStatus::complete:
            return "complete";
        case RunStatus::failed:
            return "failed";
        case RunStatus::interrupted:
            break;
    }
    return "interrupted";
}

namespace {

// Runs a step of writing; its errors become those of the file.
template <class Action>
void writing(const std::filesystem::path& path, Action&& action) {
    try {
        action();
    } catch (const std::system_error& error) {
        throw WriteError(path, "cannot write: " + error.code().message());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw WriteError(path, std::string("cannot write: ") + error.what());
    }
}

[[maybe_unused]] bool has_valid_names(const OutputSettings& output) {
    std::set<std::string> names{"time"};
    for (const HistoryRequest& history : output.histories) {
        if (history.name.empty() || history.name.find('/') != std::string::npos) return false;
        if (!names.insert(history.name).second) return false;
    }
    return true;
}

}  // namespace

ResultsFile::ResultsFile(const ResultsFileOptions& options,
                         const DeckRecord& deck,
                         const Model& model,
                         const OutputSettings& output)
    : path_(options.path) {
    assert(has_valid_names(output));
    const int descriptor = create_output_file(path_, options.existing);
    try {
        writing(path_, [&] { writer_ = std::make_unique<ResultsWriter>(descriptor, deck, model, output); });
    } catch (...) {
        remove_output_file(path_);
        throw;
    }
}

ResultsFile::ResultsFile(const DeckRecord& deck,
                         const Model& model,
                         const OutputSettings& output,
                         ResumableFile file)
    : path_(file.path()) {
    assert(has_valid_names(output));
    writing(path_, [&] { writer_ = std::make_unique<ResultsWriter>(std::move(file), deck, model, output); });
}

ResultsFile::~ResultsFile() = default;

void ResultsFile::record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver) {
    writing(path_, [&] { writer_->record_step(snapshot, ledger, solver); });
}

void ResultsFile::write_frame(const Snapshot& snapshot) {
    writing(path_, [&] { writer_->write_frame(snapshot); });
}

bool ResultsFile::is_sound() const { return writer_->is_sound(); }

bool ResultsFile::is_flush_due() const { return writer_->is_flush_due(); }

void ResultsFile::set_restart(RestartRecord record) {
    writing(path_, [&] { writer_->set_restart(std::move(record)); });
}

void ResultsFile::flush() {
    writing(path_, [&] { writer_->flush(); });
}

void ResultsFile::close(RunStatus status,
                        const std::string& reason,
                        std::span<const std::int64_t> reason_nodes,
                        const std::string& warnings) {
    writing(path_, [&] { writer_->close(name_of(status), reason, reason_nodes, warnings); });
    if (!writer_->is_at(path_)) {
        throw FileError(path_, "was moved while the run wrote it", "it is complete, under its new name");
    }
}

}  // namespace gxrod
