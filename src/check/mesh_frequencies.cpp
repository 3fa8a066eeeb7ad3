#include "check/mesh_frequencies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assembly/contact/contacts.hpp"
#include "assembly/state_matrices.hpp"
#include "check/motions/free_parts.hpp"
#include "check/step_advice.hpp"
#include "linear/eigen/eigenvalue_count.hpp"
#include "linear/eigen/lowest_pairs.hpp"

namespace gxrod {

namespace {

// More unknowns are not examined: it would take longer than a user waits for a check.
constexpr std::int64_t most_unknowns = 100'000;

// Beyond so many the search for the lowest frequency, which passes them all, takes too long.
constexpr int most_rigid_motions = 60;

// The largest λ of K x = λ M x; nullopt if M has no inverse.
std::optional<double> find_largest(const SparsePattern& pattern,
                                   const std::vector<double>& K,
                                   const std::vector<double>& M) {
    EigenvalueCount factors(pattern);
    if (factors.factorize(M, 0.0, M) != 0) return std::nullopt;
    const Pencil pencil(pattern, K, M, factors.solver(), Pencil::InnerProduct::of_b);
    const EigenPairs pairs = gxrod::find_largest(pencil, {.wanted = 1, .tolerance = 1e-7});
    if (pairs.values.size() == 0) return std::nullopt;
    return pairs.values[0];
}

// The smallest but `rigid` ones that vanish.
std::optional<double> find_smallest(const SparsePattern& pattern,
                                    const std::vector<double>& K,
                                    const std::vector<double>& M,
                                    int rigid) {
    if (rigid > most_rigid_motions || rigid + 1 >= pattern.size()) return std::nullopt;
    const std::optional<LowestPairs> found = find_lowest_pairs(pattern, K, M, rigid + 1);
    if (!found || found->values.size() <= rigid) return std::nullopt;
    return found->values[rigid];
}

// Without loads, and at rest.
Model make_bare(Model model) {
    model.loads.clear();
    model.distributed_loads.clear();
    model.gravity = TimeVector(Vec3::Zero());
    for (Node& node : model.nodes) {
        node.velocity.setZero();
        node.angular_velocity.setZero();
    }
    return model;
}

// Whether anything is in something else, where contact has no stiffness.
bool has_overlaps(const System& system) {
    const Contacts contacts(system);
    State start = system.initial_state();
    contacts.search(start);
    return !contacts.describe_overlap(start, 0.0).empty();
}

// Of a section: ζ = ½(τω + α/ω).
double compute_damping_ratio(const Section& section, double omega) {
    return 0.5 * (section.kelvin_voigt * omega + section.mass_proportional / omega);
}

}  // namespace

std::optional<MeshFrequencies> find_mesh_frequencies(const Model& model) {
    const Model bare = make_bare(model);
    const System system(bare);
    const std::int64_t size = system.pattern().size();
    if (size < 2 || has_overlaps(system)) return std::nullopt;
    const StateMatrices matrices = compute_state_matrices(system, system.initial_state(), 0.0);
    const std::vector<double> stiffness = matrices.instantaneous_stiffness();
    const std::optional<double> largest = find_largest(system.pattern(), stiffness, matrices.mass);
    if (!largest || !(*largest > 0.0)) return std::nullopt;
    const int rigid = static_cast<int>(count_free_motions(bare));
    const std::optional<double> smallest = find_smallest(system.pattern(), stiffness, matrices.mass, rigid);
    if (!smallest || !(*smallest > 0.0)) return std::nullopt;
    return MeshFrequencies{std::sqrt(*smallest), std::sqrt(*largest), rigid};
}

std::string describe_frequencies(const Model& model, const DynamicSettings& settings) {
    constexpr double cycle = 2.0 * std::numbers::pi;
    if (model.rods.empty() || 6 * model.nodes.size() > most_unknowns) return "";
    const std::optional<MeshFrequencies> found = find_mesh_frequencies(model);
    if (!found) return "";
    std::string text =
        fmt::format("frequencies of the undeformed model, cycles per time: lowest {:.4g}{}, highest {:.4g}\n",
                    found->lowest / cycle,
                    found->rigid_motions == 0
                        ? ""
                        : fmt::format(" (in addition to {} of rigid motions)", found->rigid_motions),
                    found->highest / cycle);
    double largest_ratio = 0.0;
    for (const Section& section : model.sections) {
        largest_ratio = std::max(largest_ratio, compute_damping_ratio(section, found->highest));
        if (section.kelvin_voigt == 0.0 && section.mass_proportional == 0.0) continue;
        text +=
            fmt::format("  damping of section {}: {:.3g} of critical at the lowest, {:.3g} at the highest\n",
                        section.name,
                        compute_damping_ratio(section, found->lowest),
                        compute_damping_ratio(section, found->highest));
    }
    return text + describe_steps(*found, largest_ratio, settings, !model.contact.is_empty());
}

}  // namespace gxrod
