#include "deck/drives/build_inputs.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

struct InputKeys : TableHead {
    std::optional<CheckedTimeFunction> value;
    std::optional<InputHold> hold;
};

}  // namespace

const TableSpec& input_table() {
    using T = InputKeys;
    // clang-format off
    static const TableSpec table = Table<T>("[input.NAME]",
            "A number that whoever drives the run can change while it goes on: values given as f(t) read it by its "
            "name, as in \"0.1*NAME\". Results record it in /inputs.")
        .key("value", &T::value,
             "What it is until it is set: a number, or f(t), so also the rows of a file, through a function.")
            .otherwise("0")
        .key("hold", &T::hold, "How it goes from one value to the next. step: at once. linear: on a straight line "
             "over the time that is advanced next.")
            .otherwise("`\"step\"`")
        .shown_by(
            "[input.tendon]\n"
            "value = 0\n"
            "hold = \"linear\"\n");
    // clang-format on
    return table;
}

void build_inputs(BuildContext& context) {
    for (const InputKeys& given : tables_of<InputKeys>(context.deck, input_table())) {
        const std::shared_ptr<Input>& input = context.deck.inputs.at(given.name);
        input->plan(given.value ? given.value->function : TimeFunction(),
                    given.hold.value_or(InputHold::step));
        context.model.inputs.push_back(input);
    }
}

}  // namespace gxrod
