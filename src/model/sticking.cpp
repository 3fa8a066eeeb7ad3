#include "model/sticking.hpp"

#include <algorithm>

#include "model/contact_friction.hpp"
#include "model/kinked_law.hpp"

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

// Calls visit(name, widen) for each friction; widen(factor).
template <class Visit>
void visit_frictions(Model& model, const Visit& visit) {
    for (Joint& joint : model.joints) {
        if (!joint.turn.friction.acts() && !joint.slide.friction.acts()) continue;
        visit("joint " + joint.name, [&](double factor) {
            widen(joint.turn, factor);
            widen(joint.slide, factor);
        });
    }
    for (Sleeve& sleeve : model.sleeves) {
        if (sleeve.slide.friction.acts())
            visit("joint " + sleeve.name, [&](double factor) { widen(sleeve.slide, factor); });
    }
    for (Tendon& tendon : model.tendons) {
        if (!tendon.friction) continue;
        visit("tendon " + tendon.name, [&](double factor) { tendon.friction->coefficient *= factor; });
    }
    std::optional<Seabed>& seabed = model.surroundings.seabed;
    if (seabed && seabed->has_friction()) visit("the seabed", [&](double factor) { widen(*seabed, factor); });
    if (rubs(model.contact)) visit("contact", [&](double factor) { widen(model.contact, factor); });
}

double factor_of(AtLimit then) { return then == AtLimit::sticks ? 1.0 + little : 1.0 - little; }

}  // namespace

std::vector<std::string> list_frictions(const Model& model) {
    std::vector<std::string> names;
    Model copy = model;
    visit_frictions(copy, [&](const std::string& name, const auto&) { names.push_back(name); });
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
