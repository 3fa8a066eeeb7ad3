#include "check/summaries/direction_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/findings/rod_straining.hpp"
#include "check/motions/free_motions.hpp"
#include "check/motions/weakest_direction.hpp"

namespace gxrod {

namespace {

constexpr double rigid = 1e-3;  // what a rigid motion may leave of a direction

struct Describer {
    const System& system;
    const State& state;
    std::vector<ModelPart> parts;

    std::string name(const ModelPart& part) const {
        return parts.size() == 1 ? "the whole model" : name_part(part, system.model());
    }
};

// The part that moves most.
const ModelPart& find_moving_part(const std::vector<ModelPart>& parts, const std::vector<Vec6>& direction) {
    const auto measure = [&direction](const ModelPart& part) {
        double square = 0.0;
        for (const int node : part.nodes) square += direction[node].squaredNorm();
        return square;
    };
    return *std::max_element(parts.begin(), parts.end(), [&](const ModelPart& a, const ModelPart& b) {
        return measure(a) < measure(b);
    });
}

// "" if it strains the part.
std::string describe_rigid(const Describer& describer,
                           const std::vector<Vec6>& direction,
                           const ModelPart& part) {
    const double length = describer.system.length_scale();
    const RigidFit fit = fit_rigid_motion(direction, part, describer.state, length);
    if (fit.remainder >= rigid && !part.rods.empty()) return "";
    return describer.name(part) + " " +
           describe_rigid_motion(fit.motion, part, describer.system, describer.state);
}

}  // namespace

std::string describe_rigid_direction(const System& system,
                                     const State& state,
                                     const std::vector<Vec6>& direction) {
    const Describer describer{system, state, find_parts(system.model(), Ties::rods)};
    return describe_rigid(describer, direction, find_moving_part(describer.parts, direction));
}

std::optional<Weakness> describe_weakness(const System& system,
                                          const State& state,
                                          const SparsePattern& pattern,
                                          const std::vector<double>& values) {
    const ScaledTangent tangent(system, pattern, values);
    const std::optional<WeakestDirection> weakest = find_weakest_direction(tangent);
    if (!weakest) return std::nullopt;
    Describer describer{system, state, find_parts(system.model(), Ties::rods)};
    std::vector<Vec6> direction(state.trial.size());
    for (std::size_t i = 0; i < direction.size(); ++i) {
        direction[i] = system.equations().increment_of(static_cast<int>(i), weakest->scaled);
    }
    // If nothing holds a part, inverse iteration finds any mixture of its free motions; list all of them.
    const ModelPart& part = find_moving_part(describer.parts, direction);
    const std::string words = describe_free_motions(part, tangent, system, state);
    if (!words.empty()) return Weakness{describer.name(part) + " " + words, weakest->stiffness};
    const std::string rigid_words = describe_rigid(describer, direction, part);
    return Weakness{rigid_words.empty() ? describe_straining(direction, part, system, state) : rigid_words,
                    weakest->stiffness};
}

}  // namespace gxrod
