#include <fmt/format.h>

#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/settings/scheme_card.hpp"
#include "watch/quantities.hpp"

// [analysis], [output] and [[history]].
namespace gxrod {
namespace {

const Condition dynamic_only{"kind", {"dynamic"}};
const Condition timed{"kind", {"dynamic", "quasi-static"}};
const Condition equal_steps{"kind", {"dynamic", "quasi-static", "static", "steady"}};
const Condition with_steps{"kind", {"dynamic", "quasi-static", "static", "path", "steady"}};
const Condition path_only{"kind", {"path"}};
const Condition modes_only{"kind", {"modes"}};

template <class Takes>
std::vector<Condition> for_schemes(const Takes& takes) {
    Condition condition{"integrator", {}};
    for (const SchemeCard& card : scheme_cards) {
        if (takes(card)) condition.words.emplace_back(card.word);
    }
    return {dynamic_only, condition};
}

std::vector<Condition> for_schemes_with(SchemeParameters parameters) {
    return for_schemes([parameters](const SchemeCard& card) { return card.parameters == parameters; });
}

// And for one that the model decides, which is implicit and estimates errors.
template <class Takes>
Condition for_schemes_and_open(const Takes& takes) {
    Condition condition = for_schemes(takes).back();
    condition.words.emplace_back(open_scheme_word);
    return condition;
}

// Newton's method is for equilibria and implicit integrators.
std::vector<Condition> for_equilibria() {
    return {with_steps, for_schemes_and_open([](const SchemeCard& card) { return !card.is_explicit; })};
}

// Schemes that estimate the error of a step.
std::vector<Condition> for_estimated_steps() {
    return {timed, for_schemes_and_open([](const SchemeCard& card) { return card.estimates_errors; })};
}

const TableSpec& newton_table() {
    static const TableSpec table{
        .path = "analysis.newton",
        .heading = "newton = { … }",
        .sentence = "",
        .keys = {{.name = "tolerance",
                  .type = ValueType::number,
                  .dimension = "1",
                  .range = positive,
                  .default_text = "`1e-8`, or less by `adaptive.tolerance`",
                  .sentence = "Of the residual, relative to the largest force and moment at any node."},
                 {.name = "max_iterations",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = 1'000'000},
                  .default_value = static_cast<long>(NewtonSettings{}.max_iterations),
                  .sentence = "Of one equilibrium, before the step is cut. Ten times as many where gxrod "
                              "warns of a rod too stiff compared with what bends, and in statics with "
                              "contact; twice as many in motions with contact."},
                 {.name = "tangent",
                  .type = ValueType::choice,
                  .default_value = word_of(tangent_choices, NewtonSettings{}.tangent),
                  .sentence = "automatic: mixed in statics and on paths, and in dynamics where a rod is 300 "
                              "times as stiff "
                              "in bending or twist about one axis as about another, else consistent; in "
                              "quasi-statics mixed where consistent fails. "
                              "mixed: the resultants in its geometric part are iterated along with the "
                              "motion, which converges in much larger steps. "
                              "consistent: the exact derivative. paper: Rubin (2007), (5.6), for decks of "
                              "bodies alone with newmark-simplified. "
                              "difference: central differences of the residual.",
                  .choices = words_of(tangent_choices)}}};
    return table;
}

const TableSpec& adaptive_table() {
    static const TableSpec table{
        .path = "analysis.adaptive",
        .heading = "adaptive = { … }",
        .sentence = "",
        .keys = {
            {.name = "tolerance",
             .type = ValueType::number,
             .dimension = "1",
             .range = positive,
             .default_value = AdaptiveSettings{}.tolerance,
             .sentence =
                 "Of one step's estimated error: the length of displacements over the model's length, of "
                 "rotations in rad, and of velocities times the step alike, the largest of all nodes."},
            {.name = "min_step",
             .type = ValueType::number,
             .dimension = "time",
             .range = {.lower = 0.0},
             .default_value = AdaptiveSettings{}.min_step,
             .sentence = "A run that needs a shorter step fails."},
            {.name = "max_step",
             .type = ValueType::number,
             .dimension = "time",
             .range = positive,
             .default_text = "none",
             .sentence = "No step is longer."}}};
    return table;
}

std::vector<KeySpec> scheme_keys() {
    const DynamicSettings defaults;
    const std::vector<Condition> newmark = for_schemes_with(SchemeParameters::newmark);
    return {
        {.name = "integrator",
         .type = ValueType::choice,
         .default_value = std::string(card_of(defaults.scheme).word),
         .sentence = "How time advances; with accuracy, radau-5 unless another one is given. auto: by the "
                     "model, see [which scheme](guide/solving.md#which-scheme).",
         .choices = scheme_words(),
         .only_for = {dynamic_only}},
        {.name = "beta",
         .type = ValueType::number,
         .dimension = "1",
         .range = {.lower = 0.0, .at_lower = Bound::open, .upper = 0.5},
         .default_value = defaults.beta,
         .sentence = "Newmark's β.",
         .only_for = newmark},
        {.name = "gamma",
         .type = ValueType::number,
         .dimension = "1",
         .range = {.lower = 0.0, .upper = 1.0},
         .default_value = defaults.gamma,
         .sentence = "Newmark's γ.",
         .only_for = newmark},
        {.name = "spectral_radius",
         .type = ValueType::number,
         .dimension = "1",
         .range = {.lower = 0.0, .upper = 1.0},
         .default_value = defaults.spectral_radius,
         .sentence =
             "At infinite frequency: 1 keeps the amplitude of every frequency, 0 removes the highest.",
         .only_for = for_schemes_with(SchemeParameters::spectral_radius)},
        {.name = "start",
         .type = ValueType::choice,
         .default_value = "given",
         .sentence =
             "Of the velocities at t = 0. given: they must fit the joints. project: those that fit and "
             "are nearest to what is given, by kinetic energy.",
         .choices = {"given", "project"},
         .only_for = {dynamic_only}},
        {.name = "adaptive",
         .type = ValueType::table,
         .sentence =
             "Steps chosen by an estimate of their error; time_step or steps gives the first one; left "
             "out, equal steps.",
         .only_for = for_estimated_steps(),
         .table = &adaptive_table()},
        {.name = "newton",
         .type = ValueType::table,
         .sentence = "How equilibrium is found.",
         .only_for = for_equilibria(),
         .table = &newton_table()},
        {.name = "linear_solver",
         .type = ValueType::choice,
         .default_value = word_of(linear_solver_choices, defaults.linear_solver),
         .sentence =
             "chains: by blocks of the unknowns of nodes, the insides of rods first, then their junctions by "
             "dense fronts. klu: sparse LU, entry by entry. umfpack: LU by dense fronts, which exchanges "
             "equations to find pivots. auto: chains, or, for many rods that touch each other, iterations "
             "for the "
             "forces between them.",
         .choices = words_of(linear_solver_choices),
         .only_for = {with_steps}}};
}

std::vector<KeySpec> analysis_keys() {
    std::vector<KeySpec> keys{
        {.name = "kind",
         .type = ValueType::choice,
         .presence = Presence::required,
         .sentence =
             "dynamic: the motion from t = 0 to end_time. static: equilibria while the "
             "load factor t goes from 0 to 1; loads, gravity and moves whose value has "
             "no t are multiplied by it. path: the same along a path of equilibria, on which t can "
             "turn back at limit points, with the branches that leave it. quasi-static: in time, but so "
             "slowly that inertia does not matter; damping does. modes: vibrations about "
             "the state that the stage before "
             "leaves, or about the reference shape without loads. buckling: the factors on the "
             "loads at which that state gives way, by linear theory. steady: equilibria in a frame "
             "that turns, "
             "see [rotation]. eigenvalues: small motions about the state with damping, loads that "
             "follow and rotation: frequencies, damping ratios, flutter. response: the steady motion "
             "about the "
             "state under forces that swing with each of many frequencies.",
         .choices = {"dynamic",
                     "static",
                     "quasi-static",
                     "path",
                     "steady",
                     "modes",
                     "buckling",
                     "eigenvalues",
                     "response"}},
        {.name = "end_time",
         .type = ValueType::number,
         .dimension = "time",
         .range = positive,
         .presence = Presence::required,
         .sentence = "Where the analysis ends; it starts at t = 0.",
         .only_for = {timed}},
        {.name = "accuracy",
         .type = ValueType::number,
         .dimension = "1",
         .range = {.lower = 0.0, .at_lower = Bound::open, .upper = 0.1},
         .sentence =
             "Instead of a step: about how far places may be off at the end, relative to the model's length, "
             "and rotations in rad. Steps are chosen by their error, by radau-5 unless integrator says "
             "otherwise.",
         .only_for = for_estimated_steps()},
        {.name = "time_step",
         .type = ValueType::number,
         .dimension = "time",
         .range = positive,
         .sentence = "Of equal steps; shortened where it does not divide end_time.",
         .only_for = {timed}},
        {.name = "steps",
         .type = ValueType::integer,
         .range = {.lower = 1, .upper = static_cast<double>(largest_step_count)},
         .default_text = fmt::format("`{}` if static or steady", StaticSettings{}.steps),
         .sentence = "How many equal steps.",
         .only_for = {equal_steps}}};
    for (KeySpec& key : scheme_keys()) keys.push_back(std::move(key));
    for (KeySpec& key : path_keys()) keys.push_back(std::move(key));
    for (KeySpec& key : shape_keys()) keys.push_back(std::move(key));
    for (KeySpec& key : response_keys()) keys.push_back(std::move(key));
    return keys;
}

}  // namespace

