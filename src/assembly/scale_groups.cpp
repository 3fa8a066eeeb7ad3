#include "assembly/scale_groups.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "model/parts.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

// How much less a group's own forces may be than those of its part before its residual is compared with them.
constexpr double weak = 1e3;
// By what a residual is small, as a rule (NewtonSettings::tolerance): round-off over it is a scale.
constexpr double usual_tolerance = 1e-8;

// `ties`: the springs and bushings of the part.
double measure_length(const Model& model, const ModelPart& part, std::span<const Tie> ties) {
    Eigen::AlignedBox3d box;
    for (const int node : part.nodes) box.extend(model.nodes[node].position);
    for (const Tie& tie : ties) {
        for (const Anchor& end : tie.ends) box.extend(find_place(model, end));
    }
    double length = box.isEmpty() ? 0.0 : box.diagonal().norm();
    for (const int index : part.bodies) {
        const Body& body = model.bodies[index];
        length = std::max(length, body.centre_of_mass.norm());
        if (body.mass > 0.0) length = std::max(length, std::sqrt(body.inertia.trace() / body.mass));
    }
    return length > 0.0 ? length : 1.0;
}

double bound(double scale, double own, double round_off) {
    return std::min(scale, std::max(own, round_off / usual_tolerance));
}

ResidualScales larger(const ResidualScales& a, const ResidualScales& b) {
    return {std::max(a.force, b.force), std::max(a.moment, b.moment)};
}

}  // namespace

ResidualScales relate_scales(const ForceScales& scales, double length) {
    constexpr double least = 1e-6;
    return {std::max(scales.force_scale, least * scales.moment_scale / length),
            std::max(scales.moment_scale, least * scales.force_scale * length)};
}

ScaleGroups::ScaleGroups(const Model& model)
    : rod_count_(static_cast<int>(model.rods.size())),
      first_tie_(rod_count_ + static_cast<int>(model.bodies.size())) {
    find_nodes(model);
    find_parts_of_groups(model);
    find_round_off(model);
}

void ScaleGroups::find_nodes(const Model& model) {
    constexpr int none = -1;
    group_of_node_.assign(model.nodes.size(), none);
    const std::vector<Tie> ties = list_element_ties(model);
    neighbours_.resize(model.rods.size() + model.bodies.size() + ties.size());
    const auto add = [&](int node, int group) {
        int& of_node = group_of_node_[node];
        if (of_node == none || of_node == group) {
            of_node = group;
            return;
        }
        if (neighbours_[of_node].empty()) {
            neighbours_.push_back({of_node});
            of_node = static_cast<int>(neighbours_.size()) - 1;
        }
        if (neighbours_[of_node].back() != group) neighbours_[of_node].push_back(group);
    };
    for (int rod = 0; rod < rod_count_; ++rod) {
        for (const int node : model.rods[rod].nodes) add(node, of_rod(rod));
    }
    for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body)
        add(model.bodies[body].node, of_body(body));
    for (std::size_t tie = 0; tie < ties.size(); ++tie) {
        for (const Anchor& end : ties[tie].ends) {
            if (!end.is_ground()) add(end.node, of_tie(tie));
        }
    }
    for (int& group : group_of_node_) {
        if (group != none) continue;
        group = static_cast<int>(neighbours_.size());  // a node of nothing
        neighbours_.emplace_back();
    }
}

void ScaleGroups::find_parts_of_groups(const Model& model) {
    const std::vector<ModelPart> parts = find_parts(model);
    part_of_group_.assign(neighbours_.size(), 0);
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const int index = static_cast<int>(part);
        for (const int node : parts[part].nodes) part_of_group_[group_of_node_[node]] = index;
        for (const int rod : parts[part].rods) part_of_group_[of_rod(rod)] = index;
        for (const int body : parts[part].bodies) part_of_group_[of_body(body)] = index;
    }
    const std::vector<Tie> ties = list_element_ties(model);
    std::vector<std::vector<Tie>> ties_of_parts(parts.size());
    for (std::size_t tie = 0; tie < ties.size(); ++tie) {
        const Anchor& held = ties[tie].ends[ties[tie].ends[0].is_ground() ? 1 : 0];
        const int part = part_of_node(held.node);
        part_of_group_[of_tie(tie)] = part;
        ties_of_parts[part].push_back(ties[tie]);
    }
    for (std::size_t part = 0; part < parts.size(); ++part)
        lengths_.push_back(measure_length(model, parts[part], ties_of_parts[part]));
}

