#include <fmt/format.h>

#include <algorithm>

#include "deck/drives/build_signals.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "model/settings/analysis_traits.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

struct PidTable : TableHead {
    double proportional = 0.0, integral = 0.0, derivative = 0.0;
};

struct SignalTable : TableHead {
    std::optional<std::string> measure;
    std::optional<CheckedTimeFunction> value;
    std::optional<double> filter, lower, upper;
    std::optional<bool> rate, continuous;
    std::optional<PidTable> pid;
    std::optional<InputHold> hold;
    double start = 0.0;
};

const TableSpec& pid_table() {
    using T = PidTable;
    // clang-format off
    static const TableSpec table = Table<T>("signal.NAME.pid", "")
        .key("proportional", &T::proportional, "Output per error.").unit("1").also("p kp gain")
        .key("integral", &T::integral, "Output per time integral of the error. While the output is beyond `lower` or "
             "`upper`, the integral does not grow further to that side.").unit("1/time").also("i ki")
        .key("derivative", &T::derivative, "Output per rate of the error.").unit("time").also("d kd")
        .at_least_one_of({"proportional", "integral", "derivative"});
    // clang-format on
    return table;
}

// A name of a history, a quantity and a component: "tip.position.z".
struct MeasureWords {
    std::string history, quantity, component;
};

MeasureWords split(const std::string& text) {
    MeasureWords words;
    const std::size_t first = text.find('.');
    words.history = text.substr(0, first);
    if (first == std::string::npos) return words;
    const std::size_t second = text.find('.', first + 1);
    words.quantity = text.substr(first + 1, second == std::string::npos ? second : second - first - 1);
    if (second != std::string::npos) words.component = text.substr(second + 1);
    return words;
}

class SignalBuilder {
  public:
    SignalBuilder(const SignalTable& given,
                  const std::vector<HistoryRequest>& histories,
                  const BuildContext& context)
        : given_(given), histories_(histories), context_(context) {}

    SignalPlan build() const {
        SignalPlan plan;
        plan.name = given_.name;
        plan.input = context_.deck.inputs.at(given_.name);
        if (given_.measure) plan.measure = find_measure();
        if (given_.value) plan.value = given_.value->function;
        plan.filter = given_.filter.value_or(0.0);
        plan.is_rate = given_.rate.value_or(false);
        if (given_.pid) plan.pid = {given_.pid->proportional, given_.pid->integral, given_.pid->derivative};
        plan.is_continuous = given_.continuous.value_or(false);
        if (plan.is_continuous && given_.hold)
            context_.add_fault(
                given_, given_.hold, "a continuous signal goes on a straight line to the end of each step");
        plan.lower = given_.lower;
        plan.upper = given_.upper;
        if (plan.lower && plan.upper && !(*plan.lower < *plan.upper))
            context_.add_fault(
                given_, given_.lower, fmt::format("expected less than upper, {:.6g}", *plan.upper));
        if (given_.rate.value_or(false) && given_.pid)
            context_.add_fault(given_, given_.rate, "a controller has `derivative`; expected one of the two");
        return plan;
    }

  private:
    void add(const std::string& message) const { context_.add_fault(given_, given_.measure, message); }

    std::optional<SignalPlan::Measure> find_measure() const {
        const MeasureWords words = split(*given_.measure);
        const auto history = std::ranges::find(histories_, words.history, &HistoryRequest::name);
        if (history == histories_.end()) {
            std::vector<std::string> known;
            for (const HistoryRequest& one : histories_) known.push_back(one.name);
            const std::string nearest = did_you_mean(words.history, known);
            add(fmt::format("no history \"{}\"{}",
                            words.history,
                            !nearest.empty() ? nearest
                            : known.empty()  ? "; the deck has no [[history]]"
                                             : "; the deck has " + plain_list(known)));
            return std::nullopt;
        }
        if (std::ranges::find(history->quantities, words.quantity) == history->quantities.end()) {
            add(fmt::format("history {} has no quantity \"{}\"; it has {}",
                            words.history,
                            words.quantity,
                            plain_list(history->quantities)));
            return std::nullopt;
        }
        const int columns = quantity_of(history->target, words.quantity).columns;
        const std::optional<std::size_t> column = find_column(columns, words.component);
        if (!column) {
            const std::string name = words.history + "." + words.quantity;
            add(columns == 1   ? fmt::format("{} is one number; expected \"{}\"", words.quantity, name)
                : columns == 3 ? fmt::format("expected a component, such as \"{}.x\", y or z", name)
                               : fmt::format("a signal cannot measure {}; expected a number or a vector",
                                             words.quantity));
            return std::nullopt;
        }
        return SignalPlan::Measure{
            static_cast<std::size_t>(history - histories_.begin()), words.quantity, *column};
    }

