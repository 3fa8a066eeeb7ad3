#include "results/results_file.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <stdexcept>
#include <system_error>

#include "machine/file_error.hpp"
#include "machine/memory_reserve.hpp"
#include "results/file/ordered_driver.hpp"
#include "results/outline_table.hpp"
#include "results/provenance.hpp"
#include "results/results_tables.hpp"
#include "results/shape_file.hpp"

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

using namespace std::chrono_literals;

constexpr auto flush_interval = 200ms;
constexpr std::size_t most_buffered_bytes = std::size_t{16} << 20;

// Runs a step of writing; its errors become WriteError.
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

// What HDF5 can keep of a frame: two chunks of each field.
std::size_t count_frame_bytes(const Model& model) {
    constexpr std::size_t fields = 14;
    return fields * std::min(model.nodes.size() * sizeof(Vec3), 2 * most_chunk_bytes);
}

[[maybe_unused]] bool has_valid_names(const OutputSettings& output) {
    std::set<std::string> names{"time", "stage", "load_factor", "limit_load_factor", "branch"};
    for (const HistoryRequest& history : output.histories) {
        if (history.name.empty() || history.name.find('/') != std::string::npos) return false;
        if (!names.insert(history.name).second) return false;
    }
    return true;
}

void check_name(const OrderedFile& file) {
    if (!file.has_name()) throw std::runtime_error("it was removed while the run wrote it");
}

}  // namespace

// The file as HDF5 has it open.
struct ResultsFile::Hdf5File {
    Hdf5File(OrderedFile& ordered, Hdf5Handle (*open)(OrderedFile&)) : file(ordered) {
        require_memory(2 * hdf5_reserve);  // for the library and for the tables
        hdf5 = open(file);
        root = Hdf5Handle(H5Gopen2(hdf5.id(), "/", H5P_DEFAULT), H5Gclose, "opening the root");
    }
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    void commit(OrderedFile::Order order = OrderedFile::Order::growing) const {
        check_hdf5(H5Fflush(hdf5.id(), H5F_SCOPE_LOCAL), "flushing");
        file.commit(order);
    }
    void close() {
        check_hdf5(root.reset(), "closing the root");
        check_hdf5(hdf5.reset(), "closing the file");
        file.commit();
    }

    OrderedFile& file;
    Hdf5Handle hdf5, root;
};

ResultsFile::ResultsFile(const ResultsFileOptions& options,
                         const DeckRecord& deck,
                         const Model& model,
                         const OutputSettings& output)
    : path_(options.path), frame_bytes_(count_frame_bytes(model)) {
    assert(has_valid_names(output));
    const int descriptor = create_output_file(path_, options.existing);
    try {
        writing(path_, [&] {
            take_over(descriptor);
            hdf5_ = std::make_unique<Hdf5File>(*file_, create_hdf5);
            write_provenance(hdf5_->root, deck);
            open_tables(deck, model, output, {});
            file_->seal();
        });
    } catch (...) {
        remove_output_file(path_);
        throw;
    }
    next_flush_ = Clock::now() + flush_interval;
}

ResultsFile::ResultsFile(const DeckRecord& deck,
                         const Model& model,
                         const OutputSettings& output,
                         ResumableFile file)
    : path_(file.path()), frame_bytes_(count_frame_bytes(model)) {
    assert(has_valid_names(output));
    writing(path_, [&] { resume(deck, model, output, file); });
    next_flush_ = Clock::now() + flush_interval;
}

ResultsFile::~ResultsFile() {
    if (!tables_ || !is_sound_) return;
    try {
        flush();
        close_hdf5();
        file_->seal();
    } catch (...) {
        // The file on disk stays as it was last written. Closing HDF5 needs no disk.
    }
}

void ResultsFile::take_over(int descriptor) {
    file_ = std::make_shared<OrderedFile>(descriptor);
    const auto abandon = [](OrderedFile* file) { file->abandon(); };
    abandonment_ = std::shared_ptr<void>(file_.get(), abandon);
}

void ResultsFile::open_tables(const DeckRecord& deck,
                              const Model& model,
                              const OutputSettings& output,
                              const RowCounts& after) {
    tables_ = std::make_unique<ResultsTables>(
        hdf5_->root, deck, model, output, ResultsTables::Rows{after.steps, after.frames, after.samples});
    hdf5_->commit();
}

void ResultsFile::resume(const DeckRecord& deck,
                         const Model& model,
                         const OutputSettings& output,
                         ResumableFile& file) {
    const RowCounts after{file.place().steps, file.place().frames, file.place().samples};
    take_over(file.release());
    hdf5_ = std::make_unique<Hdf5File>(*file_, open_hdf5);
    open_tables(deck, model, output, after);
    tables_->trim_times();
    hdf5_->commit(OrderedFile::Order::shrinking);
    tables_->flush_frame_count();
    hdf5_->commit();
    // Compressed frames would overwrite those on disk, which a kill in between would tear. HDF5 must not
    // reuse the space that becomes free either, so the file is closed: HDF5 then forgets it.
    tables_->trim();
    tables_->remove_stages_after(file.place().record.stage);
    hdf5_->commit(OrderedFile::Order::shrinking);
    close_hdf5();
    hdf5_ = std::make_unique<Hdf5File>(*file_, open_hdf5);
    write_resumption(hdf5_->root, file.deck(), deck);
    open_tables(deck, model, output, after);
    file_->seal();
}

