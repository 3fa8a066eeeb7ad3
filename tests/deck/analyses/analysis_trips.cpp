#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "deck/schema/choices.hpp"

namespace gxrod::test {
namespace {

ResponseSettings response_of(const Problem& p) {
    const auto* response = std::get_if<ResponseSettings>(&p.analysis());
    return response != nullptr ? *response : ResponseSettings{};
}

PathSettings path_of(const Problem& p) {
    const auto* path = std::get_if<PathSettings>(&p.analysis());
    return path != nullptr ? *path : PathSettings{};
}

AdaptiveSettings adaptive_of(const Problem& p) { return dynamic_of(p).adaptive.value_or(AdaptiveSettings{}); }

}  // namespace

// Two stages, whose first is the deck's analysis.
std::string staged(std::string deck) {
    deck = replaced(deck, "[analysis]", "[[stage]]\nname = \"one\"");
    return deck + "\n[[stage]]\nname = \"two\"\nkind = \"static\"\n";
}

std::string shape_deck(const std::string& kind, const std::string& key) {
    const std::string deck = replaced(body_deck, "\"dynamic\"", "\"" + kind + "\"");
    return replaced(replaced(deck, "end_time = 1.0\n", ""), "steps = 10", key);
}

std::vector<RoundTrip> response_trips() {
    const auto with = [](const std::string& keys) {
        return replaced(static_rod_deck, "\"static\"", "\"response\"") + keys;
    };
    const std::string excited =
        "excite = [{ at = \"r.end\", force = [1, 2, 3], moment = [4, 5, 6], phase = 0.5 }]\n"
        "[[history]]\nname = \"tip\"\nat = \"r.end\"\nquantities = [\"displacement\"]\n";
    const auto excites = [](const auto& test) {
        return [test](const Problem& p) {
            const std::vector<Excitation> found = response_of(p).excitation;
            return found.size() == 1 && test(found[0]);
        };
    };
    std::vector<RoundTrip> trips{{"analysis.excite.at",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.node == 10; })},
                                 {"analysis.excite.force",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.force == Vec3(1, 2, 3); })},
                                 {"analysis.excite.moment",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.moment == Vec3(4, 5, 6); })},
                                 {"analysis.excite.phase",
                                  with("omega = { values = [1] }\n" + excited),
                                  excites([](const Excitation& one) { return one.phase == 0.5; })}};
    for (const std::string name : {"omega", "frequency"}) {
        const double unit = name == "omega" ? 1.0 : 2.0 * M_PI;
        const auto sweeps = [&](const std::string& keys, std::vector<double> expected) {
            for (double& value : expected) value *= unit;
            return std::pair{with(name + " = { " + keys + " }\n" + excited), [expected](const Problem& p) {
                                 const std::vector<double> found = response_of(p).omegas;
                                 bool is_same = found.size() == expected.size();
                                 for (std::size_t i = 0; is_same && i < found.size(); ++i)
                                     is_same = std::abs(found[i] - expected[i]) < 1e-12 * expected[i];
                                 return is_same;
                             }};
        };
        const auto linear = sweeps("from = 1, to = 3, count = 3", {1, 2, 3});
        const auto ratios = sweeps("from = 1, to = 4, count = 3, spacing = \"log\"", {1, 2, 4});
        const auto listed = sweeps("values = [2, 5]", {2, 5});
        for (const char* key : {"from", "to", "count"})
            trips.push_back({"analysis." + name + "." + key, linear.first, linear.second});
        trips.push_back({"analysis." + name + ".spacing", ratios.first, ratios.second});
        trips.push_back({"analysis." + name + ".values", listed.first, listed.second});
    }
    return trips;
}

