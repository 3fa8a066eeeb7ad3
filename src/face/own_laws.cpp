#include "face/own_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck/schema/suggestion.hpp"
#include "deck/text/fault.hpp"
#include "model/sections/section_at.hpp"
#include "model/settings/scheme_card.hpp"
#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

[[noreturn]] void refuse(const Problem& problem, const std::string& key, const std::string& message) {
    throw DeckError({{problem.record.name, 0, 0, key, message}});
}

template <class Part>
Part& find(std::vector<Part>& parts,
           const std::string& kind,
           const std::string& name,
           const Problem& problem) {
    const auto found = std::ranges::find(parts, name, &Part::name);
    if (found != parts.end()) return *found;
    std::vector<std::string> names;
    for (const Part& part : parts) {
        if (!part.name.empty()) names.push_back(part.name);
    }
    const std::string hint = did_you_mean(name, names);
    refuse(
        problem,
        kind + "." + name,
        "the deck has none" + (hint.empty() && !names.empty() ? "; known here: " + plain_list(names) : hint));
}

// Energy and momentum are kept by elastic rods alone.
void check_scheme(const Problem& problem, const std::string& key) {
    for (const StagePlan& stage : problem.stages) {
        const auto* dynamic = std::get_if<DynamicSettings>(&stage.analysis);
        if (dynamic == nullptr || !card_of(dynamic->scheme).conserves_energy) continue;
        refuse(problem,
               key,
               "\"energy-momentum\" keeps nothing with a law or force of the program; expected another "
               "integrator, such as \"gauss-4\"");
    }
}

bool is_used_as_it_is(const Problem& problem, const Section& section) {
    const auto index = static_cast<int>(&section - problem.model.sections.data());
    return std::ranges::any_of(problem.model.rods, [&](const Rod& rod) {
        return rod.section == index && !rod.has_varying_sections();
    });
}

}  // namespace

void set_section_law(const std::string& name, std::shared_ptr<const SectionLaw> law, Problem& problem) {
    const std::string key = "section." + name;
    Section& section = find(problem.model.sections, "section", name, problem);
    if (!is_used_as_it_is(problem, section))
        refuse(problem, key, "no rod has this section all along, as one with a law of the program must");
    check_scheme(problem, key);
    const std::vector<double> memory(static_cast<std::size_t>(law->memory_size()));
    const SectionResponse rest =
        law->respond(Vec6::Zero(), memory, std::numeric_limits<double>::infinity(), {});
    if (!rest.resultants.allFinite() || !rest.tangent.allFinite())
        refuse(problem, key, "the program's law is not finite at strains of zero");
    for (const HistoryRequest& history : problem.output.histories) {
        const auto* point = std::get_if<WatchedPoint>(&history.target);
        if (point == nullptr || &section_at(problem.model, point->place) != &section) continue;
        if (std::ranges::any_of(history.quantities, is_stress_quantity))
            refuse(problem, key, "history " + history.name + " has stresses, which do not follow from a law");
    }
    section.stiffness = rest.tangent;
    section.law = std::move(law);
}

void set_spring_force(const std::string& name, const OwnForce& own, Problem& problem) {
    const std::string key = "spring." + name;
    Spring& spring = find(problem.model.springs, "spring", name, problem);
    check_scheme(problem, key);
    if (spring.law)
        refuse(problem, key + ".force", "the program gives the spring a force too; only one of them can be");
    const Model& model = problem.model;
    const double length = (find_place(model, spring.ends[1]) - find_place(model, spring.ends[0])).norm();
    if (!(length > 0.0))
        refuse(problem,
               key,
               "the points are at one place at t = 0, where a force along the spring has no direction");
    const double at_start = own.force(length, 0.0);
    if (!std::isfinite(at_start))
        refuse(problem,
               key,
               fmt::format(
                   "the program's force is {} at t = 0, with length = {} and rate = 0", at_start, length));
    spring.law = std::make_shared<const SpringLaw>(own.force, own.has_rate, length);
}

void set_load_force(std::size_t load, const MotionForce& force, Problem& problem) {
    const std::string key = fmt::format("load[{}]", load);
    check_scheme(problem, key);
    bool is_there = false;
    const auto set = [&](std::vector<NodalLoad>& loads) {
        for (NodalLoad& one : loads) {
            if (one.key != key) continue;
            is_there = true;
            if (one.by_motion)
                refuse(problem,
                       key + ".force",
                       "depends on the motion already; the program's force cannot be added");
            one.by_motion = MotionLoad(force);
        }
    };
    set(problem.model.loads);
    for (StagePlan& stage : problem.stages) set(stage.actions.loads);
    if (!is_there) refuse(problem, key, "the deck has no such load at a point");
}

void set_course(const std::string& name, const std::function<double(double)>& course, Problem& problem) {
    const auto& inputs = problem.model.inputs;
    const auto found = std::ranges::find(inputs, name, &Input::name);
    if (found == inputs.end()) refuse(problem, "input." + name, "the deck has none");
    (*found)->plan(TimeFunction(course), (*found)->hold());
}

}  // namespace gxrod