const TableSpec& analysis_table() {
    static const TableSpec table{
        .path = "analysis",
        .heading = "[analysis]",
        .sentence = "What is asked of the model.",
        .keys = analysis_keys(),
        .groups = {{.rule = GroupRule::exactly_one,
                    .keys = {"time_step", "steps", "accuracy"},
                    .only_for = {timed}},
                   {.rule = GroupRule::at_most_one, .keys = {"adaptive", "accuracy"}, .only_for = {timed}},
                   {.rule = GroupRule::at_most_one, .keys = {"count", "below"}, .only_for = {modes_only}},
                   {.rule = GroupRule::exactly_one,
                    .keys = {"omega", "frequency"},
                    .only_for = {{"kind", {"response"}}}}},
        .example =
            "[analysis]\n"
            "kind       = \"dynamic\"\n"
            "end_time   = 15.0\n"
            "time_step  = 0.01\n"
            "gamma      = 0.6\n"
            "beta       = 0.3\n"
            "newton     = { tolerance = 1e-10, max_iterations = 15 }\n"};
    return table;
}

const TableSpec& stage_table() {
    static const TableSpec table = [] {
        TableSpec stage = analysis_table();
        stage.path = "stage";
        stage.heading = "[[stage]]";
        stage.sentence =
            "Instead of [analysis]: analyses one after the other, each from the state in which the last one "
            "leaves the model. The keys are those of [analysis], and a name.";
        stage.keys.insert(
            stage.keys.begin(),
            {.name = "name",
             .type = ValueType::text,
             .presence = Presence::required,
             .sentence =
                 "Of the stage, for results and for the loads and supports that it concerns: letters, "
                 "digits, _ and -, each name once."});
        stage.example.clear();
        return stage;
    }();
    return table;
}

