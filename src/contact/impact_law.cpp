#include "contact/impact_law.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// In skins. Increments that go far beyond a surface, again and again, would square a gap each time until its
// force is infinite.
constexpr double least_gap_of_iterates = 1e-12;

NormalForce compute_law_force(const ContactLaw& law, double gap) {
    return {compute_contact_force(law, gap), -compute_contact_force_slope(law, gap)};
}

// The mean force between two gaps. Where they are nearly the same, that half way, whose error is of their
// difference squared.
NormalForce compute_mean_force(const ContactLaw& law, double before, double gap) {
    const double change = gap - before;
    if (std::abs(change) < 1e-5 * std::min(before, gap)) {
        const NormalForce middle = compute_law_force(law, 0.5 * (before + gap));
        return {middle.force, 0.5 * middle.stiffness};
    }
    const double mean = -(compute_contact_energy(law, gap) - compute_contact_energy(law, before)) / change;
    return {mean, (mean - compute_contact_force(law, gap)) / change};
}

// Without damping.
NormalForce compute_undamped_force(const ImpactLaw& law, double gap) {
    const NormalForce at_end = compute_law_force(law.law, gap);
    if (law.dissipation == 1.0) return at_end;
    const NormalForce mean = compute_mean_force(law.law, law.gap_before, gap);
    const double theta = law.dissipation;
    return {(1.0 - theta) * mean.force + theta * at_end.force,
            (1.0 - theta) * mean.stiffness + theta * at_end.stiffness};
}

}  // namespace

NormalForce damp(const NormalForce& normal, double damping, double gap, double gap_before) {
    const double factor = 1.0 - damping * (gap - gap_before);
    if (factor <= 0.0) return {};
    return {factor * normal.force, factor * normal.stiffness + damping * normal.force};
}

NormalForce compute_impact_force(const ImpactLaw& law, double gap) {
    const NormalForce undamped = compute_undamped_force(law, gap);
    return law.damping == 0.0 ? undamped : damp(undamped, law.damping, gap, law.gap_before);
}

double find_gap_on_curve(const ImpactLaw& law, double force, double gap) {
    const double kappa = law.law.stiffness;
    const double skin = law.law.skin;
    const double zeta = force / kappa - gap / skin;
    double found = std::max(find_contact_point(law.law, zeta).gap, least_gap_of_iterates * skin);
    if (law.dissipation == 1.0 && law.damping == 0.0) return found;
    // h(g) = λ(g)/κ − g/ĝ falls from ∞: by Newton's method between bounds, in ln g.
    double low = 0.0, high = 0.0;
    for (int iteration = 0; iteration < 80; ++iteration) {
        const NormalForce at = compute_impact_force(law, found);
        const double excess = at.force / kappa - found / skin - zeta;
        if (std::abs(excess) <= 1e-13 * (1.0 + std::abs(zeta))) break;
        (excess > 0.0 ? low : high) = found;
        const double slope = -at.stiffness / kappa - 1.0 / skin;
        double next = found * std::exp(-excess / (slope * found));
        if (high > 0.0 && low > 0.0 && (next <= low || next >= high)) next = std::sqrt(low * high);
        if (next > 4.0 * found) next = 4.0 * found;
        if (next < 0.25 * found) next = 0.25 * found;
        // A mean over a long way grows with the logarithm of the gap alone: iterates may ask for more than
        // that.
        next = std::max(next, least_gap_of_iterates * skin);
        if (next == found) break;
        found = next;
    }
    return found;
}

}  // namespace gxrod
