#include "check/shape_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

#include "assembly/small_motions.hpp"
#include "assembly/touching_system.hpp"
#include "model/sections/small_motion_law.hpp"

namespace gxrod {
namespace {

std::string plural(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// "75 % along x, 68 % about y"
std::string describe_effective_mass(const ModesRecord& record) {
    static constexpr std::array<const char*, 6> directions{
        "along x", "along y", "along z", "about x", "about y", "about z"};
    constexpr double percent = 100.0;
    std::string text;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double share = record.effective_share[static_cast<int>(i)];
        if (record.total_mass[static_cast<int>(i)] <= 0.0) continue;
        text += fmt::format("{}{:.0f} % {}", text.empty() ? "" : ", ", percent * share, directions[i]);
    }
    return text;
}

// "sections of beam and arm relax"
std::string name_relaxing_rods(const Model& model) {
    std::vector<std::string> names;
    for (const Rod& rod : model.rods) {
        const auto& law = model.sections[static_cast<std::size_t>(rod.section)].law;
        if (law && !list_relaxing_stiffness(*law).empty()) names.push_back(rod.name);
    }
    constexpr std::size_t most = 3;
    const bool are_many = names.size() > most;
    if (are_many) names.resize(most);
    return fmt::format("sections of {}{} relax", fmt::join(names, ", "), are_many ? ", …" : "");
}

class Lister {
  public:
    explicit Lister(std::size_t most) : most_(most) {}

    std::vector<std::string> operator()(const ModesRecord& record) {
        lines_.push_back(head(record));
        std::size_t number = 0;
        for (const Mode& mode : record.modes) {
            const std::string value = mode.growth > 0.0
                                          ? fmt::format("grows by exp({:.6g} t)  ", mode.growth)
                                          : fmt::format("{:<12.8g} ω {:<12.8g}", mode.frequency, mode.omega);
            add(++number, value + mode.shape.words);
        }
        end(record.modes.size());
        const std::string mass = describe_effective_mass(record);
        if (!mass.empty() && !record.modes.empty()) lines_.push_back("effective mass together: " + mass);
        return lines_;
    }

    std::vector<std::string> operator()(const BucklingRecord& record) {
        lines_.push_back(fmt::format("{} on the loads at t = {:.6g}, by linear theory{}",
                                     plural(record.factors.size(), "buckling factor"),
                                     record.load_time,
                                     record.is_complete ? ", and none below (counted)" : ""));
        std::size_t number = 0;
        constexpr double noticeable = 0.02;
        if (record.mesh_error > noticeable) {
            lines_.push_back(fmt::format(
                "the mesh is coarse for this: the first factor is too high by some {:.2g} %, most "
                "of it by rod {}; take more elements, or a higher order",
                100.0 * record.mesh_error,
                record.coarse_rod));
        }
        for (const BucklingFactor& one : record.factors)
            add(++number, fmt::format("{:<12.8g} {}", one.factor, one.shape.words));
        end(record.factors.size());
        if (!record.reversed.empty()) {
            lines_.push_back(fmt::format("the loads turned round: {:.8g} {}",
                                         -record.reversed.front().factor,
                                         record.reversed.front().shape.words));
        }
        return lines_;
    }

    std::vector<std::string> operator()(const EigenvaluesRecord& record) {
        const char* whole = record.is_all        ? ", all that the model has"
                            : record.is_complete ? ", and none missed nearer to 0 (counted)"
                                                 : "";
        lines_.push_back(plural(record.modes.size(), "eigenvalue") + whole);
        std::size_t number = 0;
        for (const Eigenmode& mode : record.modes) {
            const std::string value =
                mode.omega == 0.0
                    ? fmt::format(
                          "{} as exp({:.6g} t)  ", mode.growth > 0.0 ? "grows" : "decays", mode.growth)
                    : fmt::format("{:<12.8g} ω {:<12.8g} Re λ {:<13.6g} damping {:<10.4g} ",
                                  mode.frequency,
                                  mode.omega,
                                  drop_round_off(mode.growth, mode),
                                  drop_round_off(mode.damping_ratio, mode));
            add(++number, value + mode.shape.words);
        }
        end(record.modes.size());
        return lines_;
    }

