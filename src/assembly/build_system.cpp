#include <algorithm>
#include <utility>

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/element_geometry.hpp"
#include "assembly/loads/load_assembly.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/surroundings_assembly.hpp"
#include "assembly/system.hpp"
#include "machine/reserve_more.hpp"
#include "model/ties/ties.hpp"

// How a system is made of its model, once.
namespace gxrod {

namespace {

// Of an element of a rod whose sections vary along it.
template <int Nodes>
ElementSections<Nodes> make_sections(const Model& model, const Rod& rod, int element) {
    const auto fill = [&](const std::vector<Section>& all, auto& sections) {
        const Section* next = &all[static_cast<std::size_t>(element) * sections.size()];
        for (SharedRodSection& section : sections)
            section = std::make_shared<const RodSection>(*next++, model.has_inertia);
    };
    ElementSections<Nodes> sections;
    fill(rod.varying.at_forces, sections.at_forces);
    fill(rod.varying.at_masses, sections.at_masses);
    fill(rod.varying.at_nodes, sections.at_nodes);
    return sections;
}

template <class E>
void add_rod(const Model& model, int index, int group, int first_element, ElementBlock<E>& block) {
    constexpr int nodes = E::node_count;
    const Rod& rod = model.rods[index];
    const ElementSections<nodes> constant(
        std::make_shared<const RodSection>(model.sections[rod.section], model.has_inertia));
    const auto count = static_cast<std::size_t>(rod.element_count());
    reserve_more(count, block.elements);
    reserve_more(count, block.section_index);
    reserve_more(count, block.groups);
    reserve_more(count, block.rods);
    for (int e = 0; e < rod.element_count(); ++e) {
        block.elements.emplace_back(
            find_geometry<nodes>(model, rod, e),
            rod.has_varying_sections() ? make_sections<nodes>(model, rod, e) : constant);
        block.section_index.push_back(first_element + e);
        block.rods.push_back({index, e});
        block.groups.push_back(group);
    }
}

}  // namespace

System::System(const Model& model, const ThreadTeam& team)
    : System(model, find_kernels(find_instruction_set()), team) {}

System::System(const Model& model, const Kernels& kernels, const ThreadTeam& team)
    : System(model, kernels, team, std::nullopt) {}

System::System(const Model& model, const ThreadTeam& team, std::optional<std::vector<NodeGroup>> touching)
    : System(model, find_kernels(find_instruction_set()), team, std::move(touching)) {}

System::System(const Model& model,
               const Kernels& kernels,
               const ThreadTeam& team,
               std::optional<std::vector<NodeGroup>> touching)
    : model_(&model),
      team_(&team),
      touching_(std::move(touching)),
      supports_(model),
      joints_(model),
      equations_(supports_, joints_.attached()),
      scale_groups_(model),
      rod_batches_(kernels, kernels, kernels, kernels),
      rotary_batches_(kernels.rotary, kernels.width, equations_),
      rotary_damping_batches_(kernels.rotary_damping, kernels.width, equations_),
      drive_values_(model),
      tendon_lines_(model) {
    memory_count_ = tendon_lines_.capstans().memory_count();
    build_blocks();
    memory_within_rods_ = {0, memory_count_};
    traits_.uses_step_rotations = history_count_ > 0;
    traits_.is_damped = is_damped_ || joints_.is_damped();
    traits_.is_driven = !drive_values_.empty();
    build_pattern();
    build_batches();
    measure();
    build_contributions();
}

// In the order in which they add.
void System::build_contributions() {
    loads_.push_back(std::make_unique<LoadAssembly>(*model_));
    auto surroundings = std::make_unique<SurroundingsAssembly>(*model_, *team_);
    if (!surroundings->empty()) {
        surroundings_ = surroundings.get();
        loads_.push_back(std::move(surroundings));
    }
    std::vector<Contribution*> all;
    for (const auto& load : loads_) all.push_back(load.get());
    auto contact = std::make_unique<ContactAssembly>(*model_, *team_, scale_groups_, touching_.has_value());
    if (!contact->empty()) {
        all.push_back(contact.get());
        contact_ = std::move(contact);
    }
    all.push_back(&joints_);  // last: their equations are scaled by all else
    for (Contribution* one : all) {
        one->lay_out({equations_, pattern_, scale_groups_, length_scale_, memory_count_});
        memory_count_ += one->memory_count();
    }
    contributions_.assign(all.begin(), all.end());
    traits_.has_surroundings = surroundings_ != nullptr;
}

void System::build_blocks() {
    auto& bodies = std::get<ElementBlock<RigidBody>>(blocks_);
    for (int body = 0; body < static_cast<int>(model_->bodies.size()); ++body) {
        bodies.elements.emplace_back(model_->bodies[body], model_->has_inertia);
        bodies.groups.push_back(scale_groups_.of_body(body));
    }
    std::size_t tie_number = 0;
    for_each_element_tie(*model_, [&](TieKind, const auto& tie) {
        visit_element(tie, [&]<class E>(const E& element) {
            auto& block = std::get<ElementBlock<E>>(blocks_);
            block.elements.push_back(element);
            block.groups.push_back(scale_groups_.of_tie(tie_number));
        });
        ++tie_number;
    });
    for (int index = 0; index < static_cast<int>(model_->rods.size()); ++index) {
        const Rod& rod = model_->rods[index];
        const int group = scale_groups_.of_rod(index);
        visit_node_count(rod.order, [&](auto node_count) {
            if (rod.kind == ElementKind::simo) {
                add_rod(*model_,
                        index,
                        group,
                        rod_element_count_,
                        std::get<ElementBlock<SimoElement<node_count>>>(blocks_));
            } else {
                add_rod(*model_,
                        index,
                        group,
                        rod_element_count_,
                        std::get<ElementBlock<ObjectiveElement<node_count>>>(blocks_));
            }
        });
        rod_element_count_ += rod.element_count();
    }
    for_each_block(blocks_, [this](auto& block) {
        block.first_history = history_count_;
        history_count_ += block.elements.size() * block.history_count;
        block.first_point = point_count_;
        point_count_ += block.elements.size() * block.point_count;
        lay_out_memory(block);
        block.has_laws = std::any_of(
            block.elements.begin(), block.elements.end(), [](const auto& e) { return e.has_law(); });
        traits_.has_laws = traits_.has_laws || block.has_laws;
        block.is_damped = std::any_of(
            block.elements.begin(), block.elements.end(), [](const auto& e) { return e.is_damped(); });
        is_damped_ = is_damped_ || block.is_damped;
        block.phases = WorkPhases(
            block.elements.size(), model_->nodes.size(), [&](std::size_t element, const auto& mark) {
                for (const int node : block.elements[element].nodes) mark(node);
            });
    });
}

template <class E>
void System::lay_out_memory(ElementBlock<E>& block) {
    const std::size_t before = memory_count_;
    std::vector<std::size_t> first{before};
    for (const E& element : block.elements) {
        memory_count_ += static_cast<std::size_t>(element.memory_count());
        first.push_back(memory_count_);
    }
    if (memory_count_ > before) block.first_memory = std::move(first);
}

std::vector<NodeGroup> System::list_node_groups() const {
    std::vector<NodeGroup> groups;
    for_each_block(blocks_, [&](const auto& block) {
        for (const auto& element : block.elements)
            groups.emplace_back(element.nodes.begin(), element.nodes.end());
    });
    std::vector<NodeGroup> of_joints = joints_.node_groups();
    std::move(of_joints.begin(), of_joints.end(), std::back_inserter(groups));
    if (touching_) groups.insert(groups.end(), touching_->begin(), touching_->end());
    return groups;
}

void System::build_pattern() {
    pattern_ = compute_pattern(equations_, list_node_groups());
    for_each_block(blocks_, [this](auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        block.places.reserve(block.elements.size());
        for (const auto& element : block.elements) {
            block.places.push_back(find_places<node_count>(element.nodes, equations_, pattern_));
        }
    });
    find_cleared();
}

// Zeros are written just before others are added to them, while they are in the cache.
void System::find_cleared() {
    const auto start_of = [&](std::int64_t column) {
        if (column == pattern_.size()) return pattern_.nonzeros();
        const SparsePattern::Block block = pattern_.block_of(column);
        return block.first_entry + (column - block.first_column) * block.stride;
    };
    std::vector<char> is_cleared(model_->nodes.size(), 0);
    const auto clear = [&](int node, std::vector<EntryRange>& ranges) {
        if (std::exchange(is_cleared[node], 1) != 0) return;
        const EntryRange own{start_of(equations_.first_of(node)), start_of(equations_.end_of(node))};
        if (!ranges.empty() && ranges.back().last == own.first)
            ranges.back().last = own.last;
        else if (own.last > own.first)
            ranges.push_back(own);
    };
    for_each_block(blocks_, [&](auto& block) {
        block.cleared.resize(block.phases.part_count());
        block.phases.run(ThreadTeam::alone(), [&](std::size_t part) {
            std::vector<int> nodes;
            for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e)
                nodes.insert(nodes.end(), block.elements[e].nodes.begin(), block.elements[e].nodes.end());
            std::sort(nodes.begin(), nodes.end());
            for (const int node : nodes) clear(node, block.cleared[part]);
        });
    });
    for (int node = 0; node < static_cast<int>(is_cleared.size()); ++node) clear(node, cleared_alone_);
}