const TableSpec& output_table() {
    static const TableSpec table{
        .path = "output",
        .heading = "[output]",
        .sentence = "What the results file holds in addition to histories.",
        .keys = {{.name = "every",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = static_cast<double>(largest_step_count)},
                  .default_text = "what makes about 500 frames at most",
                  .sentence =
                      "Steps between frames; the first and the last are always written. Left out: 1 up to "
                      "500 steps; beyond that the least of 2, 5, 10, 20, 50 … that makes about 500 frames at "
                      "most; with adaptive steps one frame in each 500th part of the time."},
                 {.name = "interval",
                  .type = ValueType::number,
                  .dimension = "time",
                  .range = positive,
                  .sentence =
                      "Time between frames, instead: they come at its multiples in each stage with "
                      "time, and at the ends of stages, wherever steps end. Steps are not cut: within "
                      "them the motion is the scheme's interpolant."},
                 {.name = "times",
                  .type = ValueType::numbers,
                  .dimension = "time",
                  .sentence =
                      "Times of frames, instead, in order: on the axis of the results, on which the "
                      "first stage with time begins at 0. The first and the last frame of the run are "
                      "written too."},
                 {.name = "history_interval",
                  .type = ValueType::number,
                  .dimension = "time",
                  .range = positive,
                  .sentence = "Histories are recorded at its multiples in each stage with time, too, in "
                              "/sampled of the results; in /histories they are at every step."},
                 {.name = "compression",
                  .type = ValueType::choice,
                  .default_value = word_of(compression_choices, OutputSettings{}.compression),
                  .sentence = "Of frames, without loss. deflate halves them and takes some time of writing; "
                              "for models of a thousand nodes and more.",
                  .choices = words_of(compression_choices)}},
        .groups = {{GroupRule::at_most_one, {"every", "interval", "times"}}},
        .example =
            "[output]\n"
            "every = 10\n"
            "compression = \"deflate\"\n"};
    return table;
}

