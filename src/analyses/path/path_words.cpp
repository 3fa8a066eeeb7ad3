#include "analyses/path/path_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solvers/worst_nodes.hpp"

namespace gxrod {

namespace {

std::string name_multiplicity(int multiplicity) {
    if (multiplicity <= 1) return "";
    if (multiplicity == 2) return "double ";
    if (multiplicity == 3) return "triple ";
    return fmt::format("{}-fold ", multiplicity);
}

const char* name_kind(CriticalKind kind) {
    if (kind == CriticalKind::limit) return "limit point";
    if (kind == CriticalKind::touch) return "contact begins";
    if (kind == CriticalKind::release) return "contact ends";
    return kind == CriticalKind::bifurcation ? "bifurcation" : "divergence";
}

std::string begin_sentence(const CriticalPoint& point) {
    if (point.is_located)
        return fmt::format("{}{} at λ = {:.10g}",
                           name_multiplicity(point.multiplicity),
                           name_kind(point.kind),
                           point.load_factor);
    return fmt::format(
        "{} within step {}, which ends at λ = {:.10g}", name_kind(point.kind), point.step, point.load_factor);
}

// A branch that is where the path is less stable is as stable as the path on the other side.
const char* describe_first_stability(const CriticalPoint& point) {
    const bool is_supercritical = point.branching == Branching::supercritical;
    const std::int64_t pivots = is_supercritical ? std::min(point.pivots_before, point.pivots_after)
                                                 : std::max(point.pivots_before, point.pivots_after);
    return pivots > 0 ? "unstable at first" : "stable at first";
}

std::string describe_branches(const CriticalPoint& point, std::ptrdiff_t count, bool has_potential) {
    std::string kind;
    if (point.branching == Branching::transcritical) return "another path crosses (transcritical)";
    if (point.branching == Branching::supercritical) kind = "supercritical pitchfork";
    if (point.branching == Branching::subcritical) kind = "subcritical pitchfork";
    if (!kind.empty() && has_potential) kind += std::string(", ") + describe_first_stability(point);
    if (!kind.empty()) return "two branches leave (" + kind + ")";
    if (count == 0) return "no branch was found";
    return count == 1 ? "a branch leaves, to one side only" : "two branches leave";
}

std::string describe_kernel(const CriticalPoint& point) {
    if (point.multiplicity == 1) return point.shape.empty() ? "" : "in the shape: " + point.shape;
    std::string words = fmt::format("the kernel of the tangent has dimension {}", point.multiplicity);
    if (!point.shape.empty()) words += ", one of its shapes: " + point.shape;
    return words;
}

std::string describe_path_beyond(const CriticalPoint& point) {
    if (point.pivots_before < 0 || point.pivots_after < 0 || point.pivots_before == point.pivots_after)
        return "";
    if (point.pivots_after == 0) return "the path beyond is stable";
    return fmt::format("the path beyond is unstable ({} negative pivot{})",
                       point.pivots_after,
                       point.pivots_after == 1 ? "" : "s");
}

// What happens at a point that was located.
std::string describe_event(const CriticalPoint& point, std::ptrdiff_t branches, bool has_potential) {
    if (point.kind == CriticalKind::limit) return "the load factor turns back";
    if (point.multiplicity > 1) return "which branches leave is not examined";
    if (point.pivots_before == point.pivots_after)
        return "the load factor turns back where another path crosses";
    return describe_branches(point, branches, has_potential);
}

std::string describe_point(const CriticalPoint& point, std::ptrdiff_t branches, bool has_potential) {
    std::vector<std::string> clauses;
    if (!is_critical(point.kind)) {
        clauses.push_back(point.shape);
    } else if (point.is_located) {
        clauses.push_back(describe_event(point, branches, has_potential));
        clauses.push_back(describe_kernel(point));
    }
    if (has_potential) clauses.push_back(describe_path_beyond(point));
    std::string sentence = begin_sentence(point);
    const char* separator = ": ";
    for (const std::string& clause : clauses) {
        if (clause.empty()) continue;
        sentence += separator + clause;
        separator = "; ";
    }
    return sentence;
}

}  // namespace

std::vector<std::string> describe_critical_points(std::span<const CriticalPoint> points,
                                                  std::span<const BranchStart> branches,
                                                  bool has_potential) {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::ptrdiff_t count = std::count_if(
            branches.begin(), branches.end(), [&](const BranchStart& start) { return start.point == i; });
        sentences.push_back(describe_point(points[i], count, has_potential));
    }
    return sentences;
}

std::string describe_symmetry(const System& system, const Eigen::VectorXd& direction) {
    const int count = static_cast<int>(system.model().nodes.size());
    int node = -1, component = 0;
    double largest = 0.0;
    for (int i = 0; i < count; ++i) {
        const Vec6 moves = system.equations().increment_of(i, direction);
        for (int k = 0; k < 3; ++k) {
            if (std::abs(moves[k]) <= largest) continue;
            largest = std::abs(moves[k]);
            node = i;
            component = k;
        }
    }
    const std::string text =
        "the tangent is singular all along the path, for the model has a continuous symmetry: it can move "
        "without a change of forces. Hold ";
    if (node < 0) return text + "one rotation against it";
    return text + "one displacement against it, such as that of " +
           name_place(system.model(), node, component);
}

std::string describe_followed_limit(double end, double load_factor) {
    return fmt::format(
        "limit point followed to t = {:.10g}, where its load factor is {:.10g}", end, load_factor);
}

}  // namespace gxrod
