#include "report/blocks/contact_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <variant>

#include "model/evaluation_error.hpp"
#include "report/blocks/data_blocks.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_touches_drawn = 400;  // of a frame

Json to_json(const Vec3& v) { return {v[0], v[1], v[2]}; }

// The rows of a table between two, as rows of `width` numbers.
std::vector<double> read_rows(
    const Hdf5Reader& file, const char* name, double first, double end, hsize_t width) {
    if (end <= first) return {};
    return file.rows(std::string("/contacts/") + name,
                     static_cast<hsize_t>(first),
                     static_cast<hsize_t>(end - first),
                     width);
}

// What of the run a time on the axis of all stages belongs to.
struct StageTime {
    std::size_t stage = 0;
    double time = 0.0;  // of its own
};

std::vector<StageTime> find_stage_times(const Hdf5Reader& file, const std::vector<double>& times) {
    std::vector<StageTime> found;
    const bool has_stages = file.has("/histories/stage");
    const std::vector<double> axis = has_stages ? file.numbers("/histories/time") : std::vector<double>();
    const std::vector<double> stages = has_stages ? file.numbers("/histories/stage") : std::vector<double>();
    const std::size_t rows = std::min(axis.size(), stages.size());
    for (const double time : times) {
        const auto end = axis.begin() + static_cast<std::ptrdiff_t>(rows);
        auto row = static_cast<std::size_t>(std::lower_bound(axis.begin(), end, time) - axis.begin());
        if (rows == 0) {
            found.push_back({0, time});
            continue;
        }
        row = std::min(row, rows - 1);
        const double stage = stages[row];
        double start = axis[0];
        for (std::size_t i = 1; i <= row; ++i) {
            if (stages[i] == stage && stages[i - 1] != stage) start = axis[i - 1];
        }
        found.push_back({static_cast<std::size_t>(std::max(stage, 0.0)), time - start});
    }
    return found;
}

void append_motion(const ObstacleMotion& motion, double time, std::vector<float>& values) {
    try {
        const Vec3 displacement = motion.displacement(time);
        const Quat turn = exp_quaternion(motion.rotation(time));
        for (const double value : displacement) values.push_back(static_cast<float>(value));
        for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()})
            values.push_back(static_cast<float>(value));
    } catch (const EvaluationError&) {
        values.insert(values.end(), 7, std::numeric_limits<float>::quiet_NaN());
    }
}

}  // namespace

ContactBlocks::ContactBlocks(const Hdf5Reader& file, std::size_t frames) : file_(file) {
    if (!file.has("/contacts/offsets")) return;
    offsets_ = file.rows("/contacts/offsets", 0, frames + 1, 1);
    for (std::size_t frame = 0; frame < frames; ++frame)
        all_ = std::max(all_, static_cast<std::size_t>(std::max(0.0, offsets_[frame + 1] - offsets_[frame])));
    most_ = std::min(all_, most_touches_drawn);
}

std::string ContactBlocks::left_out() const {
    if (most_ == all_) return "";
    return fmt::format(
        "Where more than {} places touch in a frame, the strongest {} are drawn.", most_, most_);
}

void ContactBlocks::write(const std::vector<std::size_t>& chosen, std::ostream& out) const {
    if (most_ == 0) return;
    std::vector<std::int32_t> written{0};
    write_block(out, "contacts", [&](Base64Writer& base64) {
        for (const std::size_t frame : chosen) {
            const double first = offsets_[frame], end = offsets_[frame + 1];
            const auto read = [&](const char* name, hsize_t width) {
                return read_rows(file_, name, first, end, width);
            };
            const std::vector<double> points = read("point", 3), normal = read("normal_force", 3),
                                      friction = read("friction_force", 3), slides = read("slides", 1),
                                      rods = read("rods", 2);
            std::vector<double> forces(normal.size());
            std::ranges::transform(normal, friction, forces.begin(), std::plus<>());
            const auto size_of = [&](std::size_t row) {
                return Vec3(forces[3 * row], forces[3 * row + 1], forces[3 * row + 2]).norm();
            };
            std::vector<std::size_t> rows(slides.size());
            std::iota(rows.begin(), rows.end(), std::size_t{0});
            std::ranges::stable_sort(rows, std::greater<>(), size_of);
            rows.resize(std::min(rows.size(), most_));
            std::vector<float> values;
            for (const std::size_t row : rows) {
                for (std::size_t i = 3 * row; i < 3 * row + 3; ++i)
                    values.push_back(static_cast<float>(points[i]));
                for (std::size_t i = 3 * row; i < 3 * row + 3; ++i)
                    values.push_back(static_cast<float>(forces[i]));
                values.push_back(static_cast<float>(slides[row] + (rods[2 * row + 1] >= 0.0 ? 2.0 : 0.0)));
            }
            base64.write(std::span<const float>(values));
            written.push_back(written.back() + static_cast<std::int32_t>(rows.size()));
        }
    });
    write_block(out, "contact-offsets", written);
}

