#include "results/tables/frame_table.hpp"

#include <algorithm>
#include <array>

#include "model/sections/rods_in_fluid.hpp"
#include "results/tables/frame_topology.hpp"
#include "results/tables/link_table.hpp"
#include "results/tables/rod_table.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

const std::array<DatasetLabel, 7> point_labels{{
    {"displacement", "displacement since t = 0", "spatial", "length"},
    {"rotation_vector", "rotation vector since t = 0, at most pi long", "spatial", "angle"},
    {"velocity", "velocity", "spatial", "length/time"},
    {"angular_velocity", "angular velocity", "spatial", "angle/time"},
    {"axis_x", "x axis of the section, or of the body where no rod is", "spatial", "1"},
    {"axis_y", "y axis of the section, or of the body where no rod is", "spatial", "1"},
    {"axis_z", "z axis of the section, or of the body where no rod is", "spatial", "1"},
}};

const std::array<DatasetLabel, 4> cell_labels{{
    {"force", "section force (axial, shear y, shear z) at the element's middle", "material", "force"},
    {"moment", "section moment (about x, y, z) at the element's middle", "material", "force·length"},
    {"strain", "strain (axial, shear y, shear z) at the element's middle", "material", "1"},
    {"curvature", "change of curvature (about x, y, z) at the element's middle", "material", "angle/length"},
}};

const DatasetLabel cell_radius_label{
    "radius",
    "for drawing: 2 sqrt(EI/EA), the radius of a solid circle of the section's "
    "bending and axial stiffness; 0 if not finite, and for bodies",
    "none",
    "length"};
const DatasetLabel point_radius_label{
    "radius", "for drawing: radius of the first rod there; 0 where no rod is", "none", "length"};

const DatasetLabel contact_force_label{
    "contact_force", "force of all that touches on the node", "spatial", "force"};

const DatasetLabel contact_gap_label{
    "contact_gap",
    "least gap of what touches next to the node; the skin where nothing does",
    "none",
    "length"};

const DatasetLabel bed_force_label{
    "bed_force", "force of the ground on the rods at the node, per length", "spatial", "force/length"};

const DatasetLabel wall_tension_label{
    "wall_tension",
    "axial force of the wall at the element's middle: section force less pressures, p_o A_o - p_i A_i",
    "none",
    "force"};

const std::array<DatasetLabel, 2> stress_labels{{
    {"von_mises",
     "largest von Mises stress at the element's middle; NaN without one",
     "none",
     "force/length²"},
    {"exposure", "largest exposure at the element's middle; NaN without one", "none", "1"},
}};

constexpr RowShape number_in_row{1, true};  // [S,1]

// One frame a chunk if compressed; else about that, within limits: small chunks cost time, large ones space
// (docs/performance.md).
RowChunks frame_chunks(std::size_t frame_rows, std::size_t row_bytes, bool is_deflated) {
    constexpr std::size_t least = 8192;
    if (is_deflated) return {std::max<hsize_t>(frame_rows, 1), true};
    const std::size_t bytes = std::min(std::max(frame_rows * row_bytes, least), most_chunk_bytes);
    return {bytes / row_bytes, false};
}

Hdf5Handle require_frame_count(const Hdf5Handle& steps) {
    if (H5Aexists(steps.id(), "NSteps") > 0) {
        return {H5Aopen(steps.id(), "NSteps", H5P_DEFAULT), H5Aclose, "opening an attribute"};
    }
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "scalar dataspace");
    return {H5Acreate2(steps.id(), "NSteps", H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose,
            "creating an attribute"};
}

std::span<const double> numbers(const Vec3& vector) { return {vector.data(), 3}; }

}  // namespace

FrameTable::FrameTable(const Hdf5Handle& root,
                       const Model& model,
                       const OutputSettings& output,
                       hsize_t frames,
                       const StressWatch* stresses)
    : model_(&model),
      stresses_(stresses),
      mesh_(make_frame_mesh(model)),
      is_compressed_(output.compression == Compression::deflate),
      frames_(static_cast<std::int64_t>(frames)),
      group_(require_group(root, "VTKHDF")),
      steps_(require_group(group_, "Steps")),
      times_(steps_, {"Values", "time of each frame", "none", "time"}, scalar_row, frames),
      part_offsets_(steps_, {"PartOffsets", "first part of each frame: 0", "none", "1"}, scalar_row, frames),
      part_counts_(steps_, {"NumberOfParts", "parts of each frame: 1", "none", "1"}, scalar_row, frames),
      point_offsets_(
          steps_, {"PointOffsets", "first point row of each frame", "none", "1"}, scalar_row, frames),
      cell_offsets_(require_group(steps_, "CellDataOffsets"),
                    {cell_labels[0].name, "first cell row of each frame", "none", "1"},
                    scalar_row,
                    frames),
      topology_offsets_(
          steps_, {"CellOffsets", "one topology serves all frames: 0", "none", "1"}, number_in_row, frames),
      frame_count_(require_frame_count(steps_)) {
    link_dataset(topology_offsets_.id(), steps_, "ConnectivityIdOffsets");
    if (!has_link(group_, "Types")) {
        write_frame_topology(group_, mesh_, model_->nodes.size());
        flush_count();
    }
    mesh_.connectivity = mesh_.offsets = std::vector<std::int64_t>();
    mesh_.types = std::vector<std::uint8_t>();
    create_fields(root);
}

