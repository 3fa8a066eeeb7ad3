#include "deck/joints/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "deck/joints/ends.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/places/part.hpp"
#include "numerics/smooth_line.hpp"

namespace gxrod {
namespace {

// How far a point may be from the line, relative to the distance of its nodes: by so much a line through
// nodes can miss a curved rod.
constexpr double largest_distance = 1e-3;
constexpr int samples = 8;  // of a piece of the line, from which the nearest place is sought
constexpr int iterations = 50;

// The place of a line that is nearest to a point.
struct Nearest {
    double place = 0.0;
    Vec3 position = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();
    double spacing = 0.0;  // of the nodes there
};

class LineSearch {
  public:
    LineSearch(const Model& model, const Rod& rod, const Vec3& point)
        : model_(model), rod_(rod), line_(arc_lengths_of_nodes(rod)), point_(point) {}

    Nearest find() const {
        Nearest nearest;
        for (const SmoothLine::Piece& piece : line_.pieces()) {
            for (int i = 0; i <= samples; ++i) {
                const double s = piece.start + piece.length * i / samples;
                const double distance = (evaluate(s)[0] - point_).norm();
                if (distance < nearest.distance) nearest = {s, evaluate(s)[0], distance, piece.length};
            }
        }
        refine(nearest);
        return nearest;
    }

  private:
    // r, r', r''.
    std::array<Vec3, 3> evaluate(double s) const {
        const SmoothLine::Piece& piece = line_.pieces()[static_cast<std::size_t>(line_.find_piece(s))];
        const auto weights = piece.compute_weights<3>(s);
        std::array<Vec3, 3> r;
        r.fill(Vec3::Zero());
        for (std::size_t order = 0; order < r.size(); ++order) {
            for (int i = 0; i < piece.count; ++i)
                r[order] += weights[order][static_cast<std::size_t>(i)] *
                            model_.nodes[rod_.nodes[piece.first + i]].position;
        }
        return r;
    }

    void refine(Nearest& nearest) const {
        for (int i = 0; i < iterations; ++i) {
            const auto [r, tangent, bend] = evaluate(nearest.place);
            const double slope = tangent.squaredNorm() - (point_ - r).dot(bend);
            if (slope <= 0.0) break;
            nearest.place =
                std::clamp(nearest.place + (point_ - r).dot(tangent) / slope, line_.start(), line_.end());
        }
        nearest.position = evaluate(nearest.place)[0];
        nearest.distance = (point_ - nearest.position).norm();
    }

    const Model& model_;
    const Rod& rod_;
    SmoothLine line_;
    const Vec3 point_;
};

// A line from its start to its end, without branches.
bool is_line(const Rod& rod) {
    return !rod.nodes.empty() && static_cast<int>(rod.nodes.size()) == rod.element_count() * rod.order + 1 &&
           rod.element_nodes.front() == rod.nodes.front() && rod.element_nodes.back() == rod.nodes.back();
}

class SleeveBuilder {
  public:
    SleeveBuilder(const JointTable& given, const BuildContext& context) : given_(given), context_(context) {}

    std::optional<Sleeve> build() const {
        check_coordinates(given_, context_);
        const auto index = find_index(context_.deck.tables("rod"), given_.between[0].word);
        if (!index || context_.model.rods[*index].nodes.empty()) return std::nullopt;  // a fault elsewhere
        const std::optional<Anchor> anchor = find_anchor(given_, given_.between[1], given_.at, context_);
        if (!anchor) return std::nullopt;
        Sleeve sleeve{.name = given_.name, .rod = static_cast<int>(*index), .point = *anchor};
        sleeve.holds_turn = !given_.turn.value_or(true);
        const Rod& rod = context_.model.rods[*index];
        if (!is_line(rod)) {
            add_fault(fmt::format(
                "rod {} branches or comes back to its start; expected a rod that is one line", rod.name));
            return std::nullopt;
        }
        if (std::ranges::count(rod.nodes, anchor->node) > 0) {
            add_fault(
                fmt::format("\"{}\" is a point of rod {}, which cannot slide along itself; expected a point "
                            "of another part",
                            given_.between[1].word,
                            rod.name));
            return std::nullopt;
        }
        return place(rod, sleeve) ? std::optional<Sleeve>(std::move(sleeve)) : std::nullopt;
    }

  private:
    void add_fault(const std::string& message) const { context_.add_fault(given_, given_.between, message); }

    // On the line, to which the point is moved by as much as the line misses the rod.
    bool place(const Rod& rod, Sleeve& sleeve) const {
        const Model& model = context_.model;
        const Vec3 point = find_place(model, sleeve.point);
        const Nearest nearest = LineSearch(model, rod, point).find();
        sleeve.place = nearest.place;
        sleeve.point.arm += nearest.position - point;
        if (nearest.distance <= largest_distance * nearest.spacing) return true;
        const std::string message = fmt::format(
            "the point is {:.6g} from rod {}; expected a point on it: the nearest is [{:.9g}, "
            "{:.9g}, {:.9g}]",
            nearest.distance,
            rod.name,
            nearest.position[0],
            nearest.position[1],
            nearest.position[2]);
        if (given_.at)
            context_.add_fault(given_, given_.at, message);
        else
            add_fault(message);
        return false;
    }

    const JointTable& given_;
    const BuildContext& context_;
};

}  // namespace

void build_sleeves(BuildContext& context) {
    for (const JointTable& given : tables_of<JointTable>(context.deck, joint_table())) {
        if (!given.is_sleeve()) continue;
        if (std::optional<Sleeve> sleeve = SleeveBuilder(given, context).build())
            context.model.sleeves.push_back(std::move(*sleeve));
    }
}

void build_sleeve_actions(BuildContext& context) {
    for (Sleeve& sleeve : context.model.sleeves) {
        const JointTable& given = *find_joint(context.deck, sleeve.name);
        const double length = context.model.rods[sleeve.rod].length;
        sleeve.slide = build_slide(given, length, context);
        check_motors(given, length, context);
    }
}

}  // namespace gxrod
