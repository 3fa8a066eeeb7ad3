#include "check/findings/function_examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "check/step_impulse.hpp"
#include "model/evaluation_error.hpp"
#include "model/ties/ties.hpp"
#include "model/time/transitions.hpp"

namespace gxrod {
namespace {

constexpr long most_samples = 1000;
constexpr long fewest_samples = 64;
// Of a step, for the rate of a move at the start.
constexpr double start_step = 1e-3;
// Of the mean velocity of a move; a start at once.
constexpr double smallest_start = 1e-2;

int sample_count(const DynamicSettings& settings) {
    return static_cast<int>(std::clamp(settings.steps, fewest_samples, most_samples));
}

// Steps that are chosen by their error can grow.
double longest_step(const DynamicSettings& settings) {
    const double first = settings.time_step();
    if (!settings.adaptive || !std::isfinite(settings.adaptive->max_step)) return first;
    return std::max(first, settings.adaptive->max_step);
}

class FunctionExamination {
  public:
    FunctionExamination(const Model& model, const DynamicSettings& settings, bool is_moving)
        : model_(model), settings_(settings), is_moving_(is_moving), integrator_(make_integrator(settings)) {}

    std::vector<Finding> run() {
        const std::array<TimeFunction, 3>& gravity = model_.gravity.components();
        for (std::size_t i = 0; i < 3; ++i) examine_load(fmt::format("gravity[{}]", i), gravity[i]);
        for (const NodalLoad& load : model_.loads) {
            for (std::size_t i = 0; i < 3; ++i) {
                examine_load(fmt::format("{}.force[{}]", load.key, i), load.force[i]);
                examine_load(fmt::format("{}.moment[{}]", load.key, i), load.moment[i]);
            }
        }
        for (const DistributedLoad& load : model_.distributed_loads) {
            const double middle = 0.5 * model_.rods[load.rod].length;
            if (load.field) {
                examine_magnet(load, middle);
                continue;
            }
            for (std::size_t i = 0; i < 3; ++i) {
                examine_line(fmt::format("{}.force_per_length[{}]", load.key, i), load.force[i], middle);
                examine_line(fmt::format("{}.moment_per_length[{}]", load.key, i), load.moment[i], middle);
            }
        }
        for (const Tendon& tendon : model_.tendons) examine_tendon(tendon);
        for (const Actuation& actuation : model_.actuations) examine_actuation(actuation);
        for (const Support& support : model_.supports) examine_moves(support);
        for_each_coordinates(
            model_,
            [this](std::size_t, const std::string& name, const auto& turn, const JointCoordinate& slide) {
                examine_coordinate(name, "turn", turn);
                examine_coordinate(name, "slide", slide);
            });
        for (const Obstacle& obstacle : model_.contact.obstacles) examine_obstacle(obstacle);
        return std::move(findings_);
    }

  private:
    void examine_load(const std::string& key, const TimeFunction& function) {
        if (function.is_constant()) return;
        examine(
            key, [&function](double time) { return function(time); }, function.switches().get());
    }

    void examine_tendon(const Tendon& tendon) {
        examine_load(fmt::format("tendon.{}.tension", tendon.name), tendon.tension);
        if (!tendon.winch || tendon.winch->is_released) return;
        if (tendon.winch->gas) {
            examine_load(fmt::format("chamber.{}.gas.pressure", tendon.name), tendon.winch->gas->pressure);
        } else if (tendon.winch->stiffness > 0.0) {
            examine_load(fmt::format("tendon.{}.shortening", tendon.name), tendon.winch->shortening);
        } else if (!tendon.winch->length) {
            examine_move(fmt::format("the winch of tendon {} draws it in", tendon.name),
                         tendon.winch->shortening);
        }
    }

    void examine_actuation(const Actuation& actuation) {
        const double middle = 0.5 * model_.rods[actuation.rod].length;
        static constexpr std::array strains{
            "stretch", "shear[0]", "shear[1]", "curvature[0]", "curvature[1]", "curvature[2]"};
        for (std::size_t i = 0; i < strains.size(); ++i)
            examine_line(actuation.key + "." + strains[i], actuation.strain[i], middle);
        examine_line(actuation.key + ".temperature", actuation.temperature, middle);
        for (std::size_t i = 0; i < 2; ++i) {
            examine_line(fmt::format("{}.temperature_gradient[{}]", actuation.key, i),
                         actuation.temperature_gradient[i],
                         middle);
        }
    }

    void examine_obstacle(const Obstacle& obstacle) {
        if (!obstacle.motion) return;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string key = fmt::format("obstacle.{}.move.{}", obstacle.name, component_names[i]);
            examine_load(key, obstacle.motion->displacement.components()[i]);
        }
    }

    void examine_magnet(const DistributedLoad& load, double middle) {
        for (std::size_t i = 0; i < 3; ++i) {
            examine_load(fmt::format("{}.field[{}]", load.key, i), load.field->uniform[i]);
            examine_line(fmt::format("{}.moment[{}]", load.key, i), load.moment[i], middle);
        }
    }

