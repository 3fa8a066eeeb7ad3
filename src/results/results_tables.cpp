#include "results/results_tables.hpp"

namespace gxrod {
namespace {

AppendDataset<double> open_times(const Hdf5Handle& histories, const DeckRecord& deck, hsize_t rows) {
    if (deck.is_static && !deck.has_paths) {
        return {histories,
                {"time", "load factor at the end of each accepted step", "none", "1"},
                scalar_row,
                rows};
    }
    if (deck.has_paths) {
        return {histories,
                {"time", "what the axis of all stages has grown to: on paths by the arc length", "none", "1"},
                scalar_row,
                rows};
    }
    const char* description =
        deck.has_statics ? "time at the end of each accepted step; of static stages the load factor, "
                           "on an axis that goes on from stage to stage"
                         : "time at the end of each accepted step";
    return {histories, {"time", description, "none", "time"}, scalar_row, rows};
}

std::optional<StressTable> open_stresses(const Hdf5Handle& root,
                                         const Model& model,
                                         const OutputSettings& output,
                                         hsize_t steps) {
    if (!output.stresses.empty())
        return std::optional<StressTable>(std::in_place, root, model, output, steps > 0);
    if (has_link(root, "envelopes"))
        throw std::runtime_error("the file has stresses; output.stresses cannot be left out");
    return std::nullopt;
}

}  // namespace

ResultsTables::ResultsTables(const Hdf5Handle& root,
                             const DeckRecord& deck,
                             const Model& model,
                             const OutputSettings& output,
                             const Rows& rows)
    : histories_group_(require_group(root, "histories")),
      ledger_group_(require_group(root, "ledger")),
      solver_group_(require_group(root, "solver")),
      times_(open_times(histories_group_, deck, rows.steps)),
      stages_(root, histories_group_, deck, rows.steps),
      histories_(histories_group_, model, output.histories, rows.steps),
      ledger_(ledger_group_, ledger_columns, deck.has_statics, rows.steps),
      solver_(solver_group_, solver_columns, deck.has_statics, rows.steps),
      inputs_(root, model.inputs, rows.steps),
      stresses_(open_stresses(root, model, output, rows.steps)),
      frames_(root, model, output, rows.frames, stresses_ ? &stresses_->watch() : nullptr),
      restart_(root),
      rows_(rows),
      step_numbers_(1 + count_numbers(ledger_columns, deck.has_statics) +
                    count_numbers(solver_columns, deck.has_statics)) {
    for (const Hdf5Handle* group : {&ledger_group_, &solver_group_})
        link_dataset(times_.id(), *group, "time");
    if (!model.contact.is_empty()) contacts_.emplace(root, model, rows.frames);
    if (output.history_interval || has_link(root, samples_group_name))
        samples_.emplace(root, model, output.histories, rows.samples);
}

void ResultsTables::append_step(const Snapshot& snapshot, const LedgerRow& ledger, const SolverRow& solver) {
    times_.append(snapshot.time);
    stages_.append(snapshot);
    histories_.append(snapshot);
    ledger_.append(ledger);
    solver_.append(solver);
    inputs_.append(snapshot.inputs);
    if (stresses_) stresses_->append(snapshot);
    ++rows_.steps;
}

void ResultsTables::append_sample(const Snapshot& snapshot) {
    samples_->append(snapshot);
    ++rows_.samples;
}

void ResultsTables::append_frame(const Snapshot& snapshot) {
    frames_.append(snapshot);
    if (contacts_) contacts_->append(snapshot);
    ++rows_.frames;
}

void ResultsTables::set_restart(RestartRecord record) {
    restart_.write({std::move(record), rows_.steps, rows_.frames, rows_.samples});
}

void ResultsTables::flush_rows() {
    stages_.flush();
    histories_.flush();
    ledger_.flush();
    solver_.flush();
    inputs_.flush();
    if (samples_) samples_->flush();
    frames_.flush_frames();
    if (contacts_) contacts_->flush();
    if (stresses_) stresses_->flush();
}

void ResultsTables::flush_frame_count() { frames_.flush_count(); }

void ResultsTables::flush_times() {
    times_.flush();
    if (samples_) samples_->flush_times();
    frames_.flush_times();
}

void ResultsTables::switch_restart() { restart_.switch_slot(); }

void ResultsTables::trim_times() {
    times_.trim();
    if (samples_) samples_->trim_times();
    frames_.trim_times();
}

void ResultsTables::trim() {
    times_.trim();
    stages_.trim();
    histories_.trim();
    ledger_.trim();
    solver_.trim();
    inputs_.trim();
    if (samples_) samples_->trim();
    frames_.trim();
    if (contacts_) contacts_->trim();
}

std::size_t ResultsTables::buffered_bytes() const {
    return times_.buffered_bytes() * static_cast<std::size_t>(step_numbers_) + histories_.buffered_bytes() +
           frames_.buffered_bytes() + (samples_ ? samples_->buffered_bytes() : 0) +
           (contacts_ ? contacts_->buffered_bytes() : 0);
}

}  // namespace gxrod
