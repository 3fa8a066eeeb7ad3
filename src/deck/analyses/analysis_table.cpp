#include "deck/analyses/analysis_table.hpp"

#include <fmt/format.h>

#include "deck/schema/schema_tables.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

const Condition timed{"kind", {"dynamic", "quasi-static"}};

// Motions whose scheme has this, and those whose scheme the model decides, which is implicit and estimates
// errors.
template <class Takes>
Condition for_schemes(const Takes& takes, bool takes_open) {
    Condition condition{"integrator", {}};
    for (const SchemeCard& card : scheme_cards) {
        if (takes(card)) condition.words.emplace_back(card.word);
    }
    if (takes_open) condition.words.emplace_back(open_scheme_word);
    return condition;
}

Condition for_schemes_with(SchemeParameters parameters) {
    return for_schemes([parameters](const SchemeCard& card) { return card.parameters == parameters; }, false);
}

const TableSpec& newton_table() {
    using T = NewtonTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.newton", "")
        .key("tolerance", &T::tolerance, "Of the residual, relative to the largest force and moment at any node.")
            .unit("1").above(0).otherwise("`1e-8`, or less by `adaptive.tolerance`").also("tol rtol eps convergence")
        .key("max_iterations", &T::max_iterations,
             "Of one equilibrium, before the step is cut. Ten times as many where gxrod warns of a rod too stiff "
             "compared with what bends, and in statics with contact; twice as many in motions with contact.")
            .between(1, 1'000'000).also("maxiter max_iter iterations")
        .key("tangent", &T::tangent,
             "automatic: mixed in statics and on paths, and in dynamics where a rod is 300 times as stiff in bending "
             "or twist about one axis as about another, else consistent; in quasi-statics mixed where consistent "
             "fails. mixed: the resultants in its geometric part are iterated along with the motion, which converges "
             "in much larger steps. consistent: the exact derivative. kept: the consistent one, in motions, computed again "
             "only where the residual falls too slowly, so that steps cost less; errors stay below the tolerance "
             "but are no longer far below it. paper: Rubin (2007), (5.6), for decks of bodies "
             "alone with newmark-simplified. difference: central differences of the residual.")
            .also("jacobian stiffness");
    // clang-format on
    return table;
}

const TableSpec& adaptive_table() {
    using T = AdaptiveTable;
    // clang-format off
    static const TableSpec table = Table<T>("analysis.adaptive", "")
        .key("tolerance", &T::tolerance,
             "Of one step's estimated error: the length of displacements over the model's length, of rotations in "
             "rad, and of velocities times the step alike, the largest of all nodes.")
            .unit("1").above(0).also("tol rtol error")
        .key("min_step", &T::min_step, "A run that needs a shorter step fails.")
            .unit("time").at_least(0).also("dt_min min_dt minimum_step")
        .key("max_step", &T::max_step, "No step is longer.")
            .unit("time").above(0).otherwise("none").also("dt_max max_dt maximum_step");
    // clang-format on
    return table;
}

// The steps, and how each is found.
void add_step_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    const Condition estimated =
        for_schemes([](const SchemeCard& card) { return card.estimates_errors; }, true);
    // clang-format off
    table
        .key("end_time", &T::end_time, "Where the analysis ends; it starts at t = 0.")
            .unit("time").above(0).required().only_for({timed}).may_change()
            .also("duration t_end tend final_time total_time end stop_time t time")
        .key("accuracy", &T::accuracy,
             "Instead of a step: about how far places may be off at the end, relative to the model's length, and "
             "rotations in rad. Steps are chosen by their error, by radau-5 unless integrator says otherwise.")
            .unit("1").above(0).at_most(0.1).only_for({timed, estimated})
        .key("time_step", &T::time_step, "Of equal steps; shortened where it does not divide end_time.")
            .unit("time").above(0).only_for({timed}).may_change().also("dt step_size delta_t h")
        .key("steps", &T::steps, "How many equal steps.")
            .between(1, static_cast<double>(largest_step_count))
            .otherwise(fmt::format("`{}` if static or steady", StaticSettings{}.steps))
            .only_for({{"kind", {"dynamic", "quasi-static", "static", "steady"}}}).may_change()
            .also("n_steps num_steps nsteps number_of_steps load_steps increments");
    // clang-format on
}

void add_scheme_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    const Condition dynamic_only{"kind", {"dynamic"}};
    const Condition newmark = for_schemes_with(SchemeParameters::newmark);
    // clang-format off
    table
        .key("integrator", &T::integrator,
             "How time advances; with accuracy, radau-5 unless another one is given. auto: by the model, see [which "
             "scheme](guide/solving.md#which-scheme).")
            .only_for({dynamic_only}).also("method scheme time_integrator integration solver")
        .key("beta", &T::beta, "Newmark's β.")
            .unit("1").above(0).at_most(0.5).only_for({dynamic_only, newmark})
        .key("gamma", &T::gamma, "Newmark's γ.")
            .unit("1").between(0, 1).only_for({dynamic_only, newmark})
        .key("spectral_radius", &T::spectral_radius,
             "At infinite frequency: 1 keeps the amplitude of every frequency, 0 removes the highest.")
            .unit("1").between(0, 1).only_for({dynamic_only, for_schemes_with(SchemeParameters::spectral_radius)})
            .also("rho_inf rho_infinity")
        .key("start", &T::start,
             "Of the velocities at t = 0. given: they must fit the joints. project: those that fit and are nearest to "
             "what is given, by kinetic energy.")
            .only_for({dynamic_only}).also("initial_velocities consistent project");
    // clang-format on
}

