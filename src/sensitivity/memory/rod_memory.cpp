#include "sensitivity/memory/rod_memory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "assembly/system_values.hpp"
#include "integrators/newmark.hpp"
#include "rotation/rotation_map.hpp"
#include "sensitivity/difference_at_zero.hpp"
#include "sensitivity/memory/weighed_law.hpp"

namespace gxrod {

namespace {

// Shape functions at a force point, their slopes by arc length and its weight.
template <int Nodes>
struct ShapeAtPoint {
    NodeValues<Nodes> shape, slope;
    double weight;
};

template <int Nodes>
ShapeAtPoint<Nodes> find_shape(const InterpolatedRod<Nodes>& rod, int point) {
    static const auto rule = compute_gauss_rule<Nodes - 1>();
    const auto& [xi, weight] = rule[static_cast<std::size_t>(point)];
    const double jacobian = rod.reference(point).jacobian;
    return {
        compute_shape_functions<Nodes>(xi), compute_shape_slopes<Nodes>(xi) / jacobian, weight * jacobian};
}

template <int Nodes>
SectionFields interpolate(const ShapeAtPoint<Nodes>& point, const LocalMotion<Nodes>& motion) {
    return {motion.r * point.slope, motion.theta * point.shape, motion.theta * point.slope};
}

// Adds a force conjugate to (r′, θ, θ′) to the forces on the nodes' local motions.
template <int Nodes>
void add_density(const ShapeAtPoint<Nodes>& point, const Vec9& density, NodalVector<Nodes>& force) {
    for (int i = 0; i < Nodes; ++i) {
        force.template segment<3>(6 * i) += point.slope[i] * density.template head<3>();
        force.template segment<3>(6 * i + 3) +=
            point.shape[i] * density.template segment<3>(3) + point.slope[i] * density.template tail<3>();
    }
}

// A rod element that remembers, at the trial motions.
template <int Nodes, class Map>
class RememberingElement {
  public:
    static constexpr int points = Nodes - 1;
    static constexpr bool turns = Map::history_count > 0;  // whether it measures rotations from its memory
    using Element = RodElement<Nodes, Map>;
    using Rod = InterpolatedRod<Nodes>;

    RememberingElement(const Element& element, const Motions<Nodes>& motions, const Histories& histories)
        : element_(element),
          rod_(element.interpolated_rod()),
          motions_(motions),
          histories_(histories),
          map_(motions, element.triads()) {
        for (int p = 0; p < points; ++p) {
            shapes_[p] = find_shape<Nodes>(rod_, p);
            axes_[p] = turns ? histories.axes[p] : SectionHistory{Quat::Identity(), Vec3::Zero()};
            fields_[p] = interpolate(shapes_[p], map_.local());
            strains_[p] = compute_strain(fields_[p], axes_[p], rod_.reference(p).strain);
            gradients_[p] = compute_strain_gradient(fields_[p], axes_[p]);
        }
    }

    // (∂M/∂(r, φ))ᵀ μ.
    NodalVector<Nodes> compute_by_placements(std::span<const double> numbers,
                                             std::span<const StateDirection::OfSection> sections) const {
        NodalVector<Nodes> local = NodalVector<Nodes>::Zero(), nodal = NodalVector<Nodes>::Zero();
        visit_laws([&](int p, const WeighedLaw& law, std::size_t first, std::size_t count) {
            const Vec6 by_strain = law.differentiate_by_strain(numbers.subspan(first, count));
            add_density<Nodes>(shapes_[p], gradients_[p].transpose() * by_strain, local);
        });
        map_.add_force(local, nodal);
        if constexpr (turns) {
            const auto weigh = [&](const Motions<Nodes>& motions, const Axes& axes) {
                return weigh_axes(Map(motions, element_.triads()), axes, sections);
            };
            for (int i = 0; i < Nodes; ++i) {
                MotionGradient::OfNode here, before;
                transpose_turn(motions_[i]->theta, differentiate_by_turn(i, weigh), here, before);
                nodal.template segment<3>(6 * i + 3) += here.phi;
            }
        }
        return nodal;
    }

