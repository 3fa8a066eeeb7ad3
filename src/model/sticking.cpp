#include "model/sticking.hpp"

#include <algorithm>
#include <string>

#include "model/contact.hpp"
#include "model/sections/kinked_law.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

constexpr double little = 100.0 * at_its_limit;

void widen(JointCoordinate& one, double factor) { one.friction.stick *= factor; }

void widen(Contact& contact, double factor) {
    contact.friction *= factor;
    for (Obstacle& obstacle : contact.obstacles) obstacle.friction *= factor;
    for (ContactException& one : contact.exceptions) {
        if (one.friction) *one.friction *= factor;
    }
}

void widen(Seabed& seabed, double factor) {
    seabed.axial_friction *= factor;
    seabed.lateral_friction *= factor;
}

// Calls visit(name, widen) for each friction; widen(factor), of a model that is not const.
template <class AnyModel, class Visit>
void visit_frictions(AnyModel& model, const Visit& visit) {
    for_each_coordinates(model, [&](std::size_t, const std::string& name, auto& turn, auto& slide) {
        if (!turn.friction.acts() && !slide.friction.acts()) return;
        visit("joint " + name, [&](auto factor) {
            widen(turn, factor);
            widen(slide, factor);
        });
    });
    for (auto& tendon : model.tendons) {
        if (!tendon.friction) continue;
        visit("tendon " + tendon.name, [&](auto factor) { tendon.friction->coefficient *= factor; });
    }
    auto& seabed = model.surroundings.seabed;
    if (seabed && seabed->has_friction()) visit("the seabed", [&](auto factor) { widen(*seabed, factor); });
    if (rubs(model.contact)) visit("contact", [&](auto factor) { widen(model.contact, factor); });
}

double factor_of(AtLimit then) { return then == AtLimit::sticks ? 1.0 + little : 1.0 - 2.0 * little; }

}  // namespace

std::vector<std::string> list_frictions(const Model& model) {
    std::vector<std::string> names;
    visit_frictions(model, [&](const std::string& name, const auto&) { names.push_back(name); });
    return names;
}

Model set_at_limit(Model model, AtLimit then) {
    visit_frictions(model, [&](const std::string&, const auto& widen_it) { widen_it(factor_of(then)); });
    return model;
}

Model set_at_limit(Model model, AtLimit then, const std::string& listed) {
    visit_frictions(model, [&](const std::string& name, const auto& widen_it) {
        if (name == listed) widen_it(factor_of(then));
    });
    return model;
}

}  // namespace gxrod
