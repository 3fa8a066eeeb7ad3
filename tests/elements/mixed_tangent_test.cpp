// The tangent whose geometric part is made of independent resultants, of every kind of element.

#include "elements/element_samples.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

template <int Nodes>
Linearizations<Nodes> at_every_node(const NodeLinearization& linearization) {
    Linearizations<Nodes> pointers;
    pointers.fill(&linearization);
    return pointers;
}

NodeLinearization make_linearization(double placement) {
    NodeLinearization linearization;
    linearization.placement = placement;
    return linearization;
}

// Of the strains of this motion.
template <Element E>
std::vector<Vec6> compute_resultants(const ElementSample<E>& sample,
                                     const typename ElementSample<E>::Nodal& nodal,
                                     const NodalVector<E::node_count>& increment) {
    std::vector<Vec6> resultants(E::point_count);
    sample.element.advance_resultants(sample.point_at(nodal), sample.histories, increment, resultants);
    return resultants;
}

template <Element E>
NodalMatrix<E::node_count> compute_mixed_tangent(const ElementSample<E>& sample,
                                                 const std::vector<Vec6>& resultants,
                                                 double placement = 1.0) {
    NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
    const NodeLinearization linearization = make_linearization(placement);
    sample.element.add_mixed_tangent(sample.point_at(sample.motions),
                                     sample.histories,
                                     resultants,
                                     at_every_node<E::node_count>(linearization),
                                     tangent);
    return tangent;
}

// A piece of rod, what it is made of, and a motion of it.
template <int Nodes, class Map>
struct RodSample {
    using Rod = InterpolatedRod<Nodes>;
    using Nodal = std::array<NodeMotion, Nodes>;

    RodPiece<Nodes> piece;
    RodElement<Nodes, Map> element;
    Nodal previous, motions;
    typename Rod::PointHistories histories;
    std::array<Vec6, Rod::point_count> resultants;  // of no strains

    explicit RodSample(RandomValues& random)
        : piece(make_rod_piece<Nodes>(random)), element(piece.geometry, piece.section) {
        const Vec3 theta = random.vector(0.8);
        for (int i = 0; i < Nodes; ++i) {
            previous[i].r = piece.geometry.positions[i] + random.vector(0.3);
            previous[i].Lambda = exp_quaternion(random.vector(0.4));
            place(previous[i], previous[i].r + random.vector(0.2), theta + random.vector(0.3), motions[i]);
        }
        for (Vec6& of_point : resultants) of_point << random.vector(2.0), random.vector(3.0);
        histories.fill({Quat::Identity(), Vec3::Zero()});
        if constexpr (Map::history_count > 0) {
            for (SectionHistory& history : histories) history = {random.rotation(), random.vector(0.6)};
        }
    }

    static Motions<Nodes> point_at(const Nodal& nodal) {
        Motions<Nodes> pointers;
        for (int i = 0; i < Nodes; ++i) pointers[i] = &nodal[i];
        return pointers;
    }
    Rod make_rod() const {
        Nodal reference;
        for (int i = 0; i < Nodes; ++i) reference[i].r = piece.geometry.positions[i];
        return Rod(Map(point_at(reference), piece.geometry.triads).local(),
                   histories,
                   ElementSections<Nodes>(std::make_shared<const RodSection>(piece.section)).at_forces,
                   piece.geometry.strains);
    }
    // Σ w Bᵀ S.
    NodalVector<Nodes> compute_force(const Nodal& nodal) const {
        const Map map(point_at(nodal), piece.geometry.triads);
        NodalVector<Nodes> force = NodalVector<Nodes>::Zero();
        map.add_force(make_rod().compute_force_of(map.local(), {.axes = histories}, resultants), force);
        return force;
    }
    NodalMatrix<Nodes> compute_tangent(Resultants of_points) const {
        const NodeLinearization placement = make_linearization(1.0);
        NodalMatrix<Nodes> tangent = NodalMatrix<Nodes>::Zero();
        element.add_mixed_tangent(
            point_at(motions), {.axes = histories}, of_points, at_every_node<Nodes>(placement), tangent);
        return tangent;
    }
};

