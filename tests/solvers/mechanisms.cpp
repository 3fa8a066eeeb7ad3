#include "solvers/mechanisms.hpp"

#include <algorithm>

#include "integrators/load_stepping.hpp"
#include "tools/dense_algebra.hpp"

namespace gxrod::tools {

Rod& add_rod(Model& model, const RodSpec& spec) {
    Section section;
    section.stiffness.diagonal() << 1e6, 1e6, 1e6, 100.0, 100.0, 100.0;
    section.mass.setIdentity();
    model.sections.push_back(section);
    Rod rod;
    rod.name = spec.name;
    rod.section = static_cast<int>(model.sections.size()) - 1;
    rod.order = spec.order;
    rod.length = (spec.end - spec.start).norm();
    const Quat axes = turn_x_to(spec.end - spec.start);
    const int last = spec.elements * spec.order;
    std::vector<double> arc_length;
    for (int i = 0; i <= last; ++i) {
        const double fraction = static_cast<double>(i) / last;
        const std::string place = i == 0 ? ".start" : i == last ? ".end" : " node " + std::to_string(i);
        rod.nodes.push_back(static_cast<int>(model.nodes.size()));
        model.nodes.push_back({spec.name + place, spec.start + fraction * (spec.end - spec.start)});
        arc_length.push_back(fraction * rod.length);
    }
    set_line_elements(rod, arc_length, std::vector<Quat>(arc_length.size(), axes));
    model.rods.push_back(rod);
    return model.rods.back();
}

void connect_start(Model& model, int node) {
    Rod& rod = model.rods.back();
    const int old = rod.nodes.front();
    const auto rename = [&](int& entry) { entry = entry == old ? node : entry > old ? entry - 1 : entry; };
    std::for_each(rod.nodes.begin(), rod.nodes.end(), rename);
    std::for_each(rod.element_nodes.begin(), rod.element_nodes.end(), rename);
    model.nodes.erase(model.nodes.begin() + old);
}

void add_support(Model& model, int node, const std::vector<int>& components) {
    Support support;
    support.node = node;
    for (const int component : components) support.fixed[component] = true;
    model.supports.push_back(support);
}

std::vector<double> compute_static_tangent(const System& system, const State& state) {
    std::vector<NodeLinearization> linearizations(state.trial.size());
    LoadStepping().linearize(state, {0, 0.0, 1.0, 1.0}, linearizations);
    std::vector<double> values;
    system.compute_tangent(state, 1.0, linearizations, values);
    return values;
}

}  // namespace gxrod::tools
