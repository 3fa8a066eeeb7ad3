#include "results/tables/rod_table.hpp"

#include "results/tables/rod_places.hpp"

namespace gxrod {
namespace {

const char* const where_no_rod_is = "-1 for bodies, and for points where no rod is";

void write_places(const Hdf5Handle& data,
                  const Hdf5Handle& offsets,
                  hid_t no_offsets,
                  const RodPlaces& places,
                  const std::string& where) {
    const std::string none = std::string("; ") + where_no_rod_is;
    write_dataset(
        data, {"rod", "number of the rod in /rods, from 0" + where + none, "none", "1"}, places.rod);
    write_dataset(data,
                  {"element", "number of the element in its rod, from 0" + where + none, "none", "1"},
                  places.element);
    write_dataset(
        data,
        {"arc_length", "from the start of the rod, where it is free of stress" + where, "none", "length"},
        places.arc_length);
    for (const char* name : {"rod", "element", "arc_length"}) link_dataset(no_offsets, offsets, name);
}

template <class Value, class Take>
std::vector<Value> list_of_rods(const Model& model, Take take) {
    std::vector<Value> values;
    for (const Rod& rod : model.rods) values.push_back(take(rod));
    return values;
}

void write_table(const Hdf5Handle& root, const Model& model) {
    const Hdf5Handle group = require_group(root, "rods");
    const auto write_texts = [&](const DatasetLabel& label, auto take) {
        write_dataset(group, label, std::span<const std::string>(list_of_rods<std::string>(model, take)));
    };
    const auto write_counts = [&](const DatasetLabel& label, auto take) {
        write_dataset(group, label, std::span<const std::int64_t>(list_of_rods<std::int64_t>(model, take)));
    };
    write_texts({"name", "name of each rod", "none", ""}, [](const Rod& rod) { return rod.name; });
    write_texts({"section", "name of its section", "none", ""},
                [&](const Rod& rod) { return model.sections[static_cast<std::size_t>(rod.section)].name; });
    write_dataset(group,
                  {"length", "length of its centreline where it is free of stress", "none", "length"},
                  list_of_rods<double>(model, [](const Rod& rod) { return rod.length; }));
    write_counts({"order", "order of its elements", "none", "1"}, [](const Rod& rod) { return rod.order; });
    write_counts({"elements", "how many it has", "none", "1"},
                 [](const Rod& rod) { return rod.element_count(); });
    std::int64_t cells = 0;
    write_counts({"first_cell", "cell of its first element in /VTKHDF; the others follow", "none", "1"},
                 [&](const Rod& rod) {
                     const std::int64_t first = cells;
                     cells += rod.element_count();
                     return first;
                 });
    write_dataset(group,
                  {"arc_length",
                   "of each entry of /VTKHDF/Connectivity on the rod of its cell, where points of several "
                   "rods have several; 0 for bodies",
                   "none",
                   "length"},
                  list_arc_lengths(model));
}

}  // namespace

void write_rod_places(const PlaceGroups& groups, const Model& model) {
    if (has_link(groups.cell_data, "arc_length")) return;
    write_places(groups.cell_data,
                 groups.cell_data_offsets,
                 groups.no_offsets,
                 find_cell_places(model),
                 ", at the element's middle");
    write_places(groups.point_data,
                 groups.point_data_offsets,
                 groups.no_offsets,
                 find_point_places(model),
                 ", on the first rod there");
    // A list of more names would not be read.
    if (!model.rods.empty() && model.rods.size() <= most_texts) write_table(groups.root, model);
}

}  // namespace gxrod