std::vector<RoundTrip> sweep_trips() {
    const auto with = [](const std::string& keys) {
        return replaced(static_rod_deck, "\"static\"", "\"eigenvalues\"") +
               "sweep = { key = \"section.s.stiffness.EA\", " + keys + " }\n";
    };
    const auto sweeps = [](const auto& test) {
        return [test](const Problem& p) {
            const auto* settings = std::get_if<EigenvalueSettings>(&p.stages[0].analysis);
            return settings != nullptr && settings->sweep && test(*settings->sweep);
        };
    };
    const auto has = [&](std::vector<double> expected) {
        return sweeps([expected](const EigenvalueSweep& sweep) {
            bool is_same = sweep.values.size() == expected.size();
            for (std::size_t i = 0; is_same && i < expected.size(); ++i)
                is_same = std::abs(sweep.values[i] - expected[i]) < 1e-12 * expected[i];
            return is_same;
        });
    };
    return {
        {"analysis.sweep.key", with("values = [1]"), sweeps([](const EigenvalueSweep& sweep) {
             return sweep.key == "section.s.stiffness.EA";
         })},
        {"analysis.sweep.from", with("from = 3, to = 1, count = 3"), has({3, 2, 1})},
        {"analysis.sweep.to", with("from = 1, to = 21"), has({1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                                                              12, 13, 14, 15, 16, 17, 18, 19, 20, 21})},
        {"analysis.sweep.count", with("from = 1, to = 3, count = 2"), has({1, 3})},
        {"analysis.sweep.spacing", with("from = 1, to = 4, count = 3, spacing = \"log\""), has({1, 2, 4})},
        {"analysis.sweep.values", with("values = [5, 2]"), has({5, 2})},
        {"analysis.sweep.onset",
         with("values = [1], onset = \"off\""),
         sweeps([](const EigenvalueSweep& sweep) { return !sweep.finds_onset; })},
        {"analysis.sweep.shapes",
         with("values = [1], shapes = true"),
         sweeps([](const EigenvalueSweep& sweep) { return sweep.keeps_shapes; })}};
}