void FrameTable::create_fields(const Hdf5Handle& root) {
    const hsize_t point_rows = static_cast<hsize_t>(frames_) * model_->nodes.size();
    const hsize_t cell_rows = static_cast<hsize_t>(frames_) * mesh_.cell_count();
    const auto chunks = [this](std::size_t rows, std::size_t row_bytes) {
        return frame_chunks(rows, row_bytes, is_compressed_);
    };
    const RowChunks point_chunks = chunks(model_->nodes.size(), sizeof(Vec3));
    const RowChunks cell_chunks = chunks(mesh_.cell_count(), sizeof(Vec3));
    points_.emplace_back(group_,
                         DatasetLabel{"Points", "positions", "spatial", "length"},
                         vector_row,
                         point_rows,
                         point_chunks);

    const Hdf5Handle point_data = require_group(group_, "PointData");
    const Hdf5Handle point_data_offsets = require_group(steps_, "PointDataOffsets");
    for (const DatasetLabel& label : point_labels) {
        points_.emplace_back(point_data, label, vector_row, point_rows, point_chunks);
        link_dataset(point_offsets_.id(), point_data_offsets, label.name);
    }
    points_.emplace_back(
        point_data, point_radius_label, scalar_row, point_rows, chunks(model_->nodes.size(), sizeof(double)));
    link_dataset(point_offsets_.id(), point_data_offsets, point_radius_label.name);

    if (!model_->contact.is_empty()) {
        points_.emplace_back(point_data, contact_force_label, vector_row, point_rows, point_chunks);
        link_dataset(point_offsets_.id(), point_data_offsets, contact_force_label.name);
        points_.emplace_back(point_data,
                             contact_gap_label,
                             scalar_row,
                             point_rows,
                             chunks(model_->nodes.size(), sizeof(double)));
        link_dataset(point_offsets_.id(), point_data_offsets, contact_gap_label.name);
    }

    if (has_rods_on_ground(*model_)) {
        points_.emplace_back(point_data, bed_force_label, vector_row, point_rows, point_chunks);
        link_dataset(point_offsets_.id(), point_data_offsets, bed_force_label.name);
    }

    const Hdf5Handle cell_data = require_group(group_, "CellData");
    const Hdf5Handle cell_data_offsets(
        H5Gopen2(steps_.id(), "CellDataOffsets", H5P_DEFAULT), H5Gclose, "opening a group");
    for (const DatasetLabel& label : cell_labels) {
        cells_.emplace_back(cell_data, label, vector_row, cell_rows, cell_chunks);
        if (label.name != cell_labels[0].name)
            link_dataset(cell_offsets_.id(), cell_data_offsets, label.name);
    }
    cells_.emplace_back(
        cell_data, cell_radius_label, scalar_row, cell_rows, chunks(mesh_.cell_count(), sizeof(double)));
    link_dataset(cell_offsets_.id(), cell_data_offsets, cell_radius_label.name);
    if (has_rods_in_water(*model_)) {
        cells_.emplace_back(
            cell_data, wall_tension_label, scalar_row, cell_rows, chunks(mesh_.cell_count(), sizeof(double)));
        link_dataset(cell_offsets_.id(), cell_data_offsets, wall_tension_label.name);
    }
    if (stresses_ != nullptr) create_stresses(cell_data, cell_data_offsets, cell_rows);
    write_rod_places({root, point_data, point_data_offsets, cell_data, cell_data_offsets, part_offsets_.id()},
                     *model_);
    write_link_tables(root, *model_);
}

void FrameTable::create_stresses(const Hdf5Handle& cell_data, const Hdf5Handle& offsets, hsize_t cell_rows) {
    for (std::size_t rod = 0; rod < model_->rods.size(); ++rod) {
        for (int element = 0; element < model_->rods[rod].element_count(); ++element)
            shapes_.push_back(
                stresses_->shapes_at({.rod = static_cast<int>(rod), .element = element, .xi = 0.0}));
    }
    shapes_.resize(mesh_.cell_count());
    for (const DatasetLabel& label : stress_labels) {
        cells_.emplace_back(cell_data,
                            label,
                            scalar_row,
                            cell_rows,
                            frame_chunks(mesh_.cell_count(), sizeof(double), is_compressed_));
        link_dataset(cell_offsets_.id(), offsets, label.name);
    }
    if (has_link(cell_data, "section")) return;
    std::vector<std::int64_t> numbers;
    for (const ShapeShares& shapes : shapes_) numbers.push_back(shapes.empty() ? -1 : shapes.front().shape);
    write_dataset(
        cell_data,
        {"section", "number in /sections at the element's middle; -1 without stresses", "none", "1"},
        std::span<const std::int64_t>(numbers));
    link_dataset(part_offsets_.id(), offsets, "section");
}

