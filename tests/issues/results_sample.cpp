#include "issues/results_sample.hpp"

#include "deck/problem.hpp"
#include "deck/text/text_file.hpp"
#include "fuzz/scratch_folder.hpp"
#include "results/results_file.hpp"

namespace gxrod::test {
namespace {

constexpr int steps = 6;

const std::string deck = R"(title = "Sample"
units = "m kg s"
[section.s]
stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }
inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 3
[body.b]
at = "r.end"
mass = 2
inertia = [1, 1, 1]
[[load]]
at = "r.end"
force = [0, 0, "t"]
[[history]]
name = "tip"
at = "b"
quantities = ["position", "quaternion"]
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 6
[output]
compression = "deflate"
)";

// The model at rest; a step is as good as any other here.
struct Motion {
    explicit Motion(const Model& model) : reactions(model.nodes.size(), Vec6::Zero()) {
        for (const Node& node : model.nodes) {
            NodeMotion motion;
            motion.r = node.position;
            motion.Lambda = Quat::Identity();
            nodes.push_back(motion);
        }
        for (const Rod& rod : model.rods) {
            const SectionValues rest{
                Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), rod.triads.front()};
            elements.insert(elements.end(), static_cast<std::size_t>(rod.element_count()), rest);
        }
    }
    Snapshot at(double time) const { return {time, nodes, elements, reactions}; }

    std::vector<NodeMotion> nodes;
    std::vector<SectionValues> elements;
    std::vector<Vec6> reactions;
};

std::string make_sample() {
    const fuzz::ScratchFolder folder;
    const Problem problem = read_problem_text(deck, "sample.toml");
    const Motion motion(problem.model);
    const std::filesystem::path path = folder.path() / "sample.vtkhdf";
    ResultsFile file({path}, problem.record, problem.model, problem.output);
    for (int step = 0; step < steps; ++step) {
        const double time = static_cast<double>(step) / steps;
        file.record_step(motion.at(time), {}, {1.0 / steps, 3, 1e-9, 0});
        file.write_frame(motion.at(time));
        RestartRecord record;
        record.nodes = motion.nodes;
        record.ledger.forces.assign(motion.nodes.size(), Vec6::Zero());
        record.steps.time = time;
        file.set_restart(record);
        file.flush();
    }
    file.close(RunStatus::interrupted, "");
    return read_text_file(path);
}

}  // namespace

const std::string& results_sample() {
    static const std::string sample = make_sample();
    return sample;
}

}  // namespace gxrod::test
