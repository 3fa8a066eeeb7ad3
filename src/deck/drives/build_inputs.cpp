#include "deck/drives/build_inputs.hpp"

#include "deck/schema/choices.hpp"

namespace gxrod {

void build_inputs(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("input")) {
        const std::shared_ptr<Input>& input = context.deck.inputs.at(table.name);
        const bool has_value = table.gives("value");
        const bool has_hold = table.gives("hold");
        input->plan(
            has_value ? table.get<CheckedTimeFunction>("value").function : TimeFunction(),
            has_hold ? value_of(input_hold_choices, table.get<std::string>("hold")) : InputHold::step);
        context.model.inputs.push_back(input);
    }
}

}  // namespace gxrod
