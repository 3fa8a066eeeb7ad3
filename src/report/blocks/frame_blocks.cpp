#include "report/blocks/frame_blocks.hpp"

#include <algorithm>
#include <limits>

#include "model/evaluation_error.hpp"
#include "report/blocks/data_blocks.hpp"
#include "report/blocks/frame_vectors.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// Those rows of a frame that are chosen.
std::vector<float> choose(std::span<const double> frame, const std::vector<int>& chosen, std::size_t width) {
    std::vector<float> values;
    values.reserve(width * chosen.size());
    for (const int row : chosen) {
        for (std::size_t i = 0; i < width; ++i)
            values.push_back(static_cast<float>(frame[width * static_cast<std::size_t>(row) + i]));
    }
    return values;
}

// Positions at t = 0: those of the first frame less its displacements.
std::vector<float> read_reference(const Hdf5Reader& file,
                                  const ReportPlan& plan,
                                  const ReportContent& content) {
    const auto rows = static_cast<hsize_t>(content.topology->nodes);
    const std::vector<double> points = file.rows("/VTKHDF/Points", 0, rows, 3);
    const std::vector<double> displacement = file.rows("/VTKHDF/PointData/displacement", 0, rows, 3);
    std::vector<float> values;
    for (const int node : plan.nodes) {
        for (int i = 0; i < 3; ++i) {
            values.push_back(static_cast<float>(points[3 * node + i] - displacement[3 * node + i]));
        }
    }
    return values;
}

void write_topology(const ReportPlan& plan, const ReportContent& content, std::ostream& out) {
    std::vector<std::int32_t> numbers(static_cast<std::size_t>(content.topology->nodes), -1);
    for (std::size_t i = 0; i < plan.nodes.size(); ++i) numbers[plan.nodes[i]] = static_cast<std::int32_t>(i);
    std::vector<std::int32_t> connectivity, offsets{0};
    std::vector<float> axes, radii;
    for (const DrawnCell& cell : plan.cells) {
        for (const int node : cell.nodes) connectivity.push_back(numbers[node]);
        for (const Quat& q : cell.axes) {
            for (const double value : {q.w(), q.x(), q.y(), q.z()}) axes.push_back(static_cast<float>(value));
        }
        for (const auto& semi_axes : cell.radii) {
            for (const double value : semi_axes) radii.push_back(static_cast<float>(value));
        }
        offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    }
    write_block(out, "connectivity", connectivity);
    write_block(out, "offsets", offsets);
    write_block(out, "axes", axes);
    write_block(out, "radii", radii);
}

// Of each cell the number of its rod, −1 where it is not known; of its middle, and of the entries of
// connectivity, the arc length.
void write_places(const ReportPlan& plan, std::ostream& out) {
    std::vector<std::int32_t> rods;
    std::vector<float> middles, arc_lengths;
    for (const DrawnCell& cell : plan.cells) {
        rods.push_back(cell.rod);
        middles.push_back(static_cast<float>(cell.middle));
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
            arc_lengths.push_back(cell.rod < 0 ? 0.0F : static_cast<float>(cell.arc_length.at(i)));
    }
    write_block(out, "cell-rods", rods);
    write_block(out, "middles", middles);
    write_block(out, "arc-lengths", arc_lengths);
}

// Of each cell the number of its section in /sections, −1 without stresses.
void write_cell_sections(const Hdf5Reader& file,
                         const ReportPlan& plan,
                         const ReportContent& content,
                         std::ostream& out) {
    const auto rows = static_cast<hsize_t>(content.topology->cells);
    const std::vector<double> all = file.rows("/VTKHDF/CellData/section", 0, rows, 1);
    std::vector<std::int32_t> sections;
    for (const DrawnCell& cell : plan.cells)
        sections.push_back(static_cast<std::int32_t>(all.at(static_cast<std::size_t>(cell.source))));
    write_block(out, "cell-sections", sections);
}