std::vector<RoundTrip> analysis_trips() {
    const std::string shaped =
        replaced(static_rod_deck,
                 "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }\n"
                 "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }\n",
                 "shape = { circle = { radius = 0.02 } }\nmaterial = { E = 2e11, nu = 0.3 }\n");
    const std::string strong = replaced(shaped, "material = { E = 2e11, nu = 0.3 }", "material = \"ply\"") +
                               "[material.ply]\nE = 2e11\nnu = 0.3\nstrength = { Xt = 2, Xc = 1, Yt = 2, Yc "
                               "= 1, S12 = 1, S23 = 1 }\n";
    return {
        {"analysis.kind",
         static_rod_deck,
         [](const Problem& p) { return std::holds_alternative<StaticSettings>(p.analysis()); }},
        {"analysis.end_time",
         replaced(body_deck, "end_time = 1.0", "end_time = 2.5"),
         [](const Problem& p) { return dynamic_of(p).end_time == 2.5; }},
        {"analysis.time_step",
         replaced(body_deck, "steps = 10", "time_step = 0.125"),
         [](const Problem& p) { return dynamic_of(p).steps == 8; }},
        {"analysis.steps",
         replaced(body_deck, "steps = 10", "steps = 123"),
         [](const Problem& p) { return dynamic_of(p).steps == 123; }},
        {"analysis.accuracy",
         replaced(body_deck, "steps = 10", "accuracy = 0.02"),
         [](const Problem& p) { return adaptive_of(p).tolerance == 0.01 * 0.02; }},
        {"analysis.integrator",
         body_deck + "integrator = \"sdirk-4\"",
         [](const Problem& p) { return dynamic_of(p).scheme == Scheme::sdirk_4; }},
        {"analysis.beta",
         body_deck + "beta = 0.3",
         [](const Problem& p) { return dynamic_of(p).beta == 0.3; }},
        {"analysis.gamma",
         body_deck + "gamma = 0.6",
         [](const Problem& p) { return dynamic_of(p).gamma == 0.6; }},
        {"analysis.spectral_radius",
         body_deck + "integrator = \"generalized-alpha\"\nspectral_radius = 0.3",
         [](const Problem& p) { return dynamic_of(p).spectral_radius == 0.3; }},
        {"analysis.start",
         body_deck + "start = \"project\"",
         [](const Problem& p) { return dynamic_of(p).projects_start; }},
        {"analysis.adaptive.tolerance",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { tolerance = 1e-5 }",
         [](const Problem& p) { return adaptive_of(p).tolerance == 1e-5; }},
        {"analysis.adaptive.min_step",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { min_step = 1e-5 }",
         [](const Problem& p) { return adaptive_of(p).min_step == 1e-5; }},
        {"analysis.adaptive.max_step",
         body_deck + "integrator = \"sdirk-4\"\nadaptive = { max_step = 0.2 }",
         [](const Problem& p) { return adaptive_of(p).max_step == 0.2; }},
        {"analysis.newton.tolerance",
         body_deck + "newton = { tolerance = 1e-5 }",
         [](const Problem& p) { return dynamic_of(p).newton.tolerance == 1e-5; }},
        {"analysis.newton.max_iterations",
         body_deck + "newton = { max_iterations = 7 }",
         [](const Problem& p) { return dynamic_of(p).newton.max_iterations == 7; }},
        {"analysis.newton.tangent",
         body_deck + "newton = { tangent = \"paper\" }",
         [](const Problem& p) { return dynamic_of(p).newton.tangent == TangentKind::paper; }},
        {"analysis.count",
         shape_deck("buckling", "count = 7"),
         [](const Problem& p) { return std::get<BucklingSettings>(p.analysis()).count == 7; }},
        {"analysis.below",
         shape_deck("modes", "below = 7"),
         [](const Problem& p) { return std::get<ModesSettings>(p.analysis()).below == 7.0; }},
        {"analysis.linearization",
         shape_deck("modes", "linearization = \"loading\""),
         [](const Problem& p) {
             return std::get<ModesSettings>(p.analysis()).linearization == Linearization::loading;
         }},
        {"analysis.linear_solver",
         body_deck + "linear_solver = \"klu\"",
         [](const Problem& p) { return dynamic_of(p).linear_solver == LinearSolverKind::klu; }},
        {"output.every",
         body_deck + "[output]\nevery = 5",
         [](const Problem& p) { return p.output.every == 5; }},
        {"output.interval",
         body_deck + "[output]\ninterval = 0.05",
         [](const Problem& p) { return p.output.interval == 0.05; }},
        {"output.times",
         body_deck + "[output]\ntimes = [0.25, \"1/3\"]",
         [](const Problem& p) {
             return p.output.times == std::vector{0.25, 1.0 / 3.0};
         }},
        {"output.history_interval",
         body_deck + "[output]\nhistory_interval = 0.05",
         [](const Problem& p) { return p.output.history_interval == 0.05; }},
        {"output.compression",
         body_deck + "[output]\ncompression = \"deflate\"",
         [](const Problem& p) { return p.output.compression == Compression::deflate; }},
        {"output.stresses",
         strong + "[output]\nstresses = \"hashin\"",
         [](const Problem& p) { return p.output.stresses == "hashin"; }},
        {"output.line_ends",
         shaped + "[output]\nline_ends = \"r\"",
         [](const Problem& p) {
             return p.output.histories.size() == 2 && p.output.histories[1].at == "r.end";
         }},
        {"history.point",
         shaped + "[[history]]\nname = \"n\"\nat = \"r.end\"\npoint = [0.01, -0.02]\nquantities = \"stress\"",
         [](const Problem& p) {
             return p.output.histories[0].section_point == Eigen::Vector2d(0.01, -0.02);
         }},
        {"history.criterion",
         strong +
             "[[history]]\nname = \"n\"\nat = \"r.end\"\ncriterion = \"tsai-wu\"\nquantities = \"stress\"",
         [](const Problem& p) { return p.output.histories[0].criterion == "tsai-wu"; }},
        {"history.name",
         with_history("name = \"tip-1\""),
         [](const Problem& p) { return p.output.histories[0].name == "tip-1"; }},
        {"history.at",
         with_history("at = \"r@0.3\""),
         [](const Problem& p) {
             return p.output.histories[0].at == "r@0.3" && node_of(p.output.histories[0].target) == 3;
         }},
        {"history.relative_to",
         with_history("relative_to = \"r.start\""),
         [](const Problem& p) {
             return p.output.histories[0].relative_to == "r.start" &&
                    p.output.histories[0].relative_node == 0;
         }},
        {"history.quantities", with_history("quantities = [\"strain\", \"velocity\"]"), [](const Problem& p) {
             return p.output.histories[0].quantities == std::vector<std::string>{"strain", "velocity"};
         }}};
}

