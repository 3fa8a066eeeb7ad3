#include "watch/stress_words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gxrod {
namespace {

// "on post, s = 2, at (y, z) = (0.05, 0.1) of IPE 200, t = 0.3"
std::string describe_where(const Model& model,
                           const StressWatch& watch,
                           const StressEnvelope::Place& place,
                           const WorstStress& worst) {
    return fmt::format("on {}, s = {:.6g}, at (y, z) = ({:.4g}, {:.4g}) of {}, t = {:.6g}",
                       model.rods[static_cast<std::size_t>(place.at.rod)].name,
                       arc_length_at(model, place.at),
                       worst.at.x(),
                       worst.at.y(),
                       watch.shapes()[static_cast<std::size_t>(place.shapes.front().shape)].name,
                       worst.time);
}

}  // namespace

StressWords describe_stresses(const Model& model, const StressWatch& watch, const StressEnvelope& envelope) {
    StressWords words;
    const auto find_worst = [&](const std::vector<WorstStress>& all) {
        return static_cast<std::size_t>(std::ranges::max_element(all, {}, &WorstStress::value) - all.begin());
    };
    if (envelope.places().empty()) return words;
    const std::size_t most = find_worst(envelope.von_mises());
    words.findings.push_back(
        fmt::format("largest von Mises stress {:.6g} {}",
                    envelope.von_mises()[most].value,
                    describe_where(model, watch, envelope.places()[most], envelope.von_mises()[most])));
    const std::size_t nearest = find_worst(envelope.exposure());
    const WorstStress& exposed = envelope.exposure()[nearest];
    const StressEnvelope::Place& place = envelope.places()[nearest];
    if (exposed.value == 0.0) return words;
    const std::string where = describe_where(model, watch, place, exposed);
    words.findings.push_back(fmt::format("largest exposure {:.4g} {}", exposed.value, where));
    if (exposed.value > 1.0)
        words.warnings.push_back(
            fmt::format("exposure {:.4g} {}: the material fails there, and the run takes it as elastic",
                        exposed.value,
                        where));
    return words;
}

}  // namespace gxrod
