#include "check/summaries/rod_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "check/summaries/rod_summary.hpp"
#include "model/parts.hpp"

namespace gxrod {
namespace {

// Of a solid round rod as long as thick it is 4.
constexpr double least_slenderness = 4.0;
// A turn of the tangent in one element above which a mesh is called coarse.
constexpr double coarse_turn = M_PI / 4.0;
// The cosine of the bend between rods that continue into each other.
constexpr double least_cosine = 0.5;

struct RodEnd {
    int rod = 0;
    Vec3 outward;  // the tangent that leaves the rod
};

// The ends of rods at each node; nets have none.
std::vector<std::vector<RodEnd>> find_ends(const Model& model) {
    std::vector<std::vector<RodEnd>> ends(model.nodes.size());
    for (int r = 0; r < static_cast<int>(model.rods.size()); ++r) {
        const Rod& rod = model.rods[r];
        ends[rod.element_nodes.front()].push_back({r, -(rod.triads.front() * Vec3::UnitX())});
        ends[rod.element_nodes.back()].push_back({r, rod.triads.back() * Vec3::UnitX()});
    }
    return ends;
}

// Sets of rods, each known by one of them.
class RodSets {
  public:
    explicit RodSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
    int find(int rod) {
        while (parents_[rod] != rod) rod = parents_[rod] = parents_[parents_[rod]];
        return rod;
    }
    void join(int a, int b) { parents_[find(a)] = find(b); }

  private:
    std::vector<int> parents_;
};

// Pairs of ends at one node, the straightest first; each end continues into one other at most.
void join_ends(const std::vector<RodEnd>& ends, RodSets& sets) {
    struct Pair {
        double cosine;
        std::size_t first, second;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const double cosine = -ends[i].outward.dot(ends[j].outward);
            if (cosine > least_cosine) pairs.push_back({cosine, i, j});
        }
    }
    std::stable_sort(
        pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cosine > b.cosine; });
    std::vector<bool> is_taken(ends.size(), false);
    for (const Pair& pair : pairs) {
        if (is_taken[pair.first] || is_taken[pair.second]) continue;
        is_taken[pair.first] = is_taken[pair.second] = true;
        sets.join(ends[pair.first].rod, ends[pair.second].rod);
    }
}

// "rods a, b, c, d and 380 more are".
std::string list_rods(const std::vector<std::string>& names) {
    constexpr std::ptrdiff_t most = 4;
    const std::ptrdiff_t count = std::ssize(names);
    const std::ptrdiff_t named = std::min(count, most);
    std::string text =
        fmt::format("rod{} {}", count == 1 ? "" : "s", fmt::join(names.begin(), names.begin() + named, ", "));
    if (named < count) text += fmt::format(" and {} more", count - named);
    return text + (count == 1 ? " is" : " are");
}

}  // namespace

double compute_slenderness(const Section& section, double length) {
    const Mat6& C = section.stiffness;
    return length * std::sqrt(C(0, 0) / std::min(C(4, 4), C(5, 5)));
}

std::vector<double> measure_lines(const Model& model) {
    RodSets sets(model.rods.size());
    for (const std::vector<RodEnd>& ends : find_ends(model)) join_ends(ends, sets);
    std::vector<double> sums(model.rods.size(), 0.0);
    const auto count = static_cast<int>(model.rods.size());
    for (int rod = 0; rod < count; ++rod) sums[sets.find(rod)] += model.rods[rod].length;
    std::vector<double> lengths(model.rods.size());
    for (int rod = 0; rod < count; ++rod) lengths[rod] = sums[sets.find(rod)];
    return lengths;
}

std::string describe_thick_rods(const Model& model) {
    const std::vector<double> lengths = measure_lines(model);
    std::vector<int> thick;
    for (const ModelPart& part : find_parts(model)) {
        const bool is_thick = std::all_of(part.rods.begin(), part.rods.end(), [&](int rod) {
            return compute_slenderness(model.sections[model.rods[rod].section], lengths[rod]) <
                   least_slenderness;
        });
        // With a slender line in the part its units agree: the rest are stubs and stiff links.
        if (is_thick) thick.insert(thick.end(), part.rods.begin(), part.rods.end());
    }
    // The deck asks about shapes on cells, whose size it knows.
    std::erase_if(thick, [&](int rod) { return model.sections[model.rods[rod].section].shape != nullptr; });
    if (thick.empty()) return "";
    std::sort(thick.begin(), thick.end());
    thick.erase(std::unique(thick.begin(), thick.end()), thick.end());
    std::vector<std::string> names;
    for (const int rod : thick) names.push_back(model.rods[rod].name);
    return list_rods(names) + " thicker than long; are all lengths in one unit?";
}

std::string describe_coarse_rods(const Model& model) {
    std::vector<std::string> names;
    double largest = 0.0;
    for (const Rod& rod : model.rods) {
        const double turn = compute_largest_turn(rod);
        if (turn <= coarse_turn) continue;
        names.push_back(rod.name);
        largest = std::max(largest, turn);
    }
    if (names.empty()) return "";
    return fmt::format(
        "{} bent by up to {:.3g}° in one element; more elements, or a higher order, would follow the curve",
        list_rods(names),
        largest * 180.0 / M_PI);
}

}  // namespace gxrod