void add_solver_keys(Table<AnalysisTable>& table) {
    using T = AnalysisTable;
    const Condition with_steps{"kind", {"dynamic", "quasi-static", "static", "path", "steady"}};
    const Condition estimated =
        for_schemes([](const SchemeCard& card) { return card.estimates_errors; }, true);
    const Condition implicit = for_schemes([](const SchemeCard& card) { return !card.is_explicit; }, true);
    // clang-format off
    table
        .key("adaptive", &T::adaptive, adaptive_table(),
             "Steps chosen by an estimate of their error; time_step or steps gives the first one; left out, equal "
             "steps.")
            .only_for({timed, estimated}).may_change()
        .key("newton", &T::newton, newton_table(), "How equilibrium is found.")
            .only_for({with_steps, implicit}).may_change()
            .has_as("newton.tolerance", "tol tolerance rtol convergence")
            .has_as("newton.max_iterations", "maxiter max_iter max_iterations iterations")
        .key("linear_solver", &T::linear_solver,
             "chains: by blocks of the unknowns of nodes, the insides of rods first, then their junctions by dense "
             "fronts. klu: sparse LU, entry by entry. umfpack: LU by dense fronts, which exchanges equations to find "
             "pivots. auto: chains, or, for many rods that touch each other, iterations for the forces between them.")
            .only_for({with_steps}).may_change().also("sparse_solver");
    // clang-format on
}

// Adds the keys that [analysis] and [[stage]] have.
Table<AnalysisTable> add_analysis_keys(Table<AnalysisTable> table) {
    // clang-format off
    table.key("kind", &AnalysisTable::kind,
             "dynamic: the motion from t = 0 to end_time. static: equilibria while the load factor t goes from 0 to "
             "1; loads, gravity and moves whose value has no t are multiplied by it. path: the same along a path of "
             "equilibria, on which t can turn back at limit points, with the branches that leave it. quasi-static: in "
             "time, but so slowly that inertia does not matter; damping does. modes: vibrations about the state that "
             "the stage before leaves, or about the reference shape without loads. buckling: the factors on the loads "
             "at which that state gives way, by linear theory. steady: equilibria in a frame that turns, see "
             "[rotation]. eigenvalues: small motions about the state with damping, loads that follow and rotation: "
             "frequencies, damping ratios, flutter. response: the steady motion about the state under forces that "
             "swing with each of many frequencies.")
            .required().also("type mode analysis_type");
    // clang-format on
    add_step_keys(table);
    add_scheme_keys(table);
    add_solver_keys(table);
    add_path_keys(table);
    add_shape_keys(table);
    add_response_keys(table);
    return table.not_here("start_time", "an analysis begins at t = 0")
        .exactly_one_of({"time_step", "steps", "accuracy"}, {timed})
        .at_most_one_of({"adaptive", "accuracy"}, {timed})
        .at_most_one_of({"count", "below"}, {{"kind", {"modes"}}})
        .exactly_one_of({"omega", "frequency", "gravity"}, {{"kind", {"response"}}})
        .exactly_one_of({"excite", "gravity"}, {{"kind", {"response"}}});
}

}  // namespace

const TableSpec& analysis_table() {
    static const TableSpec table = add_analysis_keys({"[analysis]", "What is asked of the model."})
                                       .shown_by(
                                           "[analysis]\n"
                                           "kind       = \"dynamic\"\n"
                                           "end_time   = 15.0\n"
                                           "time_step  = 0.01\n"
                                           "gamma      = 0.6\n"
                                           "beta       = 0.3\n"
                                           "newton     = { tolerance = 1e-10, max_iterations = 15 }\n");
    return table;
}

const TableSpec& stage_table() {
    using T = AnalysisTable;
    // clang-format off
    static const TableSpec table = add_analysis_keys(Table<T>("[[stage]]",
            "Instead of [analysis]: analyses one after the other, each from the state in which the last one leaves "
            "the model. The keys are those of [analysis], and a name.")
        .key("name", &T::stage_name,
             "Of the stage, for results and for the loads and supports that it concerns: letters, digits, _ and -, "
             "each name once.")
            .required());
    // clang-format on
    return table;
}

std::vector<std::reference_wrapper<const AnalysisTable>> list_analyses(const CheckedTable& deck) {
    const bool has_stages = !deck.tables("stage").empty();
    return tables_of<AnalysisTable>(deck, has_stages ? stage_table() : analysis_table());
}

}  // namespace gxrod
