#include "benchmarks/problems.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <numbers>

namespace gxrod::speed {

namespace {

const std::filesystem::path folder = GXROD_BENCHMARK_DIR;
constexpr double time_step = 1e-3;

// The nodes of a net: crossings, then those between, rod by rod, first all along x.
class Net {
  public:
    Net(int rods, int elements) : rods_(rods), elements_(elements) {
        for (int j = 0; j < rods; ++j) {
            for (int i = 0; i < rods; ++i) {
                add_node(spacing * Vec3(i, j, 0.0));
                if (i % (rods - 1) == 0 || j % (rods - 1) == 0) clamp();
            }
        }
        for (int j = 0; j < rods; ++j) add_rod(Vec3::UnitX(), j);
        for (int i = 0; i < rods; ++i) add_rod(Vec3::UnitY(), i);
    }

    Model model;

  private:
    static constexpr double spacing = 0.1;

    int add_node(const Vec3& position) {
        model.nodes.push_back({.name = "", .position = position});
        return static_cast<int>(model.nodes.size()) - 1;
    }
    void clamp() {
        const int node = static_cast<int>(model.nodes.size()) - 1;
        model.supports.push_back({.node = node, .fixed = {true, true, true, true, true, true}});
    }
    void add_rod(const Vec3& direction, int line) {
        const bool along_x = direction.x() > 0.0;
        const Quat axes = Quat::FromTwoVectors(Vec3::UnitX(), direction);
        Rod rod;
        rod.name = fmt::format("{}{}", along_x ? "x" : "y", line);
        std::vector<double> arc_length;
        for (int k = 0; k < rods_; ++k) {
            const int crossing = along_x ? line * rods_ + k : k * rods_ + line;
            rod.nodes.push_back(crossing);
            arc_length.push_back(spacing * k);
            for (int e = 1; e < elements_ && k + 1 < rods_; ++e) {
                const double s = spacing * (k + static_cast<double>(e) / elements_);
                rod.nodes.push_back(add_node(model.nodes[crossing].position + (s - spacing * k) * direction));
                arc_length.push_back(s);
            }
        }
        rod.length = arc_length.back();
        set_line_elements(rod, arc_length, std::vector<Quat>(rod.nodes.size(), axes));
        model.rods.push_back(rod);
    }

    int rods_, elements_;
};

}  // namespace

Problem make_pendulum(int elements, int order, long steps, ElementKind kind) {
    return read_problem(folder / "pendulum.toml",
                        {fmt::format("rod.rod.elements={}", elements),
                         fmt::format("rod.rod.order={}", order),
                         fmt::format("rod.rod.element={}", kind == ElementKind::simo ? "simo" : "objective"),
                         fmt::format("analysis.end_time={}", time_step * static_cast<double>(steps))});
}

Problem make_roll_up(int elements, int order, int steps) {
    return read_problem(folder / "roll_up.toml",
                        {fmt::format("rod.rod.elements={}", elements),
                         fmt::format("rod.rod.order={}", order),
                         fmt::format("analysis.steps={}", steps)});
}

Problem make_net(int rods, int elements, long steps) {
    Problem problem = make_pendulum(10, 1, steps);
    Net net(rods, elements);
    net.model.sections = problem.model.sections;
    net.model.gravity = TimeVector(Vec3(0.0, 0.0, -9.81));
    problem.model = std::move(net.model);
    problem.output.histories.clear();
    return problem;
}

}  // namespace gxrod::speed
