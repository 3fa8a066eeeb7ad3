#include "deck/choices.hpp"
#include "deck/schema_tables.hpp"

// [[load]], [[support]], [analysis], [output] and [[history]].
namespace gxrod {
namespace {

std::vector<std::string> fix_words() {
    std::vector<std::string> words(component_names.begin(), component_names.end());
    words.insert(words.end(), {"all", "position", "rotation"});
    return words;
}

Condition for_schemes(const std::vector<Scheme>& schemes) {
    Condition condition{"integrator", {}};
    for (const Scheme scheme : schemes) condition.words.push_back(word_of(scheme_choices, scheme));
    return condition;
}

const TableSpec& newton_table() {
    static const TableSpec table{
        .path = "analysis.newton",
        .heading = "newton = { … }",
        .sentence = "",
        .keys = {
            {.name = "tolerance",
             .type = ValueType::number,
             .dimension = "1",
             .range = positive,
             .default_value = NewtonSettings{}.tolerance,
             .sentence = "Of the residual, relative to the largest force and moment at any node."},
            {.name = "max_iterations",
             .type = ValueType::integer,
             .range = {.lower = 1, .upper = 1'000'000},
             .default_value = static_cast<long>(NewtonSettings{}.max_iterations),
             .sentence = "Of one equilibrium, before the step is cut."},
            {.name = "tangent",
             .type = ValueType::choice,
             .default_value = word_of(tangent_choices, NewtonSettings{}.tangent),
             .sentence = "consistent: the exact derivative. paper: Rubin (2007), (5.6), for decks of bodies "
                         "alone with newmark-simplified. difference: central differences of the residual.",
             .choices = words_of(tangent_choices)}}};
    return table;
}

std::vector<KeySpec> scheme_keys() {
    const DynamicSettings defaults;
    const Condition newmark = for_schemes({Scheme::newmark_simplified, Scheme::newmark_ibrahimbegovic});
    return {{.name = "integrator",
             .type = ValueType::choice,
             .default_value = word_of(scheme_choices, defaults.scheme),
             .sentence = "How time advances.",
             .choices = words_of(scheme_choices)},
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
             .only_for = for_schemes({Scheme::generalized_alpha})},
            {.name = "newton",
             .type = ValueType::table,
             .sentence = "How equilibrium is found.",
             .only_for = for_schemes({Scheme::newmark_simplified,
                                      Scheme::newmark_ibrahimbegovic,
                                      Scheme::generalized_alpha,
                                      Scheme::sdirk_4}),
             .table = &newton_table()},
            {.name = "linear_solver",
             .type = ValueType::choice,
             .default_value = word_of(linear_solver_choices, defaults.linear_solver),
             .sentence = "auto chooses; klu is a sparse LU factorisation.",
             .choices = words_of(linear_solver_choices)}};
}

std::vector<KeySpec> analysis_keys() {
    std::vector<KeySpec> keys{{.name = "kind",
                               .type = ValueType::choice,
                               .presence = Presence::required,
                               .sentence = "dynamic: the motion from t = 0 to end_time.",
                               .choices = {"dynamic"},
                               .remark = "this version has dynamic analyses only"},
                              {.name = "end_time",
                               .type = ValueType::number,
                               .dimension = "time",
                               .range = positive,
                               .presence = Presence::required,
                               .sentence = "Where the analysis ends; it starts at t = 0."},
                              {.name = "time_step",
                               .type = ValueType::number,
                               .dimension = "time",
                               .range = positive,
                               .sentence = "Of equal steps; shortened where it does not divide end_time."},
                              {.name = "steps",
                               .type = ValueType::integer,
                               .range = {.lower = 1, .upper = static_cast<double>(largest_step_count)},
                               .sentence = "How many equal steps."}};
    for (KeySpec& key : scheme_keys()) keys.push_back(std::move(key));
    return keys;
}

}  // namespace