    // (∂M/∂m)ᵀ μ − (∂R/∂m)ᵀ ξ.
    void add_by_memory(const NodalVector<Nodes>& xi,
                       std::span<const double> numbers,
                       std::span<const StateDirection::OfSection> sections,
                       std::span<double> numbers_before,
                       std::span<StateDirection::OfSection> sections_before,
                       std::array<Vec3, Nodes>& spins_before) const {
        std::array<Vec6, points> by_strain;
        by_strain.fill(Vec6::Zero());
        visit_laws([&](int p, const WeighedLaw& law, std::size_t first, std::size_t count) {
            const auto after = numbers.empty() ? numbers : numbers.subspan(first, count);
            law.add_by_memory(
                shapes_[p].weight * find_virtual_strain(p, xi), after, numbers_before.subspan(first, count));
            if (turns) by_strain[p] = law.differentiate_by_strain(after);
        });
        if constexpr (turns) {
            std::array<SectionResponse, points> responses;
            for (int p = 0; p < points; ++p) responses[p] = rod_.respond(p, strains_[p], histories_);
            add_by_axes(
                [&](const Motions<Nodes>& motions, const Axes& axes) {
                    const Map map(motions, element_.triads());
                    double sum = -xi.dot(compute_force(motions, map, axes, responses));
                    if (sections.empty()) return sum;
                    for (int p = 0; p < points; ++p)
                        sum += by_strain[p].dot(find_strain(p, map, axes) - strains_[p]);
                    return sum + weigh_axes(map, axes, sections);
                },
                sections_before,
                spins_before);
        }
    }

    void list_steps(std::span<double> steps) const {
        visit_laws([&](int, const WeighedLaw& law, std::size_t first, std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) steps[first + i] = law.find_step(i);
        });
    }

  private:
    using Axes = std::array<SectionHistory, points>;

    // Calls visit(point, law, first number of the law in the element's memory, how many) for laws that
    // remember.
    template <class Visit>
    void visit_laws(const Visit& visit) const {
        std::size_t first = 0;
        for (int p = 0; p < points; ++p) {
            const auto count = static_cast<std::size_t>(rod_.section(p).memory_size());
            if (count == 0) continue;
            Vec6 strain = strains_[p];
            if (!histories_.drives.empty()) strain -= histories_.drives[p].strain;
            visit(p,
                  WeighedLaw(
                      rod_.section(p), strain, histories_.memory.subspan(first, count), histories_.elapsed),
                  first,
                  count);
            first += count;
        }
    }

    Vec6 find_strain(int p, const Map& map, const Axes& axes) const {
        return compute_strain(interpolate(shapes_[p], map.local()), axes[p], rod_.reference(p).strain);
    }

    // The strain of (δr, δφ) of the nodes, to first order.
    Vec6 find_virtual_strain(int p, const NodalVector<Nodes>& xi) const {
        std::array<NodeMotion, Nodes> moving;
        Motions<Nodes> pointers;
        for (int i = 0; i < Nodes; ++i) {
            moving[i] = *motions_[i];
            moving[i].v = xi.template segment<3>(6 * i);
            moving[i].omega = xi.template segment<3>(6 * i + 3);
            pointers[i] = &moving[i];
        }
        const SectionFields rates = interpolate(shapes_[p], map_.compute_rates(pointers));
        Vec9 all;
        all << rates.r_prime, rates.theta, rates.theta_prime;
        return gradients_[p] * all;
    }

    // Forces on the nodes, with resultants that follow the strains to first order.
    NodalVector<Nodes> compute_force(const Motions<Nodes>& motions,
                                     const Map& map,
                                     const Axes& axes,
                                     const std::array<SectionResponse, points>& responses) const {
        NodalVector<Nodes> local = NodalVector<Nodes>::Zero(), nodal = NodalVector<Nodes>::Zero();
        for (int p = 0; p < points; ++p) {
            const Vec6 resultants =
                responses[p].resultants + responses[p].tangent * (find_strain(p, map, axes) - strains_[p]);
            const SectionFields fields = interpolate(shapes_[p], map.local());
            add_density<Nodes>(
                shapes_[p],
                shapes_[p].weight * (compute_strain_gradient(fields, axes[p]).transpose() * resultants),
                local);
        }
        map.add_force(local, nodal);
        Histories moved = histories_;
        moved.axes = axes;
        element_.add_viscous_force(motions, moved, nodal);
        return nodal;
    }

