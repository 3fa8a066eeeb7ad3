#include "check/direction_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/free_motions.hpp"
#include "check/rod_straining.hpp"
#include "check/weakest_direction.hpp"

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

std::string describe_direction(const Describer& describer, const std::vector<Vec6>& direction) {
    const ModelPart& part = find_moving_part(describer.parts, direction);
    const double length = describer.system.length_scale();
    const RigidFit fit = fit_rigid_motion(direction, part, describer.state, length);
    if (fit.remainder < rigid || part.rods.empty()) {
        return describer.name(part) + " " +
               describe_rigid_motion(fit.motion, part, describer.system, describer.state);
    }
    return describe_straining(direction, part, describer.system, describer.state);
}

}  // namespace

std::optional<Weakness> describe_weakness(const System& system,
                                          const State& state,
                                          const std::vector<double>& values) {
    const ScaledTangent tangent(system, values);
    const std::optional<WeakestDirection> weakest = find_weakest_direction(tangent);
    if (!weakest) return std::nullopt;
    Describer describer{system, state, find_parts(system.model())};
    std::vector<Vec6> direction(state.trial.size());
    for (std::size_t i = 0; i < direction.size(); ++i) {
        direction[i] = system.equations().increment_of(static_cast<int>(i), weakest->scaled);
    }
    // If nothing holds a part, inverse iteration finds any mixture of its free motions; list all of them.
    const ModelPart& part = find_moving_part(describer.parts, direction);
    const std::string words = describe_free_motions(part, tangent, system, state);
    if (!words.empty()) return Weakness{describer.name(part) + " " + words, weakest->stiffness};
    return Weakness{describe_direction(describer, direction), weakest->stiffness};
}

}  // namespace gxrod
