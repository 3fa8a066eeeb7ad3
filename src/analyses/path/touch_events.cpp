#include "analyses/path/touch_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/contact/contacts.hpp"
#include "model/contact.hpp"
#include "model/model.hpp"
#include "solvers/path/root_search.hpp"
#include "state/contact_touch.hpp"

namespace gxrod {

namespace {

constexpr double not_found = std::numeric_limits<double>::quiet_NaN();

bool is_obstacle(int thing) { return thing < 0; }

std::size_t rod_count(const Model& model) { return model.rods.size(); }

double find_skin(const Model& model, int thing) {
    const auto index = static_cast<std::size_t>(thing);
    if (index < rod_count(model)) return model.contact.skin * model.contact.radii[index];
    for (const ContactBody& body : model.contact.bodies) {
        if (static_cast<std::size_t>(body.body) == index - rod_count(model))
            return model.contact.skin * body.radius;
    }
    return 0.0;
}

// The gap at which contact begins to act: the skin, or none on a bed.
double find_touching_gap(const Model& model, const TouchingThings& things) {
    const double skin = find_skin(model, things[0]);
    if (!is_obstacle(things[1])) return std::min(skin, find_skin(model, things[1]));
    const Obstacle& obstacle = model.contact.obstacles[static_cast<std::size_t>(-1 - things[1])];
    return obstacle.stiffness ? 0.0 : skin;
}

std::vector<TouchingThings> list_things(const System& system, const State& state, double time) {
    std::vector<TouchingThings> things;
    for (const ContactTouch& touch : Contacts(system).list_touches(state, time)) things.push_back(touch.rods);
    std::ranges::sort(things);
    things.erase(std::ranges::unique(things).begin(), things.end());
    return things;
}

std::string name_thing(const Model& model, int thing) {
    if (is_obstacle(thing))
        return "obstacle " + model.contact.obstacles[static_cast<std::size_t>(-1 - thing)].name;
    const auto index = static_cast<std::size_t>(thing);
    if (index < rod_count(model)) return "rod " + model.rods[index].name;
    return "body " + model.bodies[index - rod_count(model)].name;
}

}  // namespace

TouchSearch::TouchSearch(PathContext& work, const PathVector& direction, const PathTrial& end)
    : work_(work), direction_(direction), end_(end) {
    // A gap that is so near to the skin's edge was located there by the step before.
    constexpr double located = 1e-5;
    State start = work.state;
    undo_trial(start);
    Contacts(work.system).search(start);
    std::vector<TouchingThings> all = list_things(work.system, start, start.time);
    const std::vector<TouchingThings> after = list_things(work.system, work.state, end.load_factor);
    all.insert(all.end(), after.begin(), after.end());
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    for (const TouchingThings& things : all) {
        const Change change{
            things, measure(things, start, start.time), measure(things, work.state, end.load_factor)};
        const double skin =
            std::max(find_skin(work.system.model(), things[0]), std::numeric_limits<double>::min());
        if ((change.before < 0.0) != (change.after < 0.0) && std::abs(change.before) > located * skin)
            changes_.push_back(change);
    }
}

double TouchSearch::measure(const TouchingThings& things, const State& state, double load_factor) const {
    const ContactWatch watch{.rod = things[0], .other = things[1], .wants_gap = true};
    return Contacts(work_.system).compute_watched(watch, {}, state, load_factor).least_gap -
           find_touching_gap(work_.system.model(), things);
}

TouchEvent TouchSearch::list() const {
    TouchEvent event;
    event.begins = changes_.front().after < 0.0;
    for (const Change& change : changes_) {
        if ((change.after < 0.0) == event.begins) event.things.push_back(change.things);
    }
    return event;
}

std::optional<TouchEvent> TouchSearch::locate(PathTrial& trial) {
    constexpr double same = 1e-6;  // of the skin
    // The first of several is the one that changes in every shorter step.
    for (std::vector<Change> left = changes_; !left.empty();) {
        const Change one = left.front();
        const double skin = find_skin(work_.system.model(), one.things[0]);
        const double root = find_root(
            {0.0, one.before, end_.step, one.after}, {1e-12 * end_.step, same * skin, 60}, [&](double step) {
                return solve_exact_step(work_, direction_, step, trial)
                           ? measure(one.things, work_.state, trial.load_factor)
                           : not_found;
            });
        if (!std::isfinite(root)) return std::nullopt;
        TouchEvent event;
        event.begins = one.after < 0.0;
        std::vector<Change> earlier;
        for (Change& change : left) {
            const double there = measure(change.things, work_.state, trial.load_factor);
            if (std::abs(there) <= 10.0 * same * skin) {
                if ((change.after < 0.0) == event.begins) event.things.push_back(change.things);
            } else if ((there < 0.0) == (change.after < 0.0)) {
                change.after = there;
                earlier.push_back(change);
            }
        }
        if (earlier.empty() && !event.things.empty()) return event;
        if (earlier.empty()) return std::nullopt;
        end_ = trial;
        left = std::move(earlier);
    }
    return std::nullopt;
}

std::string name_touching(const Model& model, const std::vector<TouchingThings>& things) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, things.size()); ++i) {
        if (i > 0) text += ", ";
        const auto [one, other] = things[i];
        text += one == other ? fmt::format("{} and itself", name_thing(model, one))
                             : fmt::format("{} and {}", name_thing(model, one), name_thing(model, other));
    }
    if (things.size() > most) text += fmt::format(" and {} more", things.size() - most);
    return text;
}

}  // namespace gxrod