const TableSpec& history_table() {
    static const TableSpec table{
        .path = "history",
        .heading = "[[history]]",
        .sentence =
            "Quantities of a point, a spring, a bushing, a joint, a gear, a tendon, an obstacle or a rod "
            "that "
            "touches something, recorded at every "
            "step, and at times of their own if output.history_interval is given.",
        .keys =
            {{.name = "name",
              .type = ValueType::text,
              .presence = Presence::required,
              .sentence = "The name of its group in the results: letters, digits, _ and -, each name once."},
             {.name = "at",
              .type = ValueType::point,
              .presence = Presence::required,
              .sentence =
                  "A point of a rod, between nodes too, a body, a spring, a bushing, a joint, a gear, "
                  "a tendon or an obstacle; a rod, for what touches it."},
             {.name = "with",
              .type = ValueType::text,
              .default_text = "all that touches",
              .sentence = "Of a rod: the obstacle or the rod (itself, too) whose contact alone counts."},
             {.name = "relative_to",
              .type = ValueType::point,
              .default_text = "the global axes and the origin",
              .sentence = "A point whose section axes (body axes of a body) the components are in, and from "
                          "which positions count; it moves. For position, displacement, velocity, "
                          "acceleration, centre_of_mass and rotations."},
             {.name = "axes",
              .type = ValueType::choice,
              .default_value = section_axes_word,
              .sentence = "Those of relative_to that the components are in. untwisted: its section axes "
                          "turned back by the twist there, so y_axis carried along the rod.",
              .choices = {section_axes_word, untwisted_axes_word},
              .only_with = "relative_to"},
             {.name = "about",
              .type = ValueType::vector,
              .dimension = "length",
              .default_text = "the point itself",
              .sentence = "The point, fixed in space, about which reaction_moment is: the moment of the "
                          "support and that of its force."},
             {.name = "quantities",
              .type = ValueType::choices,
              .presence = Presence::required,
              .sentence =
                  "rotation_vector and quaternion are the rotation since t = 0 of a rod's point, the "
                  "attitude of a body; orientation is that of section or body axes for both. force, "
                  "moment (section axes), force_spatial, moment_spatial, strain and curvature are a rod's, "
                  "centre_of_mass is a body's, reactions are a support's. elongation (length less that of "
                  "the free spring) and axial_force (tension positive, with damping) are a spring's. Of a "
                  "bushing displacement and rotation_vector are those of B against A, force and moment what "
                  "the bushing resists them with, all in its axes; force_spatial and moment_spatial are "
                  "global. A joint has angle, slide and their rates since t = 0, force and moment (what A "
                  "exerts on B, moment about the joint, global), force_a and moment_a (in the joint's axes "
                  "on A, along its axis first), drive (moment or force of its motor, or its key drive), "
                  "friction and gap. A "
                  "gear has drive (moment or force on its second joint) and gap. effective_tension, "
                  "wall_tension, water_velocity and bed_force are a rod's; wet_fraction and fluid_force are "
                  "those of what "
                  "has a key fluid, forces per length of a rod and whole of a body.",
              .choices = list_quantity_words()}},
        .example =
            "[[history]]\n"
            "name = \"tip\"\n"
            "at   = \"flyer.end\"\n"
            "quantities = [\"position\", \"velocity\"]\n"};
    return table;
}

}  // namespace gxrod