template <int Nodes, class Map>
void check_geometric_part(const std::string& kind, RandomValues& random) {
    INFO(kind << " of " << Nodes << " nodes");
    const RodSample<Nodes, Map> sample(random);
    NodalMatrix<Nodes> expected;
    for (int unknown = 0; unknown < 6 * Nodes; ++unknown) {
        const int node = unknown / 6;
        expected.col(unknown) = differentiate([&](double amount) {
            auto nodal = sample.motions;
            nodal[node] = move(sample.previous[node], nodal[node], Vec6::Unit(unknown % 6), amount);
            return sample.compute_force(nodal);
        });
    }
    std::array<Vec6, Nodes - 1> none;
    none.fill(Vec6::Zero());
    const NodalMatrix<Nodes> geometric =
        sample.compute_tangent(sample.resultants) - sample.compute_tangent(none);
    CHECK(relative_difference(geometric, expected) < 1e-9);
}

template <int... Nodes>
void check_geometric_parts(unsigned seed, std::integer_sequence<int, Nodes...>) {
    RandomValues random(seed);
    (check_geometric_part<Nodes, ObjectiveMap<Nodes>>("objective", random), ...);
    (check_geometric_part<Nodes, SimoMap<Nodes>>("simo", random), ...);
}

}  // namespace

TEST_CASE("the mixed tangent of the strains' resultants is the consistent tangent", "[elements][mixed]") {
    for_each_sample([]<Element E>(const ElementSample<E>& sample) {
        INFO(sample.name);
        const NodeLinearization placement = make_linearization(0.7);
        NodalMatrix<E::node_count> consistent = NodalMatrix<E::node_count>::Zero();
        sample.element.add_internal_tangent(sample.point_at(sample.motions),
                                            sample.histories,
                                            at_every_node<E::node_count>(placement),
                                            consistent);
        const auto resultants =
            compute_resultants(sample, sample.motions, NodalVector<E::node_count>::Zero());
        CHECK(relative_difference(compute_mixed_tangent(sample, resultants, 0.7), consistent) < 1e-15);
        CHECK(compute_mixed_tangent(sample, resultants, 0.0).isZero(0.0));
    });
}

TEST_CASE("the mixed tangent's geometric part is the derivative of the force of fixed resultants",
          "[elements][mixed]") {
    for (const unsigned seed : {21U, 22U, 23U})
        check_geometric_parts(seed, std::integer_sequence<int, 2, 3, 4, 5>());
}

TEST_CASE("resultants advance as those of the strains do, to first order", "[elements][mixed]") {
    for_each_sample([]<Element E>(const ElementSample<E>& sample) {
        if constexpr (E::point_count > 0) {
            INFO(sample.name);
            RandomValues random(31);
            NodalVector<E::node_count> increment;
            for (int i = 0; i < 2 * E::node_count; ++i)
                increment.template segment<3>(3 * i) = random.vector(2.0);
            const auto of_strains = [&](double amount, int point) {
                auto nodal = sample.motions;
                for (int i = 0; i < E::node_count; ++i) {
                    const Vec6 direction = increment.template segment<6>(6 * i);
                    nodal[i] = move(sample.previous[i], nodal[i], direction, amount);
                }
                return compute_resultants(sample, nodal, NodalVector<E::node_count>::Zero())[point];
            };
            const auto advanced = compute_resultants(sample, sample.motions, increment);
            for (int point = 0; point < E::point_count; ++point) {
                const Vec6 slope = differentiate([&](double t) { return of_strains(t, point); }, 2e-3);
                CHECK(relative_difference(advanced[point], of_strains(0.0, point) + slope) < 1e-8);
            }
        }
    });
}