// After an exception, what is half done must never be written: rows of some tables only, for example.
template <class Action>
void ResultsFile::attempt(std::size_t bytes, Action&& action) {
    assert(tables_ && is_sound_);
    is_sound_ = false;
    writing(path_, [&] {
        if (bytes > 0) require_memory(bytes);
        action();
    });
    is_sound_ = true;
}

const StressTable* ResultsFile::stresses() const { return tables_ ? tables_->stresses() : nullptr; }

void ResultsFile::write_outlines(const Model& model, std::span<const BodyOutline> outlines) {
    attempt(hdf5_reserve, [&] {
        write_outline_table(hdf5_->root, model, outlines);
        hdf5_->commit();
    });
}

void ResultsFile::begin_stage(const StagePlace& stage) {
    attempt(hdf5_reserve, [&] { tables_->begin_stage(stage); });
}

void ResultsFile::write_shapes(const StagePlace& stage,
                               const DeckRecord& deck,
                               const Model& model,
                               std::span<const NodeMotion> equilibrium,
                               const ShapesRecord& record) {
    const std::vector<const Shape*> shapes = list_shapes_of(record);
    const std::vector<double> scales = find_shape_scales(model, shapes);
    attempt(hdf5_reserve, [&] { tables_->write_shapes(stage, model, record, scales); });
    if (shapes.empty()) return;
    const auto equilibria = list_equilibria_of(record, equilibrium);
    write_shape_file(shape_file_path(path_, stage.name),
                     deck,
                     model,
                     equilibria,
                     shapes,
                     scales,
                     list_imaginary_parts(record));
}

void ResultsFile::write_paths(const StagePlace& stage,
                              const DeckRecord& deck,
                              const Model& model,
                              const PathRecord& paths) {
    attempt(hdf5_reserve, [&] { tables_->write_paths(stage, paths); });
    std::vector<Shape> shapes;
    std::vector<std::span<const NodeMotion>> equilibria;
    for (const FollowedPath& path : paths) {
        for (const CriticalPoint& point : path.points) {
            for (const std::vector<Vec6>& nodes : point.kernel) {
                shapes.push_back({nodes, {}, point.shape});
                equilibria.emplace_back(point.nodes);
            }
        }
    }
    if (shapes.empty()) return;
    std::vector<const Shape*> listed;
    for (const Shape& shape : shapes) listed.push_back(&shape);
    const std::vector<double> scales = find_shape_scales(model, listed);
    write_shape_file(shape_file_path(path_, stage.name), deck, model, equilibria, listed, scales);
}

void ResultsFile::record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver) {
    // Only gathers rows in memory; HDF5 is not called.
    attempt(0, [&] { tables_->append_step(snapshot, ledger, solver); });
}

void ResultsFile::record_sample(const Snapshot& snapshot) {
    attempt(0, [&] { tables_->append_sample(snapshot); });
}

void ResultsFile::note_interpolant(const std::string& words) {
    attempt(hdf5_reserve, [&] {
        const hid_t root = hdf5_->root.id();
        if (H5Aexists(root, "interpolation") <= 0) {
            write_attribute(root, "interpolation", words);
        } else if (read_text_attribute(root, "interpolation") != words) {
            rewrite_attribute(root, "interpolation", words);
        }
    });
}

void ResultsFile::write_frame(const Snapshot& snapshot) {
    attempt(hdf5_reserve + frame_bytes_, [&] { tables_->append_frame(snapshot); });
}

bool ResultsFile::is_flush_due() const {
    return Clock::now() >= next_flush_ || tables_->buffered_bytes() > most_buffered_bytes;
}

void ResultsFile::set_restart(RestartRecord record) {
    attempt(hdf5_reserve, [&] { tables_->set_restart(std::move(record)); });
}

void ResultsFile::flush() {
    const auto start = Clock::now();
    attempt(hdf5_reserve + tables_->buffered_bytes() + frame_bytes_, [&] {
        check_name(*file_);
        tables_->flush_rows();
        hdf5_->commit();
        tables_->flush_frame_count();
        hdf5_->commit();
        tables_->flush_times();
        hdf5_->commit();
        tables_->switch_restart();
        hdf5_->commit();
        file_->seal();
        H5garbage_collect();  // buffers that HDF5 keeps for frames of that size
    });
    // Flushing takes at most a tenth of the time, even on a slow disk.
    const auto end = Clock::now();
    next_flush_ = end + std::max<Clock::duration>(flush_interval, 10 * (end - start));
}

void ResultsFile::close_hdf5() {
    tables_.reset();
    hdf5_->close();
}

void ResultsFile::close(RunStatus status,
                        const std::string& reason,
                        std::span<const std::int64_t> reason_nodes,
                        const std::string& warnings) {
    flush();
    attempt(hdf5_reserve, [&] {
        const hid_t root = hdf5_->root.id();
        rewrite_attribute(root, "reason", reason);
        if (!reason_nodes.empty()) rewrite_attribute(root, "reason_nodes", reason_nodes);
        if (!warnings.empty()) rewrite_attribute(root, "warnings", warnings);
        rewrite_attribute(root, "status", std::string(name_of(status)));
        hdf5_->commit();
        close_hdf5();
        file_->seal();
        check_name(*file_);
    });
    if (!file_->is_at(path_)) {
        throw FileError(path_, "was moved while the run wrote it", "it is complete, under its new name");
    }
}

}  // namespace gxrod