    // The change of μ · (axes and curvatures after the step).
    double weigh_axes(const Map& map,
                      const Axes& axes,
                      std::span<const StateDirection::OfSection> after) const {
        double sum = 0.0;
        for (int p = 0; p < points; ++p) {
            const SectionFields fields = interpolate(shapes_[p], map.local());
            const Quat turn = compute_section_axes(fields.theta, axes[p]) *
                              compute_section_axes(fields_[p].theta, axes_[p]).conjugate();
            sum +=
                after[p].phi.dot(log(turn)) + after[p].K.dot(compute_total_curvature(fields, axes[p]) -
                                                             compute_total_curvature(fields_[p], axes_[p]));
        }
        return sum;
    }

    // By the rotation vector of a node at the same placement.
    template <class Weigh>
    Vec3 differentiate_by_turn(int node, const Weigh& weigh) const {
        Vec3 gradient;
        NodeMotion moved = *motions_[node];
        Motions<Nodes> motions = motions_;
        motions[node] = &moved;
        for (Eigen::Index k = 0; k < 3; ++k) {
            gradient[k] = differentiate_at_zero(
                [&](double amount) {
                    moved.theta[k] = motions_[node]->theta[k] + amount;
                    return weigh(motions, axes_);
                },
                step);
            moved.theta[k] = motions_[node]->theta[k];
        }
        return gradient;
    }

    // By sections before the step, and through rotation vectors by the nodes' axes before it.
    template <class Weigh>
    void add_by_axes(const Weigh& weigh,
                     std::span<StateDirection::OfSection> sections_before,
                     std::array<Vec3, Nodes>& spins_before) const {
        for (int p = 0; p < points; ++p) {
            const double length = 2.0 * rod_.reference(p).jacobian;
            Axes axes = axes_;
            for (Eigen::Index k = 0; k < 3; ++k) {
                sections_before[p].phi[k] += differentiate_at_zero(
                    [&](double amount) {
                        axes[p].Lambda = exp_quaternion(amount * Vec3::Unit(k)) * axes_[p].Lambda;
                        return weigh(motions_, axes);
                    },
                    step);
                axes[p] = axes_[p];
                sections_before[p].K[k] += differentiate_at_zero(
                    [&](double amount) {
                        axes[p].K[k] = axes_[p].K[k] + amount;
                        return weigh(motions_, axes);
                    },
                    step / length);
                axes[p] = axes_[p];
            }
        }
        for (int i = 0; i < Nodes; ++i) {
            MotionGradient::OfNode here, before;
            transpose_turn(motions_[i]->theta, differentiate_by_turn(i, weigh), here, before);
            spins_before[i] += before.phi;
        }
    }

    static constexpr double step = 1e-3;  // in rad

    const Element& element_;
    const Rod& rod_;
    Motions<Nodes> motions_;
    Histories histories_;
    Map map_;
    std::array<ShapeAtPoint<Nodes>, points> shapes_;
    Axes axes_;
    std::array<SectionFields, points> fields_;
    std::array<Vec6, points> strains_;
    std::array<StrainGradient, points> gradients_;
};

template <int Nodes, class Map>
RememberingElement<Nodes, Map> remember(const RodElement<Nodes, Map>& element,
                                        const std::type_identity_t<Motions<Nodes>>& motions,
                                        const Histories& histories) {
    return {element, motions, histories};
}

}  // namespace

double dot(const MemoryGradient& by, const State& to, const State& from) {
    double sum = 0.0;
    for (std::size_t i = 0; i < by.numbers.size(); ++i)
        sum += by.numbers[i] * (to.memory[i] - from.memory[i]);
    for (std::size_t i = 0; i < by.sections.size(); ++i) {
        const SectionHistory &here = to.sections[i], &there = from.sections[i];
        sum += by.sections[i].phi.dot(log(here.Lambda * there.Lambda.conjugate())) +
               by.sections[i].K.dot(here.K - there.K);
    }
    return sum;
}

double dot(const MemoryGradient& by, const StateDirection& along) {
    double sum = 0.0;
    for (std::size_t i = 0; i < by.numbers.size(); ++i) sum += by.numbers[i] * along.memory[i];
    for (std::size_t i = 0; i < by.sections.size(); ++i)
        sum += by.sections[i].phi.dot(along.sections[i].phi) + by.sections[i].K.dot(along.sections[i].K);
    return sum;
}

