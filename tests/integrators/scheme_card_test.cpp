// Cards of schemes and the integrators that they describe.
#include "model/settings/scheme_card.hpp"

#include "integrators/coupled_stages.hpp"
#include "integrators/integrator.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("The card of a scheme agrees with its integrator", "[integrators]") {
    for (std::size_t i = 0; i < scheme_cards.size(); ++i) {
        const SchemeCard& card = scheme_cards[i];
        INFO(card.word);
        CHECK(static_cast<std::size_t>(card.scheme) == i);
        CHECK(&card_of(card.scheme) == &card);
        DynamicSettings settings;
        settings.scheme = card.scheme;
        const std::unique_ptr<Integrator> integrator = make_integrator(settings);
        CHECK(card.is_explicit == integrator->is_explicit());
        CHECK(card.couples_stages == (integrator->coupled() != nullptr));
        CHECK(card.has_paper_tangent == integrator->has_paper_tangent());
        CHECK(card.conserves_energy == integrator->conserves());
        if (card.takes_contact) CHECK(integrator->contact_weight() != 0.0);
        CHECK(card.estimates_errors == (integrator->error_order() > 0));
    }
}