Json describe_obstacles(const Model& model) {
    Json list = Json::array();
    int moved = 0;
    for (const Obstacle& obstacle : model.contact.obstacles) {
        Json line = Json::array();
        std::string word;
        const auto describe = [&](const auto& shape) {
            word = shape.word;
            if (obstacle.mesh() != nullptr) return;
            for (const Vec3& point : shape.points()) line.push_back(to_json(point));
        };
        std::visit(describe, obstacle.shape);
        const RoundShape* round = obstacle.round();
        const PlaneShape* plane = obstacle.plane();
        list.push_back({{"name", obstacle.name},
                        {"shape", word},
                        {"hollow", obstacle.is_hollow()},
                        {"radius", round != nullptr ? round->radius : 0.0},
                        {"normal", to_json(plane != nullptr ? plane->normal : Vec3(Vec3::UnitZ()))},
                        {"line", line},
                        {"about", to_json(obstacle.motion ? obstacle.motion->about : Vec3(Vec3::Zero()))},
                        {"moved", obstacle.motion ? moved++ : -1}});
    }
    return list;
}

std::size_t count_moved_obstacles(const Model& model) {
    return static_cast<std::size_t>(std::ranges::count_if(
        model.contact.obstacles, [](const Obstacle& one) { return one.motion.has_value(); }));
}

void write_obstacle_motions(const Hdf5Reader& file,
                            const Problem& problem,
                            const std::vector<double>& times,
                            std::ostream& out) {
    if (count_moved_obstacles(problem.model) == 0) return;
    std::vector<float> values;
    for (const StageTime& at : find_stage_times(file, times)) {
        const bool is_later = at.stage > 0 && at.stage < problem.stages.size();
        const Contact& contact = is_later ? problem.stages[at.stage].actions.contact : problem.model.contact;
        for (const Obstacle& obstacle : contact.obstacles) {
            if (obstacle.motion) append_motion(*obstacle.motion, at.time, values);
        }
    }
    write_block(out, "obstacles", values);
}

std::size_t count_mesh_bytes(const Model& model) {
    std::size_t bytes = 0;
    for (const Obstacle& obstacle : model.contact.obstacles) {
        const TriangleMesh* mesh = obstacle.mesh();
        if (mesh == nullptr) continue;
        bytes += 2 * block_frame_bytes + base64_length(mesh->positions.size() * 3 * sizeof(float)) +
                 base64_length(mesh->triangles.size() * 3 * sizeof(std::int32_t));
    }
    return bytes;
}

void write_obstacle_meshes(const Model& model, std::ostream& out) {
    int number = -1;
    for (const Obstacle& obstacle : model.contact.obstacles) {
        ++number;
        const TriangleMesh* mesh = obstacle.mesh();
        if (mesh == nullptr) continue;
        std::vector<float> corners;
        for (const Vec3& corner : mesh->positions)
            for (const double value : corner) corners.push_back(static_cast<float>(value));
        std::vector<std::int32_t> triangles;
        for (const std::array<int, 3>& triangle : mesh->triangles)
            triangles.insert(triangles.end(), triangle.begin(), triangle.end());
        write_block(out, fmt::format("mesh-corners-{}", number), corners);
        write_block(out, fmt::format("mesh-triangles-{}", number), triangles);
    }
}

}  // namespace gxrod