const TableSpec& load_table() {
    static const TableSpec table{
        .path = "load",
        .heading = "[[load]]",
        .sentence = "A force and a moment at a point.",
        .keys = {{.name = "at",
                  .type = ValueType::point,
                  .presence = Presence::required,
                  .sentence = "A point of a rod, or a body."},
                 {.name = "force",
                  .type = ValueType::time_vector,
                  .dimension = "mass·length/time²",
                  .default_text = "[0, 0, 0]",
                  .sentence = "Force."},
                 {.name = "moment",
                  .type = ValueType::time_vector,
                  .dimension = "mass·length²/time²",
                  .default_text = "[0, 0, 0]",
                  .sentence = "Moment."},
                 {.name = "frame",
                  .type = ValueType::choice,
                  .default_value = word_of(frame_choices, NodalLoad{}.frame),
                  .sentence =
                      "spatial: fixed in space, a dead load. follower: global components at t = 0, turned "
                      "with the node. body: components in the section axes of the point named (body axes "
                      "of a body).",
                  .choices = words_of(frame_choices)}},
        .groups = {{GroupRule::at_least_one, {"force", "moment"}}},
        .example =
            "[[load]]\n"
            "at     = \"flyer.start\"\n"
            "force  = [\"pulse(t)/10\", 0, 0]\n"
            "moment = [0, \"-pulse(t)/2\", \"-pulse(t)\"]\n"
            "\n"
            "[[load]]\n"
            "at    = \"flyer@0.25\"\n"
            "force = [0, 0, \"push(t)\"]\n"
            "frame = \"follower\"\n"};
    return table;
}

const TableSpec& support_table() {
    static const TableSpec table{
        .path = "support",
        .heading = "[[support]]",
        .sentence = "Components of a point that do not move, in the global axes.",
        .keys =
            {{.name = "at",
              .type = ValueType::point,
              .presence = Presence::required,
              .sentence = "A point of a rod, or a body."},
             {.name = "fix",
              .type = ValueType::choices,
              .presence = Presence::required,
              .sentence =
                  "position is x y z, rotation is rx ry rz, all is both. Of the rotations none, all three, "
                  "or exactly two: a hinge about the third axis.",
              .choices = fix_words()}},
        .example =
            "[[support]]\n"
            "at  = \"gyroscope\"\n"
            "fix = \"position\"\n"};
    return table;
}

const TableSpec& analysis_table() {
    static const TableSpec table{.path = "analysis",
                                 .heading = "[analysis]",
                                 .sentence = "What is asked of the model.",
                                 .keys = analysis_keys(),
                                 .groups = {{GroupRule::exactly_one, {"time_step", "steps"}}},
                                 .example =
                                     "[analysis]\n"
                                     "kind       = \"dynamic\"\n"
                                     "end_time   = 15.0\n"
                                     "time_step  = 0.01\n"
                                     "integrator = \"generalized-alpha\"\n"
                                     "spectral_radius = 0.8\n"
                                     "newton     = { tolerance = 1e-10, max_iterations = 15 }\n"};
    return table;
}

const TableSpec& output_table() {
    static const TableSpec table{
        .path = "output",
        .heading = "[output]",
        .sentence = "What the results file holds besides histories.",
        .keys = {{.name = "every",
                  .type = ValueType::integer,
                  .range = {.lower = 1, .upper = static_cast<double>(largest_step_count)},
                  .default_value = OutputSettings{}.every,
                  .sentence = "Steps between frames; the first and the last are always "
                              "written."}},
        .example =
            "[output]\n"
            "every = 10\n"};
    return table;
}

const TableSpec& history_table() {
    static const TableSpec table{
        .path = "history",
        .heading = "[[history]]",
        .sentence = "Quantities of a point, recorded at every step.",
        .keys =
            {{.name = "name",
              .type = ValueType::text,
              .presence = Presence::required,
              .sentence = "The name of its group in the results: letters, digits, _ and -, each name once."},
             {.name = "at",
              .type = ValueType::point,
              .presence = Presence::required,
              .sentence = "A point of a rod, or a body."},
             {.name = "quantities",
              .type = ValueType::choices,
              .presence = Presence::required,
              .sentence =
                  "rotation_vector and quaternion are the rotation since t = 0 of a rod's point, the "
                  "attitude of a body; orientation is that of section or body axes for both. force, "
                  "moment (section axes), force_spatial, moment_spatial, strain and curvature are a rod's, "
                  "centre_of_mass is a body's, reactions are a support's.",
              .choices = words_of(quantity_choices)}},
        .example =
            "[[history]]\n"
            "name = \"tip\"\n"
            "at   = \"flyer.end\"\n"
            "quantities = [\"position\", \"velocity\"]\n"};
    return table;
}

}  // namespace gxrod