// Positions are good to a few units of the last place, and so are strains times the length of an element.
void ScaleGroups::find_round_off(const Model& model) {
    constexpr double units = 16.0 * std::numeric_limits<double>::epsilon();
    round_off_.assign(count(), {0.0, 0.0});
    for (int index = 0; index < rod_count_; ++index) {
        const Rod& rod = model.rods[index];
        const Mat6& stiffness = model.sections[rod.section].stiffness;
        const double stretching = stiffness.diagonal().head<3>().maxCoeff();
        const double bending = stiffness.diagonal().tail<3>().maxCoeff();
        double size = 0.0;
        for (const int node : rod.nodes)
            size = std::max(size, model.nodes[node].position.lpNorm<Eigen::Infinity>());
        size = std::max(size, rod.length);
        const double element = rod.length / std::max(rod.element_count(), 1);
        round_off_[of_rod(index)] = {units * stretching * size / element,
                                     units * (stretching * size + bending / element)};
    }
    std::size_t number = 0;
    for_each_element_tie(model, [&](TieKind, const auto& tie) {
        double size = 0.0;
        double arm = 0.0;
        for (const Anchor& end : tie.ends) {
            size = std::max(size, find_place(model, end).lpNorm<Eigen::Infinity>());
            if (!end.is_ground()) arm = std::max(arm, end.arm.norm());
        }
        const TieStiffness stiffness = stiffness_of(tie);
        const double force = units * stiffness.displacement * size;
        round_off_[of_tie(number++)] = {force, std::max(force * arm, units * stiffness.turn)};
    });
    for (std::size_t group = 0; group < count(); ++group) {
        for (const int other : neighbours_[group])
            round_off_[group] = larger(round_off_[group], round_off_[other]);
    }
}

ForceScales ScaleGroups::acting_in(int group, const Residual& residual) const {
    ForceScales acting = residual.groups[group];
    for (const int other : neighbours_[group]) acting.raise(residual.groups[other]);
    return acting;
}

NodeScales ScaleGroups::compute_scales(const Residual& residual) const {
    if (count() == 1) return NodeScales(relate_scales(residual.groups.front(), lengths_.front()));
    std::vector<ForceScales> of_parts(part_count());
    std::vector<ResidualScales> off_parts(part_count(), {0.0, 0.0});
    ForceScales whole;
    double length = 0.0;
    for (std::size_t group = 0; group < count(); ++group) {
        of_parts[part_of_group_[group]].raise(residual.groups[group]);
        whole.raise(residual.groups[group]);
        off_parts[part_of_group_[group]] = larger(off_parts[part_of_group_[group]], round_off_[group]);
    }
    for (const double part : lengths_) length = std::max(length, part);
    const ResidualScales all = relate_scales(whole, length);
    std::vector<ResidualScales> scales(count());
    for (std::size_t group = 0; group < count(); ++group) {
        const int part = part_of_group_[group];
        const ResidualScales in_part = relate_scales(of_parts[part], lengths_[part]);
        const ResidualScales own =
            relate_scales(acting_in(static_cast<int>(group), residual), lengths_[part]);
        const ResidualScales outer{bound(all.force, in_part.force, off_parts[part].force),
                                   bound(all.moment, in_part.moment, off_parts[part].moment)};
        scales[group] = {bound(outer.force, weak * own.force, round_off_[group].force),
                         bound(outer.moment, weak * own.moment, round_off_[group].moment)};
    }
    return {std::move(scales), group_of_node_};
}

}  // namespace gxrod