// Calls visit(element with its motions, its nodes, its part of a vector of numbers, its part of one of
// sections) for each element that remembers; the parts are functions of a MemoryGradient.
template <class Visit>
void RodMemory::visit(const State& state, double time, const Visit& visit) const {
    SystemValues(*system_).visit_elements(state, time, [&](const auto& block, const Instant& now) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::has_section) {
            for (std::size_t e = 0; e < block.elements.size(); ++e) {
                if (Block::history_count == 0 && block.memory_count(e) == 0) continue;
                const MemorySlice numbers{block.memory_start(e), block.memory_count(e)};
                const MemorySlice sections{block.first_history + e * Block::history_count,
                                           Block::history_count};
                visit(remember(
                          block.elements[e], block.motions(state.trial, e), block.histories(state, e, now)),
                      block.elements[e].nodes,
                      numbers,
                      sections);
            }
        }
    });
}

namespace {

template <class T>
std::span<T> part_of(std::vector<T>& all, const MemorySlice& slice) {
    return std::span(all).subspan(slice.first, slice.count);
}
template <class T>
std::span<const T> part_of(const std::vector<T>& all, const MemorySlice& slice) {
    if (all.empty()) return {};
    return std::span(all).subspan(slice.first, slice.count);
}

template <std::size_t Nodes>
void add_spins(const std::array<Vec3, Nodes>& spins,
               const std::array<int, Nodes>& nodes,
               MotionGradient& gradient) {
    for (std::size_t i = 0; i < Nodes; ++i)
        gradient.nodes[static_cast<std::size_t>(nodes[i])].phi += spins[i];
}

template <std::size_t Nodes>
std::array<Vec3, Nodes> no_spins(const std::array<int, Nodes>&) {
    std::array<Vec3, Nodes> spins;
    spins.fill(Vec3::Zero());
    return spins;
}

}  // namespace

void RodMemory::add_by_placements(const State& state,
                                  double time,
                                  const MemoryGradient& after,
                                  MotionGradient& by_end) const {
    visit(
        state, time, [&](const auto& element, const auto& nodes, const auto& numbers, const auto& sections) {
            const auto nodal = element.compute_by_placements(part_of(after.numbers, numbers),
                                                             part_of(after.sections, sections));
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                MotionGradient::OfNode& node = by_end.nodes[static_cast<std::size_t>(nodes[i])];
                const auto first = static_cast<Eigen::Index>(6 * i);
                node.r += nodal.template segment<3>(first);
                node.phi += nodal.template segment<3>(first + 3);
            }
        });
}

void RodMemory::add_by_memory(const State& state,
                              double time,
                              const std::vector<Vec6>& xi,
                              const MemoryGradient& after,
                              MemoryGradient& before,
                              MotionGradient& motions_before) const {
    visit(
        state, time, [&](const auto& element, const auto& nodes, const auto& numbers, const auto& sections) {
            constexpr int count = std::tuple_size_v<std::remove_cvref_t<decltype(nodes)>>;
            NodalVector<count> own;
            for (int i = 0; i < count; ++i)
                own.template segment<6>(6 * i) =
                    xi[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)])];
            auto spins = no_spins(nodes);
            element.add_by_memory(own,
                                  part_of(after.numbers, numbers),
                                  part_of(after.sections, sections),
                                  part_of(before.numbers, numbers),
                                  part_of(before.sections, sections),
                                  spins);
            add_spins(spins, nodes, motions_before);
        });
}

RodMemory::Places RodMemory::list_places(const State& state, const std::vector<int>& nodes) const {
    Places places;
    const auto add = [](const MemorySlice& slice, std::vector<std::size_t>& list) {
        for (std::size_t i = slice.first; i < slice.end(); ++i) list.push_back(i);
    };
    visit(state, state.time, [&](const auto&, const auto& own, const auto& numbers, const auto& sections) {
        const auto is_asked = [&](int node) { return std::ranges::find(nodes, node) != nodes.end(); };
        if (std::ranges::none_of(own, is_asked)) return;
        add(numbers, places.numbers);
        add(sections, places.sections);
    });
    return places;
}

std::vector<double> RodMemory::list_steps(const State& state, double time) const {
    std::vector<double> steps(state.memory.size(), 0.0);
    visit(state, time, [&](const auto& element, const auto&, const auto& numbers, const auto&) {
        element.list_steps(part_of(steps, numbers));
    });
    return steps;
}

}  // namespace gxrod
