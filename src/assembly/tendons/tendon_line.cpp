#include "assembly/tendons/tendon_line.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "assembly/element_geometry.hpp"
#include "elements/rod/tendon_slopes.hpp"

namespace gxrod {

class TendonLine::Piece {
  public:
    struct WeightedStretch {
        double weight, stretch;
    };
    struct TangentRequest {
        bool at_start, at_end;
        Eigen::Index columns;  // of gradients; 0: without
    };

    virtual ~Piece() = default;
    // Appends the tendon's stretches at the element's force points at t = 0, and their weights.
    virtual void add_start(const std::vector<Node>& nodes, std::vector<WeightedStretch>& stretches) const = 0;
    virtual double compute_length(const std::vector<NodeMotion>& motions, const State& state) const = 0;
    virtual void add_gradient(const std::vector<NodeMotion>& motions,
                              const State& state,
                              Eigen::VectorXd& gradient) const = 0;
    virtual void add_hessian(const std::vector<NodeMotion>& motions,
                             const State& state,
                             Eigen::MatrixXd& hessian) const = 0;
    // Of the element's force points, and of its start or its end where the tendon's is there.
    virtual void add_tangents(const std::vector<NodeMotion>& motions,
                              const State& state,
                              TangentRequest request,
                              std::vector<TendonTangent>& tangents) const = 0;
};

namespace {

// An element without any stiffness, pulled by a tension of 1: its potential is the tendon's length.
template <class E>
class PieceOf final : public TendonLine::Piece {
  public:
    static constexpr int count = E::node_count;

    // `places`: of the element's nodes among the tendon's.
    PieceOf(const RodElementGeometry<count>& geometry,
            std::vector<PointDrive> drives,
            const std::vector<int>& places,
            std::size_t first_history)
        : element_(geometry, Section{}), drives_(std::move(drives)), first_history_(first_history) {
        for (int i = 0; i < count; ++i) rows_[i] = 6 * Eigen::Index{places[i]};
    }

    void add_start(const std::vector<Node>& nodes, std::vector<WeightedStretch>& stretches) const override {
        std::array<NodeMotion, count> start;
        Motions<count> pointers;
        for (int i = 0; i < count; ++i) {
            start[i].r = nodes[element_.nodes[i]].position;
            pointers[i] = &start[i];
        }
        std::array<SectionHistory, E::history_count + 1> axes;  // one more: none has a size of zero
        const std::span<SectionHistory> own(axes.data(), E::history_count);
        element_.start(own);
        for (const DrivenPoint& point : list_points(pointers, {.axes = own, .drives = drives_}))
            stretches.push_back({point.weight, point.pulls.front().stretch});
    }

    double compute_length(const std::vector<NodeMotion>& motions, const State& state) const override {
        double length = 0.0;
        for (const DrivenPoint& point : list_points(motions_of(motions), histories(state)))
            length += point.weight * point.pulls.front().stretch;
        return length;
    }

    void add_gradient(const std::vector<NodeMotion>& motions,
                      const State& state,
                      Eigen::VectorXd& gradient) const override {
        NodalVector<count> force = NodalVector<count>::Zero();
        element_.add_internal_force(motions_of(motions), histories(state), force);
        for (int i = 0; i < count; ++i) gradient.segment<6>(rows_[i]) += force.template segment<6>(6 * i);
    }

    void add_hessian(const std::vector<NodeMotion>& motions,
                     const State& state,
                     Eigen::MatrixXd& hessian) const override {
        const NodeLinearization placed{.placement = 1.0};
        Linearizations<count> linearizations;
        linearizations.fill(&placed);
        NodalMatrix<count> tangent = NodalMatrix<count>::Zero();
        element_.add_internal_tangent(motions_of(motions), histories(state), linearizations, tangent);
        for (int j = 0; j < count; ++j) {
            for (int i = 0; i < count; ++i)
                hessian.block<6, 6>(rows_[i], rows_[j]) += tangent.template block<6, 6>(6 * i, 6 * j);
        }
    }

    void add_tangents(const std::vector<NodeMotion>& motions,
                      const State& state,
                      TangentRequest request,
                      std::vector<TendonTangent>& tangents) const override {
        const bool with_gradients = request.columns > 0;
        const TendonSlopes<count> slopes =
            compute_tendon_slopes(element_, motions_of(motions), histories(state), with_gradients);
        const std::size_t first = request.at_start ? 0 : 1;
        const std::size_t end = slopes.size() - (request.at_end ? 0 : 1);
        for (std::size_t i = first; i < end; ++i) {
            TendonTangent& tangent = tangents.emplace_back(slopes[i].weight, slopes[i].slope);
            if (!with_gradients) continue;
            tangent.gradient = Eigen::Matrix3Xd::Zero(3, request.columns);
            for (int k = 0; k < count; ++k)
                tangent.gradient.middleCols<6>(rows_[k]) += slopes[i].gradient.template middleCols<6>(6 * k);
        }
    }