    std::vector<std::string> operator()(const ResponseRecord& record) {
        lines_.push_back(fmt::format("the answer at {} frequencies, ω from {:.6g} to {:.6g}",
                                     record.responses.size(),
                                     record.responses.front().omega,
                                     record.responses.back().omega));
        std::size_t number = 0;
        for (const ResponsePoint& point : record.points) {
            const Response* largest = nullptr;
            double size = -1.0;
            for (const Response& response : record.responses) {
                if (!response.failure.empty()) continue;
                const double amplitude =
                    std::sqrt(response.motion.real[point.node].head<3>().squaredNorm() +
                              response.motion.imaginary[point.node].head<3>().squaredNorm());
                if (amplitude <= size) continue;
                size = amplitude;
                largest = &response;
            }
            if (largest == nullptr) continue;
            add(++number,
                fmt::format("{}: largest amplitude {:.6g}, at ω = {:.6g}", point.name, size, largest->omega));
        }
        end(number);
        return lines_;
    }

    std::vector<std::string> operator()(const SweepRecord& record) {
        lines_.push_back(fmt::format("{} followed over {} values of {}, from {:.6g} to {:.6g}",
                                     plural(record.words.size(), "mode"),
                                     record.points.size(),
                                     record.key,
                                     record.points.front().value,
                                     record.points.back().value));
        for (std::size_t i = 0; i < record.words.size(); ++i) {
            const double first = find_omega(record.points, i),
                         last = find_omega(std::views::reverse(record.points), i);
            add(i + 1, fmt::format("ω {:<10.6g} … {:<10.6g} {}", first, last, record.words[i]));
        }
        end(record.words.size());
        for (const Onset& onset : record.onsets) {
            const std::string omega = onset.is_flutter ? fmt::format(", ω = {:.8g}", onset.omega) : "";
            lines_.push_back(fmt::format("{} {} at {} = {:.10g}{}",
                                         name_kind(onset),
                                         onset.begins ? "begins" : "ends",
                                         record.key,
                                         onset.value,
                                         omega));
        }
        return lines_;
    }

  private:
    // The first one that is known.
    template <class Points>
    static double find_omega(const Points& points, std::size_t mode) {
        for (const SweepRecord::Point& point : points) {
            if (mode < point.lambda.size() && !std::isnan(point.lambda[mode].imag()))
                return std::abs(point.lambda[mode].imag());  // without the sign of zero
        }
        return std::nan("");
    }
    // Of an undamped motion.
    static double drop_round_off(double value, const Eigenmode& mode) {
        constexpr double round_off = 1e-9;
        return std::abs(mode.damping_ratio) < round_off ? 0.0 : value;
    }
    static std::string head(const ModesRecord& record) {
        const std::size_t count = record.modes.size();
        if (record.is_all) return plural(count, "mode") + ", all that the model has";
        const double below = std::sqrt(std::max(0.0, record.limit)) / (2.0 * std::numbers::pi);
        return fmt::format("{} below {:.6g} cycles per time{}",
                           plural(count, "mode"),
                           below,
                           record.is_complete ? ", and no others (counted)" : "");
    }

    void add(std::size_t number, const std::string& text) {
        if (number <= most_) lines_.push_back(fmt::format("{:>4}  {}", number, text));
    }
    void end(std::size_t count) {
        if (count > most_) lines_.push_back(fmt::format("      and {} more", count - most_));
    }

