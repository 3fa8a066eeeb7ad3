#include "check/shape_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

  private:
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

    static std::string describe_count(const ModesRecord& record) {
        if (record.counted < 0) return "the pivots could not be counted: a mode may be missing";
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
    return std::visit([](const auto& found) { return found.failure; }, record);
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