Vec6 value_of(const LoadArrow& arrow, const Vec3& rotation, double time) {
    NodeMotion motion;
    motion.Lambda = exp_quaternion(rotation);
    try {
        return arrow.value(motion, time);
    } catch (const EvaluationError&) {
        return Vec6::Constant(std::numeric_limits<double>::quiet_NaN());
    }
}

// t of the loads at these times of frames: on a path it is not what the frames count.
std::vector<double> find_load_times(const Hdf5Reader& file, const std::vector<double>& times) {
    const std::string column = "/histories/load_factor";
    if (!file.has(column)) return times;
    const std::vector<double> axis = file.numbers("/histories/time");
    const std::vector<double> loads = file.rows(column, 0, axis.size(), 1);
    std::vector<double> found;
    for (const double time : times) {
        const auto row = std::lower_bound(axis.begin(), axis.end(), time) - axis.begin();
        const auto last = static_cast<std::ptrdiff_t>(loads.size()) - 1;
        found.push_back(loads.empty() ? time : loads[static_cast<std::size_t>(std::min(row, last))]);
    }
    return found;
}

void write_arrows(const Hdf5Reader& file,
                  const std::vector<std::size_t>& frames,
                  const std::vector<double>& times,
                  const ReportContent& content,
                  const std::vector<LoadArrow>& arrows,
                  std::ostream& out) {
    const auto rows = static_cast<std::size_t>(content.topology->nodes);
    write_block(out, "arrows", [&](Base64Writer& base64) {
        if (arrows.empty()) return;
        FrameVectors rotation_vectors(file, "/VTKHDF/PointData/rotation_vector", rows, content.frames);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const std::span<const double> rotations = rotation_vectors.read(frames[i]);
            std::vector<float> values;
            for (const LoadArrow& arrow : arrows) {
                const Vec6 value = value_of(arrow, Vec3(rotations.data() + 3 * arrow.node), times[i]);
                for (const double number : value) values.push_back(static_cast<float>(number));
            }
            base64.write(std::span<const float>(values));
        }
    });
}

}  // namespace

void write_frame_blocks(const Hdf5Reader& file,
                        const ReportPlan& plan,
                        const ReportContent& content,
                        const std::vector<LoadArrow>& arrows,
                        std::ostream& out) {
    const std::vector<std::size_t> frames = plan.frames(content.frames);
    const std::vector<double> all_times = file.rows("/VTKHDF/Steps/Values", 0, content.frames, 1);
    std::vector<double> times;
    for (const std::size_t frame : frames) times.push_back(all_times[frame]);
    write_block(out, "frame-times", times);
    write_block(out, "reference", read_reference(file, plan, content));
    write_topology(plan, content, out);
    write_places(plan, out);
    if (content.has_sections) write_cell_sections(file, plan, content, out);

    const auto write_quantity =
        [&](const std::string& name, int rows, const std::vector<int>& chosen, std::size_t width) {
            write_block(out, name.substr(name.rfind('/') + 1), [&](Base64Writer& base64) {
                FrameVectors vectors(file, name, static_cast<std::size_t>(rows), content.frames, width);
                for (const std::size_t frame : frames) {
                    const std::vector<float> values = choose(vectors.read(frame), chosen, width);
                    base64.write(std::span<const float>(values));
                }
            });
        };
    std::vector<int> sources;
    for (const DrawnCell& cell : plan.cells) sources.push_back(cell.source);
    for (const std::string& name : plan.node_data)
        write_quantity("/VTKHDF/PointData/" + name, content.topology->nodes, plan.nodes, 3);
    for (const std::string& name : plan.cell_data)
        write_quantity("/VTKHDF/CellData/" + name, content.topology->cells, sources, 3);
    for (const std::string& name : plan.cell_scalars)
        write_quantity("/VTKHDF/CellData/" + name, content.topology->cells, sources, 1);
    write_arrows(file, frames, find_load_times(file, times), content, arrows, out);
}

}  // namespace gxrod