    std::size_t most_;
    std::vector<std::string> lines_;
};

struct Warner {
    std::vector<std::string> operator()(const ModesRecord& record) const {
        std::vector<std::string> sentences;
        if (record.unstable > 0) {
            sentences.push_back(fmt::format("the state is unstable: {} of the modes {} instead of vibrating",
                                            record.unstable,
                                            record.unstable == 1 ? "grows" : "grow"));
        }
        if (!record.is_symmetric) {
            sentences.push_back(fmt::format(
                "{}, so the stiffness is not symmetric: the modes are those of its symmetric part, which "
                "differs by {:.2g} of the squared frequencies and says nothing about flutter",
                record.cause,
                record.unsymmetry));
        }
        if (record.failure.empty() && !record.is_complete) sentences.push_back(describe_count(record));
        return sentences;
    }

    std::vector<std::string> operator()(const BucklingRecord& record) const {
        std::vector<std::string> sentences;
        if (!record.is_symmetric) {
            sentences.push_back(record.cause +
                                ", so the stiffness is not symmetric: the factors are those of its symmetric "
                                "part, and say nothing about flutter");
        }
        if (record.failure.empty() && !record.is_complete)
            sentences.push_back("the pivots do not confirm that no smaller factor was missed");
        return sentences;
    }

    std::vector<std::string> operator()(const EigenvaluesRecord& record) const {
        std::vector<std::string> sentences;
        if (record.unstable > 0) {
            const Eigenmode& worst = *std::max_element(
                record.modes.begin(), record.modes.end(), [](const Eigenmode& a, const Eigenmode& b) {
                    return a.growth < b.growth;
                });
            sentences.push_back(
                fmt::format("the state is unstable by {}: {} grow{}, at most as exp({:.4g} t){}",
                            worst.omega == 0.0 ? "divergence" : "flutter",
                            plural(static_cast<std::size_t>(record.unstable), "motion"),
                            record.unstable == 1 ? "s" : "",
                            worst.growth,
                            worst.omega == 0.0 ? "" : fmt::format(", with ω = {:.6g}", worst.omega)));
        }
        if (record.failure.empty() && !record.is_complete && !record.is_all) {
            sentences.push_back(record.missing > 0
                                    ? fmt::format("{} eigenvalues nearer to 0 may be missing", record.missing)
                                    : "the determinant could not be counted: an eigenvalue may be missing");
        }
        return sentences;
    }

    std::vector<std::string> operator()(const ResponseRecord& record) const {
        for (const Response& response : record.responses) {
            if (response.failure.empty()) continue;
            return {fmt::format("at ω = {:.6g} there is no answer: {}", response.omega, response.failure)};
        }
        return {};
    }

    std::vector<std::string> operator()(const SweepRecord& record) const {
        std::vector<std::string> sentences;
        const auto fails = [](const SweepRecord::Point& point) { return !point.failure.empty(); };
        const auto failed = std::ranges::find_if(record.points, fails);
        if (failed != record.points.end()) {
            sentences.push_back(fmt::format("nothing was found at {} of {} values of {}; at {:.6g}: {}",
                                            std::ranges::count_if(record.points, fails),
                                            record.points.size(),
                                            record.key,
                                            failed->value,
                                            failed->failure));
        }
        for (std::size_t i = 0; i < record.words.size(); ++i) {
            const auto loses = [&](const SweepRecord::Point& point) {
                return !fails(point) && std::isnan(point.lambda[i].real());
            };
            const auto lost = std::ranges::find_if(record.points, loses);
            if (lost == record.points.end()) continue;
            sentences.push_back(
                fmt::format("mode {} is lost at {} = {:.6g}: other modes came nearer to 0, or it split; a "
                            "larger count keeps it longer",
                            i + 1,
                            record.key,
                            lost->value));
        }
        return sentences;
    }