    // A load along a rod in the middle of it; not one whose jumps travel, which passes a place as a pulse.
    void examine_line(const std::string& key, const LineFunction& function, double middle) {
        if (function.is_constant() || function.form().in_time == InTime::constant) return;
        const Switches* switches = function.switches().get();
        const auto travels = [](const Switch& one) { return one.has_time && one.has_arc_length; };
        if (switches != nullptr && std::any_of(switches->begin(), switches->end(), travels)) return;
        examine(
            key, [&](double time) { return function(time, middle); }, switches);
    }

    void examine(const std::string& key,
                 const std::function<double(double)>& value,
                 const Switches* switches) {
        try {
            TimedLoad load{value, {}};
            if (switches != nullptr) {
                load.breaks =
                    find_breaks_in_time(*switches, {0.0, settings_.end_time}, sample_count(settings_));
            }
            const auto lost =
                find_lost_impulse(load, {settings_.end_time, longest_step(settings_)}, *integrator_);
            if (lost) findings_.push_back({Severity::warning, describe(key, *lost)});
        } catch (const EvaluationError&) {
            return;  // the deck's reader has looked at the steps; between them the load may have no value
        }
    }

    std::string describe(const std::string& key, const LostImpulse& lost) const {
        return fmt::format(
            "{}: between t = {:.6g} and {:.6g} steps of {:.6g} give it the integral {:.4g} over time instead "
            "of "
            "{:.4g}; expected steps of {:.3g} or less (analysis.time_step)",
            key,
            lost.from,
            lost.to,
            longest_step(settings_),
            lost.given,
            lost.exact,
            lost.step_needed);
    }

    void examine_moves(const Support& support) {
        for (std::size_t i = 0; i < support.motion.size(); ++i) {
            if (!support.moved[i]) continue;
            examine_move(
                fmt::format(
                    "the [[support]] at {} moves {}", model_.nodes[support.node].name, component_names[i]),
                support.motion[i]);
        }
    }

    void examine_coordinate(const std::string& joint, const char* name, const JointCoordinate& coordinate) {
        if (coordinate.motion)
            examine_move(fmt::format("the motor of joint {} moves its {}", joint, name), *coordinate.motion);
        examine_load(fmt::format("joint.{}.drive ({})", joint, name), coordinate.drive);
        if (coordinate.stiffness > 0.0)
            examine_load(fmt::format("joint.{}.spring.rest ({})", joint, name), coordinate.rest);
    }

    // `what`: "the [[support]] at hub moves rx". Without inertia no motion is a blow, and of one between
    // steps no more need be said.
    void examine_move(const std::string& what, const TimeFunction& motion) {
        const std::size_t before = findings_.size();
        examine_load(what, motion);
        if (!settings_.has_inertia || findings_.size() > before) return;
        try {
            examine_kinks(what, motion);
            examine_start(what, motion);
        } catch (const EvaluationError&) {
            return;
        }
    }

    void examine_kinks(const std::string& what, const TimeFunction& motion) {
        std::vector<Transition> kinks =
            find_transitions(motion, {0.0, settings_.end_time}, sample_count(settings_));
        std::erase_if(kinks, [](const Transition& one) { return !one.is_kink; });
        if (kinks.empty()) return;
        const Transition& first = kinks.front();
        const std::string more =
            kinks.size() == 1 ? "" : fmt::format(" (and at {} more times)", kinks.size() - 1);
        findings_.push_back(
            {Severity::warning,
             fmt::format(
                 "{} with a velocity that jumps from {:.4g} to {:.4g} at t = "
                 "{:.6g}{}: each jump is a blow, whose reaction grows as steps become shorter; expected a "
                 "smooth motion, such as a [function] with interpolation = \"cubic\"",
                 what,
                 first.slope_before,
                 first.slope_after,
                 first.time,
                 more)});
    }

    // Rods at rest, one end of which moves at once.
    void examine_start(const std::string& what, const TimeFunction& motion) {
        const auto is_at_rest = [](const Node& one) {
            return one.velocity.isZero(0.0) && one.angular_velocity.isZero(0.0);
        };
        if (is_moving_ || model_.rods.empty() ||
            !std::all_of(model_.nodes.begin(), model_.nodes.end(), is_at_rest))
            return;
        const double step = start_step * settings_.time_step();
        const double rate = (4.0 * motion(step) - motion(2.0 * step) - 3.0 * motion(0.0)) / (2.0 * step);
        double size = 0.0;
        for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            size = std::max(size, std::abs(motion(part * settings_.end_time)) / settings_.end_time);
        }
        if (std::abs(rate) <= smallest_start * size) return;
        findings_.push_back(
            {Severity::note,
             fmt::format(
                 "{} at a velocity of {:.4g} from t = 0 on, while the model is "
                 "at "
                 "rest: the start is a blow; a motion that begins smoothly, or velocities by [[initial]], "
                 "would be none",
                 what,
                 rate)});
    }

    const Model& model_;
    const DynamicSettings& settings_;
    bool is_moving_;
    std::unique_ptr<Integrator> integrator_;
    std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> examine_functions(const Model& model, const DynamicSettings& settings, bool is_moving) {
    return FunctionExamination(model, settings, is_moving).run();
}

}  // namespace gxrod
