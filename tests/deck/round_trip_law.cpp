#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "laws/fibre_law.hpp"
#include "laws/layered_law.hpp"
#include "laws/moment_curvature_law.hpp"
#include "laws/plastic_law.hpp"
#include "laws/stretch_law.hpp"
#include "laws/syrope_law.hpp"
#include "laws/trapeze_law.hpp"
#include "laws/viscoelastic_law.hpp"

namespace gxrod::test {
namespace {

// The deck's stiffness is EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700.
std::string with_law(const std::string& law) {
    return replaced(rod_deck, "inertia = { rhoA", "law = { " + law + " }\ninertia = { rhoA");
}

template <class Law>
std::function<bool(const Problem&)> sees(const std::function<bool(const Law&)>& is_seen) {
    return [is_seen](const Problem& problem) {
        const auto* law = dynamic_cast<const Law*>(problem.model.sections[0].law.get());
        return law != nullptr && is_seen(*law);
    };
}

RoundTrip layer_trip() {
    return {"section.NAME.law.layers",
            with_law("layers = [{ on = \"shear z\", stiffness = 7, limit = 3, limit_per_tension = 0.5 }]"),
            sees<LayeredLaw>([](const LayeredLaw& law) {
                const Layer& layer = law.layers()[0];
                return law.layers().size() == 1 && law.stiffness()(3, 3) == 500.0 &&
                       layer.on == StrainPart::shear_z && layer.stiffness == 7.0 && layer.limit == 3.0 &&
                       layer.limit_per_tension == 0.5;
            })};
}

std::vector<RoundTrip> curve_trips() {
    const std::string key = "section.NAME.law.moment_curvature.";
    const std::string rows = " = [[0, 0], [0.1, 50], [1, 60]]";
    const auto curve = [&](const std::string& name) {
        return with_law("moment_curvature = { " + name + rows + " }");
    };
    const auto is_on = [](StrainPart on) {
        return sees<MomentCurvatureLaw>([on](const MomentCurvatureLaw& law) {
            return law.curves().size() == 1 && law.curves()[0].on == on &&
                   law.curves()[0].curve.at(1.0).value == 60.0;
        });
    };
    return {{key + "table", curve("table"), is_on(StrainPart::bending)},
            {key + "y", curve("y"), is_on(StrainPart::bending_y)},
            {key + "z", curve("z"), is_on(StrainPart::bending_z)},
            {key + "hysteresis",
             with_law("moment_curvature = { hysteresis = \"kinematic\", table" + rows + " }"),
             sees<LayeredLaw>([](const LayeredLaw& law) {
                 return law.layers().size() == 1 &&
                        std::abs(law.layers()[0].limit - 0.1 * (500.0 - 10.0 / 0.9)) < 1e-9;
             })}};
}

RoundTrip plastic_trip() {
    return {"section.NAME.law.plastic",
            with_law("plastic = { yield = { N = 1, Vy = 2, Vz = 3, T = 4, My = 5, Mz = 6 }, interaction = "
                     "\"none\", isotropic = [[0, 1], [2, 1.5]], kinematic = 0.25 }"),
            sees<PlasticLaw>([](const PlasticLaw& law) {
                const YieldLimits& yield = law.yield();
                std::vector<std::pair<int, double>> limits;
                for (int entry = 0; entry < 6; ++entry) limits.emplace_back(entry, entry + 1.0);
                return yield.limits == limits && yield.interaction == YieldInteraction::none &&
                       yield.isotropic->at(2.0).value == 1.5 && yield.kinematic == 0.25;
            })};
}

std::vector<RoundTrip> fibre_rope_trips() {
    const std::string key = "section.NAME.law.syrope.";
    const std::string deck = with_law(
        "syrope = { original = [[0, 0], [0.1, 60], [0.2, 80]], working_curve = \"quadratic\", k1 = 0.25, "
        "k2 = 0.5, dynamic_stiffness = 2000, per_tension = 3, damping = 700, largest_tension = 70 }");
    const auto trip = [&](const std::string& name, const std::function<bool(const SyropeRope&)>& is_seen) {
        return RoundTrip{key + name, deck, sees<SyropeLaw>([is_seen](const SyropeLaw& law) {
                             return is_seen(law.rope());
                         })};
    };
    return {
        trip("original", [](const SyropeRope& rope) { return rope.original.at(0.2).value == 80.0; }),
        trip("working_curve", [](const SyropeRope& rope) { return rope.shape == WorkingShape::quadratic; }),
        trip("k1", [](const SyropeRope& rope) { return rope.k1 == 0.25; }),
        trip("k2", [](const SyropeRope& rope) { return rope.k2 == 0.5; }),
        trip("dynamic_stiffness", [](const SyropeRope& rope) { return rope.stiffness == 2000.0; }),
        trip("per_tension", [](const SyropeRope& rope) { return rope.per_tension == 3.0; }),
        trip("damping", [](const SyropeRope& rope) { return rope.damping == 700.0; }),
        trip("largest_tension",
             [](const SyropeRope& rope) { return std::abs(rope.largest - 0.15) < 1e-15; })};
}

}  // namespace

std::vector<RoundTrip> law_trips() {
    std::vector<RoundTrip> trips = curve_trips();
    for (RoundTrip& trip : fibre_rope_trips()) trips.push_back(std::move(trip));
    trips.push_back(layer_trip());
    trips.push_back(plastic_trip());
    const std::string rows = "tension_strain = { table = [[-0.1, -50], [0, 0], [0.1, 60], [0.2, 80]]";
    trips.push_back({"section.NAME.law.tension_strain.table",
                     with_law(rows + " }"),
                     sees<StretchLaw>([](const StretchLaw& law) {
                         return law.curve().pulled.at(0.2).value == 80.0 &&
                                law.curve().pushed.at(0.1).value == 50.0 && !law.curve().unloading;
                     })});
    trips.push_back(
        {"section.NAME.law.tension_strain.unloading_stiffness",
         with_law(rows + ", unloading_stiffness = 700 }"),
         sees<StretchLaw>([](const StretchLaw& law) { return *law.curve().unloading == 700.0; })});
    const std::string key = "section.NAME.law.viscoelastic.";
    trips.push_back({key + "prony",
                     with_law("viscoelastic = { prony = [[0.5, 0.2], [\"3/10\", 2]] }"),
                     sees<ViscoelasticLaw>([](const ViscoelasticLaw& law) {
                         const auto& b = law.branches();
                         return b.size() == 2 && b[0].time == 0.2 && b[1].ratio == 0.3 &&
                                law.relaxing()(0, 0) == 1e4;
                     })});
    trips.push_back({key + "on",
                     with_law("viscoelastic = { prony = [[1, 1]], on = [\"bending\", \"tension\"] }"),
                     sees<ViscoelasticLaw>([](const ViscoelasticLaw& law) {
                         return law.relaxing().diagonal() == Vec6(1e4, 0.0, 0.0, 0.0, 600.0, 700.0);
                     })});
    trips.push_back({"section.NAME.trapeze",
                     replaced(rod_deck, "inertia = { rhoA", "trapeze = true\ninertia = { rhoA"),
                     sees<TrapezeLaw>([](const TrapezeLaw& law) { return law.coefficient() == 1300.0; })});
    trips.push_back(
        {"section.NAME.material.yield_stress",
         replaced(replaced(rod_deck,
                           "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
                           "shape = { circle = { radius = 1 } }"),
                  "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }",
                  "material = { E = 1, G = 1, shear_factor = 1, density = 1, yield_stress = 0.01 }"),
         sees<LayeredLaw>([](const LayeredLaw& law) {
             return law.layers().size() == 117 && law.layers()[0].limit == 0.01 * M_PI;
         })});
    trips.push_back(
        {"section.NAME.material.interaction",
         replaced(trips.back().deck, "yield_stress = 0.01", "yield_stress = 0.01, interaction = true"),
         sees<FibreLaw>([](const FibreLaw& law) { return law.fibre_count() == 576; })});
    trips.push_back({"section.NAME.material.elastic",
                     replaced(trips.back().deck, "interaction = true", "elastic = true"),
                     [](const Problem& p) {
                         return p.model.sections[0].law == nullptr &&
                                p.model.sections[0].stiffness(0, 0) < 100;
                     }});
    return trips;
}

}  // namespace gxrod::test