    static std::string describe_count(const ModesRecord& record) {
        if (record.counted < 0) return "the pivots could not be counted: a mode may be missing";
        if (record.counted == record.found) {
            double worst = 0.0;
            for (const Mode& mode : record.modes) worst = std::max(worst, mode.residual);
            return fmt::format(
                "the modes are all that the pivots count, but one of them is known to {:.2g} of its "
                "squared frequency only",
                worst);
        }
        return fmt::format("{} modes were found where the pivots count {}: {} may be missing",
                           record.found,
                           record.counted,
                           record.counted - record.found);
    }
};

}  // namespace

std::vector<std::string> list_shapes(const ShapesRecord& record, std::size_t most) {
    return std::visit(Lister(most), record);
}

std::vector<std::string> warn_of_shapes(const ShapesRecord& record) { return std::visit(Warner{}, record); }

std::string find_failure(const ShapesRecord& record) {
    return std::visit(
        [](const auto& found) -> std::string {
            if constexpr (requires { found.failure; }) return found.failure;
            return "";
        },
        record);
}

namespace {

bool goes_on_loading(const ShapesRecord& record) {
    const auto* modes = std::get_if<ModesRecord>(&record);
    const auto* buckling = std::get_if<BucklingRecord>(&record);
    return (modes != nullptr && modes->linearization == Linearization::loading) ||
           (buckling != nullptr && buckling->linearization == Linearization::loading);
}

}  // namespace

std::vector<std::string> note_sections(const System& given,
                                       const State& accepted,
                                       const ShapesRecord& record) {
    const TouchingSystem touching(given, accepted);
    const System& system = touching.system();
    const State& state = touching.state();
    std::vector<std::string> notes;
    const SmallMotions small(system);
    const bool is_buckling = std::holds_alternative<BucklingRecord>(record);
    if (small.relaxes() && std::holds_alternative<ModesRecord>(record)) {
        notes.push_back(
            name_relaxing_rods(system.model()) +
            ": the modes are those of the stiffness after a long time; kind = \"eigenvalues\" finds "
            "how fast it vibrates and how that is damped");
    } else if (small.relaxes() && is_buckling) {
        notes.push_back(name_relaxing_rods(system.model()) +
                        ": the factors are those of loads that stay, of the stiffness after a long time");
    } else if (small.relaxes() && !std::holds_alternative<ResponseRecord>(record)) {
        notes.push_back(name_relaxing_rods(system.model()) +
                        ": motions with a damping ratio above 0.99, by which it creeps, are not listed");
    }
    const bool is_loading = goes_on_loading(record);
    const double length = small.measure_length_at_limit(state, state.time);
    if (length > 0.0 && !std::holds_alternative<SweepRecord>(record)) {
        notes.push_back(fmt::format(
            "sections are about to yield or to slip over a length of {:.3g}: their stiffness is taken as "
            "{}{}",
            length,
            is_loading ? "under more load" : "elastic, as if they unloaded",
            is_buckling && !is_loading
                ? R"(, which makes factors too high where more load yields; linearization = "loading" takes the other)"
                : ""));
    }
    const std::vector<std::string> at_limit = small.list_friction_at_limit(state, state.time);
    if (!at_limit.empty() && !std::holds_alternative<SweepRecord>(record)) {
        notes.push_back(fmt::format(
            "friction of {} is at its limit: it is taken to {}{}",
            fmt::join(at_limit, ", "),
            is_loading ? "slip" : "stick, as in small motions",
            is_buckling && !is_loading ? ", which makes factors too high where more load slips" : ""));
    }
    return notes;
}

std::string describe_left_out_loads(const Model& model) {
    std::vector<std::string> names;
    if (!model.gravity.is_zero()) names.emplace_back("gravity");
    for (const NodalLoad& load : model.loads) names.push_back(load.key);
    for (const DistributedLoad& load : model.distributed_loads) names.push_back(load.key);
    if (names.empty()) return "";
    constexpr std::size_t most = 5;
    const std::string rest = names.size() > most ? " …" : "";
    if (names.size() > most) names.resize(most);
    return fmt::format(
        "about the reference shape, where {}{} do{} not act: put a [[stage]] of kind static "
        "before for the loaded one",
        fmt::join(names, ", "),
        rest,
        names.size() == 1 ? "es" : "");
}

}  // namespace gxrod
