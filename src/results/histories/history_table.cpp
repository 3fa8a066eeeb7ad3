#include "results/histories/history_table.hpp"

#include "results/tables/stage_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace gxrod {
namespace {

constexpr int most_columns = 6;

// "[1, 0, 2]", or "" without a vector: where moments are about the support's point, where angles are to the
// axis at t = 0.
std::string describe(const std::optional<Vec3>& vector) {
    if (!vector) return "";
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", (*vector)[0], (*vector)[1], (*vector)[2]);
}

// "[0.05, 0.1]" in the section, or "" for where stresses are worst.
std::string describe_point(const HistoryRequest& request) {
    if (!request.section_point) return "";
    return fmt::format("[{:.17g}, {:.17g}]", request.section_point->x(), request.section_point->y());
}

// The attribute `frame` of datasets.
std::string frame_of(Axes axes, const std::string& relative_to) {
    switch (axes) {
        case Axes::none:
            return "none";
        case Axes::global:
            return "spatial";
        case Axes::observer:
            return relative_to.empty() ? "spatial" : "axes of " + relative_to;
        case Axes::material:
            return "material";
        case Axes::principal:
            return "principal";
        case Axes::joint:
            return "joint axes of A";
        case Axes::bushing:
            break;
    }
    return "bushing";
}

std::string describe(const Quantity& quantity, const HistoryRequest& request) {
    std::string meaning = quantity.meaning;
    if (quantity.is_about && request.about) return meaning + ", about " + describe(request.about);
    if (request.relative_to.empty()) return meaning;
    return quantity.relative_meaning != nullptr
               ? fmt::format(fmt::runtime(quantity.relative_meaning), request.relative_to)
               : fmt::format("{}, as seen from {} and its axes", meaning, request.relative_to);
}

// What an attribute of a group says, "" without it.
std::string read_label(const Hdf5Handle& group, const char* name) {
    return H5Aexists(group.id(), name) > 0 ? read_text_attribute(group.id(), name) : "";
}

RowShape shape_of(const Hdf5Handle& group, const std::string& name) {
    const Hdf5Handle dataset(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening a dataset");
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose, "dataspace");
    std::array<hsize_t, 2> size{0, 1};
    const bool is_vector = H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) > 1;
    return {static_cast<int>(size[1]), is_vector};
}

// Writes which point a history is of; throws if it already belongs to another.
void label_group(const Hdf5Handle& group, const HistoryRequest& request) {
    const bool is_new = H5Aexists(group.id(), "at") <= 0;
    const std::string about = describe(request.about), no_load = describe(request.no_load);
    const std::string point = describe_point(request);
    if (is_new) {
        write_attribute(group.id(), "at", request.at);
        if (!request.relative_to.empty()) write_attribute(group.id(), "relative_to", request.relative_to);
        if (!about.empty()) write_attribute(group.id(), "about", about);
        if (!no_load.empty()) write_attribute(group.id(), "no_load", no_load);
        if (!request.with.empty()) write_attribute(group.id(), "with", request.with);
        if (!point.empty()) write_attribute(group.id(), "point", point);
        if (!request.criterion.empty()) write_attribute(group.id(), "criterion", request.criterion);
        return;
    }
    if (read_label(group, "at") == request.at && read_label(group, "relative_to") == request.relative_to &&
        read_label(group, "about") == about && read_label(group, "no_load") == no_load &&
        read_label(group, "with") == request.with && read_label(group, "point") == point &&
        read_label(group, "criterion") == request.criterion) {
        return;
    }
    throw std::runtime_error("its history " + request.name +
                             " is of another point; give this one another name");
}

}  // namespace

HistoryTable::HistoryTable(const Hdf5Handle& histories,
                           const Model& model,
                           const std::vector<HistoryRequest>& requests,
                           hsize_t rows) {
    std::vector<std::string> ended = list_members(histories.id());
    std::erase_if(ended, [](const std::string& name) { return !is_history_name(name); });
    for (std::size_t i = 0; i < requests.size(); ++i) {
        std::erase(ended, requests[i].name);
        add_history(require_group(histories, requests[i].name),
                    model,
                    HistoryWatch(model, requests, i),
                    requests[i],
                    rows);
    }
    for (const std::string& name : ended) add_ended(require_group(histories, name), {}, rows);
}

void HistoryTable::add_history(const Hdf5Handle& group,
                               const Model& model,
                               const HistoryWatch& watch,
                               const HistoryRequest& request,
                               hsize_t rows) {
    label_group(group, request);
    History history{watch, {}};
    for (const Quantity* quantity : quantities_of(request)) {
        const DatasetLabel label{quantity->word,
                                 describe(*quantity, request),
                                 frame_of(quantity->axes, request.relative_to),
                                 dimension_of(*quantity, request.target, model)};
        const RowShape shape{quantity->columns, quantity->columns > 1};
        const bool is_resumed = has_link(group, label.name);
        history.columns.push_back({*quantity, AppendDataset<double>(group, label, shape, rows)});
        const std::vector<double> last = history.columns.back().values.last_row();
        if (is_resumed && !last.empty()) history.watch.resume(*quantity, last);
    }
    histories_.push_back(std::move(history));
    add_ended(group, request.quantities, rows);
}

void HistoryTable::add_ended(const Hdf5Handle& group,
                             const std::vector<std::string>& recorded,
                             hsize_t rows) {
    for (const std::string& name : list_members(group.id())) {
        if (std::find(recorded.begin(), recorded.end(), name) != recorded.end()) continue;
        const RowShape shape = shape_of(group, name);
        ended_.push_back({shape.columns, AppendDataset<double>(group, {name, "", "", ""}, shape, rows)});
    }
}

void HistoryTable::append(const Snapshot& snapshot) {
    for (History& history : histories_) {
        for (Column& column : history.columns) {
            const HistoryRow row = history.watch.compute(column.quantity, snapshot);
            column.values.append(std::span(row).first(static_cast<std::size_t>(column.quantity.columns)));
        }
    }
    std::array<double, most_columns> missing;
    missing.fill(std::numeric_limits<double>::quiet_NaN());
    for (Ended& ended : ended_)
        ended.values.append(std::span(missing).first(static_cast<std::size_t>(ended.width)));
}

template <class Action>
void HistoryTable::for_each_dataset(Action&& action) {
    for (History& history : histories_) {
        for (Column& column : history.columns) action(column.values);
    }
    for (Ended& ended : ended_) action(ended.values);
}

void HistoryTable::flush() {
    for_each_dataset([](AppendDataset<double>& values) { values.flush(); });
}

void HistoryTable::trim() {
    for_each_dataset([](AppendDataset<double>& values) { values.trim(); });
}

std::size_t HistoryTable::buffered_bytes() const {
    std::size_t bytes = 0;
    for (const History& history : histories_) {
        for (const Column& column : history.columns) bytes += column.values.buffered_bytes();
    }
    for (const Ended& ended : ended_) bytes += ended.values.buffered_bytes();
    return bytes;
}

}  // namespace gxrod