  private:
    std::vector<DrivenPoint> list_points(const Motions<count>& motions, Histories histories) const {
        std::vector<DrivenPoint> points;
        element_.add_driven_points(motions, histories, points);
        return points;
    }
    Motions<count> motions_of(const std::vector<NodeMotion>& nodes) const {
        Motions<count> motions;
        for (int i = 0; i < count; ++i) motions[i] = &nodes[element_.nodes[i]];
        return motions;
    }
    Histories histories(const State& state) const {
        Histories known{.drives = drives_};
        if constexpr (E::history_count > 0)
            known.axes = std::span(state.sections).subspan(first_history_, E::history_count);
        return known;
    }

    E element_;
    std::vector<PointDrive> drives_;
    std::array<Eigen::Index, count> rows_;
    std::size_t first_history_;
};

// Of a rod's first element in State::sections, where elements that have histories come by their order, then
// rod by rod.
std::size_t find_first_history(const Model& model, const Rod& rod) {
    std::size_t first = 0;
    for (const Rod& other : model.rods) {
        const bool is_before = other.order < rod.order || (other.order == rod.order && &other < &rod);
        if (other.kind == ElementKind::simo && is_before)
            first += static_cast<std::size_t>(other.element_count()) * static_cast<std::size_t>(other.order);
    }
    return first;
}

// A tension of 1 at the force points of an element.
std::vector<PointDrive> make_drives(const Tendon& tendon, std::span<const double> points) {
    std::vector<PointDrive> drives;
    for (const double s : points) {
        const TendonPlace place = tendon.path(s);
        drives.emplace_back().pulls.push_back({1.0, place.at, place.slope});
    }
    return drives;
}

}  // namespace

TendonLine::TendonLine(const Model& model, const Tendon& tendon) {
    const Rod& rod = model.rods[static_cast<std::size_t>(tendon.rod)];
    const auto order = static_cast<std::size_t>(rod.order);
    const std::vector<double> points = list_force_points(rod);
    const std::size_t first_history = find_first_history(model, rod);
    // A rod that closes on itself has its first node twice.
    const auto find_node = [&](int node) {
        const auto found = std::ranges::find(nodes_, node);
        const auto index = static_cast<int>(found - nodes_.begin());
        if (found == nodes_.end()) nodes_.push_back(node);
        return index;
    };
    const auto add = [&]<int Nodes, template <int> class Element>(int e, const std::vector<int>& places) {
        const auto place = static_cast<std::size_t>(e) * order;
        pieces_.push_back(std::make_shared<const PieceOf<Element<Nodes>>>(
            find_geometry<Nodes>(model, rod, e),
            make_drives(tendon, std::span(points).subspan(place, order)),
            places,
            first_history + place));
    };
    for (int e = 0; e < rod.element_count(); ++e) {
        const auto first = static_cast<std::size_t>(e) * (order + 1);
        const double middle = 0.5 * (rod.arc_length[first] + rod.arc_length[first + order]);
        if (middle < tendon.from || middle >= tendon.to) continue;
        std::vector<int> places;
        for (std::size_t i = 0; i <= order; ++i) places.push_back(find_node(rod.element_nodes[first + i]));
        visit_node_count(rod.order, [&](auto node_count) {
            if (rod.kind == ElementKind::simo) {
                add.template operator()<node_count, SimoElement>(e, places);
            } else {
                add.template operator()<node_count, ObjectiveElement>(e, places);
            }
        });
    }
    std::vector<Piece::WeightedStretch> start;
    for (const auto& piece : pieces_) piece->add_start(model.nodes, start);
    for (const auto& [weight, stretch] : start) {
        start_length_ += weight * stretch;
        start_stretches_.push_back(stretch);
    }
}

double TendonLine::compute_length(const std::vector<NodeMotion>& motions, const State& state) const {
    double length = 0.0;
    for (const auto& piece : pieces_) length += piece->compute_length(motions, state);
    return length;
}

Eigen::VectorXd TendonLine::compute_gradient(const std::vector<NodeMotion>& motions,
                                             const State& state) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size());
    for (const auto& piece : pieces_) piece->add_gradient(motions, state, gradient);
    return gradient;
}

Eigen::MatrixXd TendonLine::compute_hessian(const std::vector<NodeMotion>& motions,
                                            const State& state) const {
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size(), size());
    for (const auto& piece : pieces_) piece->add_hessian(motions, state, hessian);
    return hessian;
}

std::vector<TendonTangent> TendonLine::list_tangents(const std::vector<NodeMotion>& motions,
                                                     const State& state,
                                                     bool with_gradients) const {
    std::vector<TendonTangent> tangents;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece::TangentRequest request{
            i == 0, i + 1 == pieces_.size(), with_gradients ? size() : Eigen::Index{0}};
        pieces_[i]->add_tangents(motions, state, request, tangents);
    }
    return tangents;
}

}  // namespace gxrod