void System::build_batches() {
    for_each_block(blocks_, [this]<class E>(const ElementBlock<E>& block) {
        if constexpr (is_batched<E>) {
            std::get<RodBatches<E::node_count>>(rod_batches_).build(block, equations_, drive_values_);
            for (const E& element : block.elements) {
                const double damping = element.inertia().section(0).mass_proportional;
                for (int i = 0; i < E::node_count; ++i) {
                    const int node = element.nodes[i];
                    const int group = scale_groups_.of_node(node);
                    const Mat3 inertia = element.inertia().compute_rotary_inertia(i);
                    if (model_->has_inertia) rotary_batches_.add(node, group, inertia);
                    if (damping > 0.0) rotary_damping_batches_.add(node, group, damping * inertia);
                }
            }
        }
    });
    rotary_batches_.lay_out(pattern_);
    rotary_damping_batches_.lay_out(pattern_);
}

void System::measure() {
    Eigen::AlignedBox3d box;
    for (const Node& node : model_->nodes) box.extend(node.position);
    for_each_element_tie(*model_, [&](TieKind, const auto& tie) {
        for (const Anchor& end : tie.ends) box.extend(find_place(*model_, end));
    });
    double length = box.isEmpty() ? 0.0 : box.diagonal().norm();
    for (const Body& body : model_->bodies) {
        length = std::max(length, body.centre_of_mass.norm());
        if (body.mass > 0.0) length = std::max(length, std::sqrt(body.inertia.trace() / body.mass));
    }
    if (length > 0.0) length_scale_ = length;
}

}  // namespace gxrod
