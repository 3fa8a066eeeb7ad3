#include "results/find_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "results/file_seal.hpp"
#include "results/object_walk.hpp"
#include "results/restart_table.hpp"
#include "results/row_sums.hpp"
#include "results/structure_sum.hpp"

namespace gxrod {
namespace {

Hdf5Handle open_root(const Hdf5Reader& file) {
    return {H5Oopen(file.id(), "/", H5P_DEFAULT), H5Oclose, "opening the root"};
}

// Of all datasets that grow, up to a place and in all.
class RowSums {
  public:
    // Those in all only of a run that has ended: what a kill left beyond the place may not be readable.
    RowSums(const Hdf5Reader& file, const RestartPlace& place, bool has_ended)
        : has_ended_(has_ended),
          steps_(place.steps),
          frames_(place.frames),
          points_(static_cast<hsize_t>(file.count("/VTKHDF/NumberOfPoints"))),
          cells_(static_cast<hsize_t>(file.count("/VTKHDF/NumberOfCells"))) {
        ObjectWalk([this](hid_t object, const std::string& path, bool is_new) {
            if (is_new && H5Iget_type(object) == H5I_DATASET && grows(object)) add(object, path);
        }).walk(open_root(file).id(), "/");
    }

    PlaceSums at_place() const { return {combine(at_place_.steps), combine(at_place_.frames)}; }
    PlaceSums of_all() const { return {combine(of_all_.steps), combine(of_all_.frames)}; }

  private:
    struct Sums {
        std::vector<RowSum> steps, frames;
    };

    void add(hid_t dataset, const std::string& path) {
        const auto part = path.starts_with("/VTKHDF/") ? &Sums::frames : &Sums::steps;
        const hsize_t rows = part == &Sums::frames ? rows_of_frames(path) : steps_;
        const haddr_t address = address_of(dataset);
        const std::uint32_t sum = sum_rows(dataset, {0, rows});
        (at_place_.*part).push_back({address, sum});
        if (!has_ended_) return;
        (of_all_.*part).push_back({address, sum_rows(dataset, {rows, extent_of(dataset).at(0)}, sum)});
    }

    hsize_t rows_of_frames(const std::string& path) const {
        if (path.starts_with("/VTKHDF/Steps/")) return frames_;
        return frames_ * (path.starts_with("/VTKHDF/CellData/") ? cells_ : points_);
    }

    bool has_ended_;
    hsize_t steps_, frames_, points_, cells_;
    Sums at_place_, of_all_;
};

// Whether times grow after a place; steps there are of a last write that was cut short, and have no checksum.
bool do_times_go_on(const Hdf5Reader& file, const RestartPlace& place) {
    const hsize_t first = place.steps > 0 ? place.steps - 1 : 0;
    const hsize_t steps = file.size("/histories/time").at(0);
    if (steps < place.steps) return false;
    const std::vector<double> times = file.rows("/histories/time", first, steps - first, 1);
    return std::adjacent_find(times.begin(), times.end(), [](double a, double b) { return !(a < b); }) ==
           times.end();
}

bool is_structure_as_written(const Hdf5Reader& file, const Hdf5Handle& root) {
    return sum_structure(root.id()) == read_file_sums(file).structure;
}

const char* const structure_changed =
    "its names, deck, meshes or other texts are not those that were written";
const char* const seal_changed = "not all of its bytes are those that were written";
const char* const end_changed = "its status, its last frame or the number of its rows is not that of its end";

std::vector<std::string> find_changes_with_state(const Hdf5Reader& file, const RestartPlace& place) {
    const FileSums written = read_file_sums(file);
    if (written.structure == 0) return {};
    const Hdf5Handle root = open_root(file);
    if (!is_structure_as_written(file, root)) return {structure_changed};
    std::vector<std::string> changes;
    const RowSums sums(file, place, written.end != 0);
    const double time = place.record.steps.time;
    if (sums.at_place().steps != place.sums.steps) {
        changes.push_back(
            fmt::format("rows of its histories, ledger or solver's record, up to t = {:.10g}, are not those "
                        "that were written",
                        time));
    }
    const bool lacks_frames =
        file.integer_attribute("/VTKHDF/Steps", "NSteps") < static_cast<long long>(place.frames);
    if (lacks_frames || sums.at_place().frames != place.sums.frames)
        changes.push_back(fmt::format("frames up to t = {:.10g} are not those that were written", time));
    if (changes.empty() && !do_times_go_on(file, place))
        changes.push_back(fmt::format("times of steps after t = {:.10g} do not grow", time));
    if (changes.empty() && written.end != 0 && sum_end(root.id(), sums.of_all()) != written.end)
        changes.emplace_back(end_changed);
    return changes;
}

// Of a run that could not begin, say.
std::vector<std::string> find_changes_without_state(const Hdf5Reader& file) {
    const Hdf5Handle root = open_root(file);
    if (!is_structure_as_written(file, root)) return {structure_changed};
    const std::uint32_t end = read_file_sums(file).end;
    if (end != 0 && sum_end(root.id(), RowSums(file, {}, true).of_all()) != end) return {end_changed};
    return {};
}

}  // namespace

std::vector<std::string> find_changes(const Hdf5Reader& file) {
    try {
        // Of another version's, nothing is known.
        if (file.has("/restart") && !has_known_form(file)) return {};
        if (file.has("/restart") && !has_known_structure(file)) return {structure_changed};
        const std::optional<RestartPlace> place = read_restart(file);
        const hsize_t steps = file.size("/histories/time").at(0);
        if (read_file_sums(file).structure == 0) {
            if (steps == 0) return {};
            return {"its run was stopped before it wrote checksums, so that changes would not be told"};
        }
        std::vector<std::string> changes =
            place ? find_changes_with_state(file, *place) : find_changes_without_state(file);
        if (!changes.empty()) return changes;
        const SealState seal = look_at_seal(file);
        if (seal == SealState::violated) return {seal_changed};
        const bool has_ended = read_file_sums(file).end != 0;
        if (seal == SealState::broken && !has_ended && steps > (place ? place->steps : 0)) {
            return {fmt::format("its steps{} have no checksum, as its run was stopped while it wrote them",
                                place ? fmt::format(" after t = {:.10g}", place->record.steps.time) : "")};
        }
        return {};
    } catch (const std::runtime_error& error) {
        return {error.what()};
    }
}

std::vector<std::string> find_changes(const Hdf5Reader& file, const RestartPlace& place) {
    if (!has_known_structure(file)) return {structure_changed};
    std::vector<std::string> changes = find_changes_with_state(file, place);
    if (changes.empty() && look_at_seal(file) == SealState::violated) changes.emplace_back(seal_changed);
    return changes;
}

}  // namespace gxrod