void FrameTable::append(const Snapshot& snapshot) {
    times_.append(snapshot.time);
    part_offsets_.append(0);
    part_counts_.append(1);
    point_offsets_.append(frames_ * static_cast<std::int64_t>(model_->nodes.size()));
    cell_offsets_.append(frames_ * static_cast<std::int64_t>(mesh_.cell_count()));
    topology_offsets_.append(0);
    append_points(snapshot);
    append_cells(snapshot);
    ++frames_;
}

void FrameTable::append_points(const Snapshot& snapshot) {
    const bool has_ground = has_rods_on_ground(*model_);
    for (std::size_t i = 0; i < snapshot.nodes.size(); ++i) {
        const NodeMotion& node = snapshot.nodes[i];
        const Mat3 axes = (node.Lambda * mesh_.triads[i]).toRotationMatrix();
        const Vec3 displacement = node.r - model_->nodes[i].position;
        points_[0].append(numbers(node.r));
        points_[1].append(numbers(displacement));
        points_[2].append(numbers(log(node.Lambda)));
        points_[3].append(numbers(node.v));
        points_[4].append(numbers(node.omega));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            points_[5 + axis].append({axes.col(static_cast<int>(axis)).data(), 3});
        }
        points_[8].append(mesh_.point_radius[i]);
        if (!model_->contact.is_empty()) {
            const Vec3 force = snapshot.contact_forces.empty() ? Vec3(Vec3::Zero())
                                                               : Vec3(snapshot.contact_forces[i].head<3>());
            points_[9].append(numbers(force));
            points_[10].append(snapshot.contact_gaps.empty() ? 0.0 : snapshot.contact_gaps[i]);
        }
        if (has_ground) points_.back().append(numbers(snapshot.bed_forces[i]));
        flush_if_much(points_);
    }
}

void FrameTable::append_cells(const Snapshot& snapshot) {
    static const SectionValues none{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Quat::Identity()};
    const bool has_water = has_rods_in_water(*model_);
    for (std::size_t i = 0; i < mesh_.cell_count(); ++i) {
        const SectionValues& section = i < snapshot.elements.size() ? snapshot.elements[i] : none;
        cells_[0].append(numbers(section.force));
        cells_[1].append(numbers(section.moment));
        cells_[2].append(numbers(section.strain));
        cells_[3].append(numbers(section.curvature));
        cells_[4].append(mesh_.cell_radius[i]);
        std::size_t next = 5;
        if (has_water) {
            const bool is_rod = i < snapshot.pressure_forces.size();
            cells_[next++].append(is_rod ? section.force.x() + snapshot.pressure_forces[i] : 0.0);
        }
        if (stresses_ != nullptr) {
            const StressWatch::Largest largest = stresses_->find_largest(shapes_[i], section);
            cells_[next++].append(largest.von_mises);
            cells_[next].append(largest.exposure);
        }
        flush_if_much(cells_);
    }
}

void FrameTable::flush_if_much(std::vector<AppendDataset<double>>& fields) const {
    // Compressed chunks must be written whole.
    if (is_compressed_ || fields[0].buffered_bytes() < most_chunk_bytes) return;
    for (AppendDataset<double>& field : fields) field.flush();
}

template <class Action>
void FrameTable::for_each_of_rows(Action&& action) {
    for (AppendDataset<std::int64_t>* offsets :
         {&part_offsets_, &part_counts_, &point_offsets_, &cell_offsets_, &topology_offsets_}) {
        action(*offsets);
    }
    for (AppendDataset<double>& points : points_) action(points);
    for (AppendDataset<double>& cells : cells_) action(cells);
}

void FrameTable::flush_frames() {
    for_each_of_rows([](auto& dataset) { dataset.flush(); });
}

void FrameTable::trim_times() { times_.trim(); }

void FrameTable::trim() {
    times_.trim();
    for_each_of_rows([](auto& dataset) { dataset.trim(); });
}

void FrameTable::flush_count() {
    check_hdf5(H5Awrite(frame_count_.id(), H5T_NATIVE_INT64, &frames_), "counting the frames");
}

void FrameTable::flush_times() { times_.flush(); }

std::size_t FrameTable::buffered_bytes() const {
    return points_[0].buffered_bytes() * points_.size() + cells_[0].buffered_bytes() * cells_.size();
}

}  // namespace gxrod
