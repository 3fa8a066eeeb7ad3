#include "results/histories/quantity.hpp"

#include "deck/schema/choices.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Every quantity of a history has a form, whatever it is of", "[results]") {
    for (const Choice<Quantity>& choice : quantity_choices) {
        const QuantityForm form = quantity_form(choice.value, PointKind::rod);
        CHECK(form.label.name == choice.word);
        CHECK(form.shape.columns > 0);
    }
}
