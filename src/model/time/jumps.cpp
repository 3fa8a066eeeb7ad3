#include "model/time/jumps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "model/ties/ties.hpp"
#include "model/time/transitions.hpp"

namespace gxrod {

namespace {

class JumpSearch {
  public:
    JumpSearch(const Interval& times, int samples) : times_(times), samples_(samples) {}

    void look(const TimeFunction& function) {
        for (const Transition& one : find_transitions(function, times_, samples_)) {
            if (one.is_jump && one.time > times_.from && one.time < times_.to) found_.push_back(one.time);
        }
    }
    template <std::size_t N>
    void look(const std::array<TimeFunction, N>& functions) {
        for (const TimeFunction& function : functions) look(function);
    }
    void look(const std::optional<TimeFunction>& function) {
        if (function) look(*function);
    }
    void look(const JointCoordinate& coordinate) {
        look(coordinate.motion);
        look(coordinate.drive);
        look(coordinate.rest);
    }
    void look(const LineFunction& function, double length) {
        const auto& switches = function.switches();
        if (switches == nullptr || function.form().in_time == InTime::constant) return;
        const auto travels = [](const Switch& one) { return one.has_time && one.has_arc_length; };
        if (std::ranges::any_of(*switches, travels)) return;
        for (const double part : {0.0, 0.17, 0.39, 0.5, 0.71, 1.0}) {
            look(TimeFunction([&function, s = part * length](double t) { return function(t, s); }, switches));
            if (function.form().is_even) return;
        }
    }
    template <std::size_t N>
    void look(const std::array<LineFunction, N>& functions, double length) {
        for (const LineFunction& function : functions) look(function, length);
    }

    std::vector<double> take() {
        std::ranges::sort(found_);
        const double close = 2.0 * (sides_of_jump(0.0, times_).after);
        const auto are_one = [&](double a, double b) { return b - a <= close; };
        found_.erase(std::unique(found_.begin(), found_.end(), are_one), found_.end());
        return std::move(found_);
    }

  private:
    Interval times_;
    int samples_;
    std::vector<double> found_;
};

}  // namespace

JumpSides sides_of_jump(double time, const Interval& times) {
    const double nearest =
        16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(times.from), std::abs(times.to));
    return {time - nearest, time + nearest};
}

std::vector<double> find_jumps(const Model& model, const Interval& times, int samples) {
    JumpSearch search(times, samples);
    search.look(model.gravity.components());
    for (const NodalLoad& load : model.loads) {
        search.look(load.force);
        search.look(load.moment);
    }
    const auto length_of = [&](int rod) { return model.rods[static_cast<std::size_t>(rod)].length; };
    for (const DistributedLoad& load : model.distributed_loads) {
        search.look(load.force, length_of(load.rod));
        search.look(load.moment, length_of(load.rod));
        if (load.field) search.look(load.field->uniform);
    }
    for (const Actuation& actuation : model.actuations) {
        search.look(actuation.strain, length_of(actuation.rod));
        search.look(actuation.temperature, length_of(actuation.rod));
        search.look(actuation.temperature_gradient, length_of(actuation.rod));
    }
    for (const Tendon& tendon : model.tendons) {
        search.look(tendon.tension);
        if (!tendon.winch) continue;
        search.look(tendon.winch->shortening);
        search.look(tendon.winch->length);
        search.look(tendon.winch->share);
        if (tendon.winch->gas) search.look(tendon.winch->gas->pressure);
    }
    if (model.surroundings.water) search.look(model.surroundings.water->factor);
    if (model.surroundings.seabed) search.look(model.surroundings.seabed->factor);
    for (const Support& support : model.supports) search.look(support.motion);
    for_each_coordinates(
        model, [&](std::size_t, const std::string&, const auto& turn, const JointCoordinate& slide) {
            search.look(turn);
            search.look(slide);
        });
    return search.take();
}

}  // namespace gxrod
