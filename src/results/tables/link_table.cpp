#include "results/tables/link_table.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/ties/joint_card.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Three numbers a row.
void write_vectors(const Hdf5Handle& group, const DatasetLabel& label, const std::vector<double>& values) {
    const std::array<hsize_t, 2> size{values.size() / 3, 3};
    write_dataset(group, label, size, values);
}

void append(const Vec3& vector, std::vector<double>& values) {
    values.insert(values.end(), vector.begin(), vector.end());
}

void write_ends(const Hdf5Handle& group, const std::string& side, std::span<const Anchor* const> ends) {
    std::vector<std::int64_t> points;
    std::vector<double> arms;
    for (const Anchor* end : ends) {
        points.push_back(end->is_ground() ? -1 : end->node);
        append(end->arm, arms);
    }
    write_dataset(
        group,
        {"point_" + side, "point of /VTKHDF that carries " + side + "; -1 for the ground", "none", "1"},
        std::span<const std::int64_t>(points));
    write_vectors(group,
                  {"arm_" + side,
                   "from that point to the place of " + side + ", at t = 0; of the ground the place itself",
                   "spatial",
                   "length"},
                  arms);
}

// The table of these ties; none without any, nor if the file has it already.
std::optional<Hdf5Handle> write_table(const Hdf5Handle& root,
                                      const char* table,
                                      const std::vector<Tie>& ties) {
    // A list of more names would not be read.
    if (ties.empty() || ties.size() > most_texts || has_link(root, table)) return std::nullopt;
    Hdf5Handle group = require_group(root, table);
    std::vector<std::string> names;
    std::vector<const Anchor*> a, b;
    for (const Tie& tie : ties) {
        names.push_back(*tie.name);
        a.push_back(&tie.ends[0]);
        b.push_back(&tie.ends[1]);
    }
    write_dataset(
        group, {"name", "of each, as the deck has it", "none", ""}, std::span<const std::string>(names));
    write_ends(group, "a", a);
    write_ends(group, "b", b);
    return group;
}

void write_joint_columns(const Hdf5Handle& group, const Model& model) {
    std::vector<std::string> types;
    std::vector<double> axes;
    std::vector<double> axes_b;
    for (const Joint& joint : model.joints) {
        types.emplace_back(card_of(joint.kind).word);
        append(joint.a.axes.col(0), axes);
        append(joint.b.axes.col(0), axes_b);
    }
    write_dataset(group, {"type", "as the deck has it", "none", ""}, std::span<const std::string>(types));
    write_vectors(group, {"axis_a", "axis that A carries, at t = 0", "spatial", "1"}, axes);
    write_vectors(group, {"axis_b", "axis that B carries, at t = 0", "spatial", "1"}, axes_b);
}

void write_sleeves(const Hdf5Handle& root, const Model& model) {
    if (model.sleeves.empty() || model.sleeves.size() > most_texts || has_link(root, "sleeves")) return;
    const Hdf5Handle group = require_group(root, "sleeves");
    std::vector<std::string> names;
    std::vector<std::int64_t> rods;
    std::vector<double> places;
    std::vector<const Anchor*> points;
    for (const Sleeve& sleeve : model.sleeves) {
        names.push_back(sleeve.name);
        rods.push_back(sleeve.rod);
        places.push_back(sleeve.place);
        points.push_back(&sleeve.point);
    }
    write_dataset(
        group, {"name", "of each, as the deck has it", "none", ""}, std::span<const std::string>(names));
    write_dataset(group,
                  {"rod", "on which the point slides: row of /rods", "none", "1"},
                  std::span<const std::int64_t>(rods));
    write_dataset(group,
                  {"place", "of the sleeve on the rod at t = 0, arc length", "none", "length"},
                  std::span<const double>(places));
    write_ends(group, "b", points);
}

}  // namespace

void write_link_tables(const Hdf5Handle& root, const Model& model) {
    const std::optional<Hdf5Handle> joints = write_table(root, "joints", list_ties(model, TieKind::joint));
    if (joints) write_joint_columns(*joints, model);
    for_each_element_list(model, [&](TieKind kind, const auto&) {
        write_table(root, card_of(kind).names, list_ties(model, kind));
    });
    write_sleeves(root, model);
}

}  // namespace gxrod
