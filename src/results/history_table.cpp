#include "results/history_table.hpp"

namespace gxrod {

HistoryTable::HistoryTable(const Hdf5Handle& histories,
                           const Model& model,
                           const std::vector<HistoryRequest>& requests) {
    for (const HistoryRequest& request : requests) {
        const Hdf5Handle group = create_group(histories, request.name);
        write_attribute(group.id(), "at", request.at);
        if (!request.relative_to.empty()) write_attribute(group.id(), "relative_to", request.relative_to);
        History history{HistoryPoint(model, request), {}};
        for (const Quantity quantity : request.quantities) {
            const PointKind kind = history.point.kind();
            const QuantityForm form = request.relative_to.empty()
                                          ? quantity_form(quantity, kind)
                                          : relative_quantity_form(quantity, kind, request.relative_to);
            history.columns.push_back(
                {quantity, form.shape.columns, AppendDataset<double>(group, form.label, form.shape)});
        }
        histories_.push_back(std::move(history));
    }
}

void HistoryTable::append(const Snapshot& snapshot) {
    for (History& history : histories_) {
        for (Column& column : history.columns) {
            const HistoryPoint::Row row = history.point.compute(column.quantity, snapshot);
            column.values.append(std::span(row).first(static_cast<std::size_t>(column.width)));
        }
    }
}

void HistoryTable::flush() {
    for (History& history : histories_) {
        for (Column& column : history.columns) column.values.flush();
    }
}

std::size_t HistoryTable::buffered_bytes() const {
    std::size_t bytes = 0;
    for (const History& history : histories_) {
        for (const Column& column : history.columns) bytes += column.values.buffered_bytes();
    }
    return bytes;
}

}  // namespace gxrod
