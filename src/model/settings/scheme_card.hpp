#pragma once

#include <array>
#include <string_view>

#include "model/settings/settings.hpp"

// The card of a time integrator: its word in decks and the properties by which schema, checks, advice and
// summaries treat it. They ask the card, and do not compare schemes.
namespace gxrod {

enum class SchemeParameters {
    none,
    newmark,         // beta and gamma
    spectral_radius  // at infinite frequency
};

struct SchemeCard {
    Scheme scheme;
    std::string_view word;
    double order;  // of Newmark's schemes that with gamma = 1/2
    // The steps in a period with which the scheme errs by some hundredths of a rad (docs/theory/newmark.md).
    double steps_in_period = 20.0;
    SchemeParameters parameters = SchemeParameters::none;
    bool is_explicit = false;
    bool estimates_errors = true;    // so that it can choose its steps
    bool couples_stages = false;     // finds the stages of a step together, with a tangent of their own
    bool has_paper_tangent = false;  // Rubin (2007), (5.6)
    bool takes_contact = false;      // takes the impulses of contact
    bool resolves_contact = false;   // contact acts at its stages like any other force
    bool conserves_energy = false;   // by scaling the rates at the end of each step
    // Advice for steps that do not resolve the highest frequencies, and for steps that had to be cut.
    std::string_view if_unresolved = {};
    std::string_view if_cut = {};
};

inline constexpr std::string_view damp_if_cut =
    ", or generalized-alpha, which damps what is too fast for the steps";

// In the order of Scheme.
inline constexpr std::array<SchemeCard, 8> scheme_cards{
    {{.scheme = Scheme::newmark_simplified,
      .word = "newmark-simplified",
      .order = 2.0,
      .parameters = SchemeParameters::newmark,
      .has_paper_tangent = true,
      .takes_contact = true,
      .if_cut = damp_if_cut},
     {.scheme = Scheme::newmark_ibrahimbegovic,
      .word = "newmark-ibrahimbegovic",
      .order = 2.0,
      .parameters = SchemeParameters::newmark,
      .takes_contact = true,
      .if_cut = damp_if_cut},
     {.scheme = Scheme::generalized_alpha,
      .word = "generalized-alpha",
      .order = 2.0,
      .parameters = SchemeParameters::spectral_radius,
      .takes_contact = true},
     {.scheme = Scheme::sdirk_4,
      .word = "sdirk-4",
      .order = 4.0,
      .steps_in_period = 8.0,
      .resolves_contact = true,
      .if_unresolved =
          ": if they are excited, reactions and accelerations lose their order and energy may grow; "
          "radau-5 keeps its order"},
     {.scheme = Scheme::radau_5,
      .word = "radau-5",
      .order = 5.0,
      .steps_in_period = 4.0,
      .couples_stages = true,
      .resolves_contact = true},
     {.scheme = Scheme::gauss_4,
      .word = "gauss-4",
      .order = 4.0,
      .steps_in_period = 5.0,
      .estimates_errors = false,
      .couples_stages = true,
      .if_unresolved = " and damps nothing: if they are excited, they ring; radau-5 damps them"},
     {.scheme = Scheme::energy_momentum,
      .word = "energy-momentum",
      .order = 2.0,
      .conserves_energy = true,
      .if_cut = ", or gauss-4 where it turns almost without vibrating"},
     {.scheme = Scheme::runge_kutta_4,
      .word = "runge-kutta-4",
      .order = 4.0,
      .steps_in_period = 8.0,
      .is_explicit = true,
      .estimates_errors = false}}};

constexpr const SchemeCard& card_of(Scheme scheme) { return scheme_cards[static_cast<std::size_t>(scheme)]; }

// The scheme of decks that ask for an accuracy alone, and of those that leave it open until the model is
// known.
inline constexpr Scheme accurate_scheme = Scheme::radau_5;
// The scheme of quasi-statics: its last stage is the equilibrium at the end of the step.
inline constexpr Scheme quasi_static_scheme = Scheme::sdirk_4;

}  // namespace gxrod