    static std::optional<std::size_t> find_column(int columns, const std::string& component) {
        if (columns == 1 && component.empty()) return 0;
        constexpr std::string_view letters = "xyz";
        if (columns != 3 || component.size() != 1 || letters.find(component) == std::string_view::npos)
            return std::nullopt;
        return letters.find(component);
    }

    const SignalTable& given_;
    const std::vector<HistoryRequest>& histories_;
    const BuildContext& context_;
};

}  // namespace

const TableSpec& signal_table() {
    using T = SignalTable;
    // clang-format off
    static const TableSpec table = Table<T>("[signal.NAME]",
            "A number that the run sets after each step by what it measures, and that acts in the next step: values given as "
            "f(t) read it by its name, as they read inputs. Results record it in /inputs.")
        .key("measure", &T::measure, "A quantity of a [[history]], and its component: \"tip.position.z\".")
            .also("of from sensor")
        .key("value", &T::value, "Instead: a number, or f(t), which can read other signals and inputs: \"0.3 - height\".")
            .also("error expression")
        .key("filter", &T::filter, "Time constant of a low pass of the first order.").unit("time").above(0)
            .otherwise("none").also("time_constant lag")
        .key("rate", &T::rate, "true: the signal is the rate of change of that.").also("derivative")
        .key("pid", &T::pid, pid_table(), "The signal is the output of a controller, of which that is the error.")
            .also("controller pi pd")
        .key("lower", &T::lower, "The signal is at least this.").otherwise("none").also("min minimum")
        .key("upper", &T::upper, "The signal is at most this.").otherwise("none").also("max maximum")
        .key("hold", &T::hold, "How it goes to its next value. step: at once. linear: on a straight line over the next step.")
            .otherwise("`\"step\"`")
        .key("continuous", &T::continuous, "true: it acts in the step whose end it measures, on a straight line through "
             "the step, as an analogue controller does. false: it acts in the next step.")
            .otherwise("false").also("implicit analog analogue immediate")
        .key("start", &T::start, "What it is at the start, and until the first step of a quasi-static or dynamic stage.")
        .exactly_one_of({"measure", "value"})
        .shown_by(
            "[signal.height]\n"
            "measure = \"tip.position.z\"\n"
            "\n"
            "[signal.pull]\n"
            "value = \"0.3 - height\"\n"
            "pid   = { proportional = 20, integral = 5, derivative = 1 }\n"
            "lower = 0\n");
    // clang-format on
    return table;
}

void plan_signals(BuildContext& context) {
    for (const SignalTable& given : tables_of<SignalTable>(context.deck, signal_table())) {
        const std::shared_ptr<Input>& input = context.deck.inputs.at(given.name);
        const bool is_linear = given.continuous.value_or(false);
        input->plan(TimeFunction(given.start),
                    is_linear ? InputHold::linear : given.hold.value_or(InputHold::step));
        context.model.inputs.push_back(input);
    }
}

std::vector<SignalPlan> build_signals(const std::vector<HistoryRequest>& histories,
                                      const BuildContext& context) {
    std::vector<SignalPlan> signals;
    for (const SignalTable& given : tables_of<SignalTable>(context.deck, signal_table()))
        signals.push_back(SignalBuilder(given, histories, context).build());
    if (signals.empty()) return signals;
    if (std::ranges::none_of(context.stages,
                             [](const StagePlan& stage) { return is_timed(stage.analysis); })) {
        context.notes.push_back(
            "signals stay at their start: they act in quasi-static and dynamic stages, and the deck has "
            "none");
    }
    for (const StagePlan& stage : context.stages) {
        if (has_steps(stage.analysis) || stage.name.empty()) continue;
        context.notes.push_back(fmt::format(
            "stage {}: signals stay as they are, so what they control does not answer", stage.name));
    }
    return signals;
}

}  // namespace gxrod
