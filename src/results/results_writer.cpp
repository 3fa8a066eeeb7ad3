#include "results/results_writer.hpp"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "machine/digest.hpp"
#include "machine/memory_reserve.hpp"
#include "model/version.hpp"
#include "results/deck_reading.hpp"
#include "results/ordered_driver.hpp"

namespace gxrod {
namespace {

using namespace std::chrono_literals;

constexpr auto flush_interval = 200ms;
constexpr std::size_t most_buffered_bytes = std::size_t{16} << 20;

Hdf5Handle open_root(const Hdf5Handle& file) {
    return {H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, "opening the root"};
}

// For the library and for the tables.
OrderedFile& require_memory_for(OrderedFile& file) {
    require_memory(2 * hdf5_reserve);
    return file;
}

// What HDF5 may keep of a frame: two chunks of each of its fields.
std::size_t count_frame_bytes(const Model& model) {
    constexpr std::size_t fields = 14;
    return fields * std::min(model.nodes.size() * sizeof(Vec3), 2 * most_chunk_bytes);
}

void check_name(const OrderedFile& file) {
    if (!file.has_name()) throw std::runtime_error("it was removed while the run wrote it");
}

// Each under its file's name; where two folders have files of one name, the later with a number before it.
void write_meshes(const Hdf5Handle& parent, const std::vector<MeshRecord>& meshes) {
    const Hdf5Handle group = require_group(parent, "meshes");
    std::set<std::string> names;
    for (const MeshRecord& mesh : meshes) {
        const std::string file = std::filesystem::path(mesh.file).filename().string();
        std::string name = file;
        for (int count = 2; !names.insert(name).second; ++count) name = std::to_string(count) + "_" + file;
        const std::vector<std::uint8_t> bytes(mesh.bytes.begin(), mesh.bytes.end());
        write_dataset(group, {name, "bytes of a mesh that the deck names", "none", ""}, bytes);
        const Hdf5Handle dataset(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening a mesh");
        write_attribute(dataset.id(), "file", mesh.file);
        write_attribute(dataset.id(), "sha256", sha256_hex(mesh.bytes));
    }
}

void write_provenance(const Hdf5Handle& root, const DeckRecord& deck) {
    write_attribute(root.id(), "gxrod_version", version);
    write_attribute(root.id(), "deck_name", deck.name);
    write_attribute(root.id(), "deck_sha256", sha256_hex(deck.text));
    write_attribute(root.id(), "title", deck.title);
    write_attribute(root.id(), "units", deck.units);
    write_attribute(root.id(), "analysis", deck.is_static ? "static" : "dynamic");
    write_attribute(root.id(), "status", "running");
    write_attribute(root.id(), "reason", "");
    write_attribute(root.id(), "reason_nodes", std::span<const std::int64_t>{});
    write_attribute(root.id(), "warnings", "");
    const Hdf5Handle group = require_group(root, "deck");
    write_dataset(group, {"text", "the deck as run", "none", ""}, deck.text);
    if (!deck.meshes.empty()) write_meshes(group, deck.meshes);
}

// Keeps the deck that the run goes on with beside those before, if it is another one.
void write_resumption(const Hdf5Handle& root, const DeckRecord& before, const DeckRecord& deck) {
    if (before.text != deck.text) {
        const Hdf5Handle group = require_group(root, "deck");
        std::size_t count = 2;
        while (has_link(group, deck_text_name(count))) ++count;
        write_dataset(
            group,
            {deck_text_name(count), "the deck as run after a resumption that changed it", "none", ""},
            deck.text);
        rewrite_attribute(root.id(), "deck_name", deck.name);
        rewrite_attribute(root.id(), "deck_sha256", sha256_hex(deck.text));
        rewrite_attribute(root.id(), "title", deck.title);
        rewrite_attribute(root.id(), "units", deck.units);
    }
    rewrite_attribute(root.id(), "gxrod_version", version);
    rewrite_attribute(root.id(), "status", "running");
    rewrite_attribute(root.id(), "reason", "");
    rewrite_attribute(root.id(), "reason_nodes", std::span<const std::int64_t>{});
    rewrite_attribute(root.id(), "warnings", "");
}

}  // namespace

ResultsWriter::ResultsWriter(int descriptor,
                             const DeckRecord& deck,
                             const Model& model,
                             const OutputSettings& output)
    : file_(std::make_shared<OrderedFile>(descriptor)),
      hdf5_(create_hdf5(require_memory_for(*file_))),
      root_(open_root(hdf5_)) {
    frame_bytes_ = count_frame_bytes(model);
    write_provenance(root_, deck);
    tables_.emplace(root_, deck, model, output, 0, 0);
    commit();
    file_->seal();
    next_flush_ = Clock::now() + flush_interval;
}

ResultsWriter::ResultsWriter(ResumableFile file,
                             const DeckRecord& deck,
                             const Model& model,
                             const OutputSettings& output)
    : file_(std::make_shared<OrderedFile>(file.release())),
      hdf5_(open_hdf5(require_memory_for(*file_))),
      root_(open_root(hdf5_)) {
    frame_bytes_ = count_frame_bytes(model);
    const auto open_tables = [&] {
        tables_.emplace(root_, deck, model, output, file.place().steps, file.place().frames);
        commit();
    };
    open_tables();
    tables_->trim_times();
    commit(OrderedFile::Order::shrinking);
    tables_->flush_frame_count();
    commit();
    // Compressed frames would be written over those that are there, which a kill in between would tear. What
    // becomes free must not be used again, as if nothing on disk referred to it: HDF5 forgets it.
    tables_->trim();
    commit(OrderedFile::Order::shrinking);
    close_hdf5();
    hdf5_ = open_hdf5(require_memory_for(*file_));
    root_ = open_root(hdf5_);
    write_resumption(root_, file.deck(), deck);
    open_tables();
    commit();
    file_->seal();
    next_flush_ = Clock::now() + flush_interval;
}

ResultsWriter::~ResultsWriter() {
    if (!tables_ || !is_sound_) return;
    try {
        flush();
        close_hdf5();
        file_->seal();
    } catch (...) {
        // The file on disk stays as it was last written. Closing HDF5 needs no disk.
    }
}

// What is half done when an exception comes must not be written later: rows of some tables only, say.
template <class Action>
void ResultsWriter::attempt(std::size_t bytes, Action&& action) {
    assert(tables_ && is_sound_);
    is_sound_ = false;
    require_memory(hdf5_reserve + bytes);
    action();
    is_sound_ = true;
}

void ResultsWriter::record_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver) {
    assert(tables_ && is_sound_);
    is_sound_ = false;  // nothing of HDF5 here: only rows are gathered
    tables_->append_step(snapshot, ledger, solver);
    is_sound_ = true;
}

void ResultsWriter::write_frame(const Snapshot& snapshot) {
    attempt(frame_bytes_, [&] { tables_->append_frame(snapshot); });
}

bool ResultsWriter::is_flush_due() const {
    return Clock::now() >= next_flush_ || tables_->buffered_bytes() > most_buffered_bytes;
}

void ResultsWriter::set_restart(RestartRecord record) {
    attempt(0, [&] { tables_->set_restart(std::move(record)); });
}

void ResultsWriter::flush() {
    const auto start = Clock::now();
    attempt(tables_->buffered_bytes() + frame_bytes_, [&] {
        check_name(*file_);
        tables_->flush_rows();
        commit();
        tables_->flush_frame_count();
        commit();
        tables_->flush_times();
        commit();
        tables_->switch_restart();
        commit();
        file_->seal();
        H5garbage_collect();  // what HDF5 keeps for more frames of that size
    });
    // A slow disk takes at most a tenth of the time.
    const auto end = Clock::now();
    next_flush_ = end + std::max<Clock::duration>(flush_interval, 10 * (end - start));
}

void ResultsWriter::commit(OrderedFile::Order order) {
    check_hdf5(H5Fflush(hdf5_.id(), H5F_SCOPE_LOCAL), "flushing");
    file_->commit(order);
}

void ResultsWriter::close_hdf5() {
    tables_.reset();
    check_hdf5(root_.reset(), "closing the root");
    check_hdf5(hdf5_.reset(), "closing the file");
    file_->commit();
}

void ResultsWriter::close(const std::string& status,
                          const std::string& reason,
                          std::span<const std::int64_t> reason_nodes,
                          const std::string& warnings) {
    flush();
    attempt(0, [&] {
        rewrite_attribute(root_.id(), "reason", reason);
        if (!reason_nodes.empty()) rewrite_attribute(root_.id(), "reason_nodes", reason_nodes);
        if (!warnings.empty()) rewrite_attribute(root_.id(), "warnings", warnings);
        rewrite_attribute(root_.id(), "status", status);
        commit();
        close_hdf5();
        file_->seal();
        check_name(*file_);
    });
}

}  // namespace gxrod