std::vector<RoundTrip> path_trips() {
    const auto with = [](const std::string& until, const std::string& more = "") {
        return replaced(static_rod_deck, "\"static\"", "\"path\"\nuntil = { " + until + " }\n" + more);
    };
    const auto is_target = [](const Problem& p, int node, int component, const std::vector<double>& values) {
        const std::vector<PathTarget> targets = path_of(p).at;
        return targets.size() == 1 && targets[0].node == node && targets[0].component == component &&
               targets[0].values == values;
    };
    const std::string at = "at = [{ of = \"r.end\", displacement = \"y\", values = [\"1/2\", 3] }]";
    const auto is_control = [](int node, int component, std::optional<double> to) {
        return [=](const Problem& p) {
            const std::optional<PathControl> control = path_of(p).control;
            return control && control->node == node && control->component == component && control->to == to;
        };
    };
    const std::string control = "control = { of = \"r.end\", displacement = \"y\", to = -3 }";
    const std::string turned = "control = { of = \"r.end\", rotation = \"z\" }";
    return {
        {"analysis.control.of", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.displacement", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.to", with("t = 1", control), is_control(10, 1, -3.0)},
        {"analysis.control.rotation", with("t = 1", turned), is_control(10, 5, std::nullopt)},
        {"analysis.until.t",
         with("t = [-1, 2]"),
         [](const Problem& p) { return path_of(p).least_load == -1.0 && path_of(p).greatest_load == 2.0; }},
        {"analysis.until.arc",
         with("arc = 2.5"),
         [](const Problem& p) { return path_of(p).arc == 2.5 && !path_of(p).steps; }},
        {"analysis.until.steps",
         with("steps = 25"),
         [](const Problem& p) { return path_of(p).steps == 25 && !path_of(p).points; }},
        {"analysis.until.points",
         with("points = 3"),
         [](const Problem& p) { return path_of(p).points == 3 && !path_of(p).greatest_load; }},
        {"analysis.step",
         with("t = 1", "step = 0.01"),
         [](const Problem& p) { return path_of(p).first_step == 0.01; }},
        {"analysis.max_step",
         with("t = 1", "max_step = 0.07"),
         [](const Problem& p) { return path_of(p).max_step == 0.07; }},
        {"analysis.min_step",
         with("t = 1", "min_step = 1e-4"),
         [](const Problem& p) { return path_of(p).min_step == 1e-4; }},
        {"analysis.at.of",
         with("t = 1", at),
         [=](const Problem& p) {
             return is_target(p, 10, 1, {0.5, 3.0});
         }},
        {"analysis.at.displacement",
         with("t = 1", replaced(at, "\"y\"", "\"z\"")),
         [=](const Problem& p) {
             return is_target(p, 10, 2, {0.5, 3.0});
         }},
        {"analysis.at.values",
         with("t = 1", replaced(at, "[\"1/2\", 3]", "[7]")),
         [=](const Problem& p) { return is_target(p, 10, 1, {7.0}); }},
        {"analysis.at.t",
         with("t = 1", "at = [{ t = [0.25] }]"),
         [=](const Problem& p) { return is_target(p, -1, 0, {0.25}); }},
        {"analysis.critical",
         with("t = 1", "critical = \"report\""),
         [](const Problem& p) { return path_of(p).critical == CriticalSearch::report; }},
        {"analysis.branches", with("t = 1", "branches = 2"), [](const Problem& p) {
             return path_of(p).branches == 2;
         }}};
}

std::vector<RoundTrip> stage_trips() {
    return {{"stage.name", staged(static_rod_deck), [](const Problem& p) {
                 return p.stages.size() == 2 && p.stages[0].name == "one";
             }}};
}

// A limit point that is followed takes a path before.
std::vector<RoundTrip> follow_trips() {
    const std::string path = "kind = \"path\"\nuntil = { t = 1, points = 1 }\n";
    const std::string deck = replaced(static_rod_deck, "[analysis]\nkind = \"static\"\n", "") +
                             "[[stage]]\nname = \"one\"\n" + path + "[[stage]]\nname = \"two\"\n" + path +
                             "follow = \"limit\"\n[[load]]\nat = \"r.end\"\nforce = [1, 0, 0]\n"
                             "relative_to = \"limit\"\n";
    const auto follows = [](const Problem& p) { return p.stages.size() == 2 && follows_limits(p.stages); };
    return {{"analysis.follow", deck, follows},
            {"stage.follow", deck, follows},
            {"load.relative_to", deck, follows}};
}

}  // namespace gxrod::test
