#include "check/model_examination.hpp"
#include "check/findings/buckling_findings.hpp"
#include "check/findings/contact_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "check/findings/bushing_findings.hpp"
#include "check/findings/function_examination.hpp"
#include "check/findings/plane_findings.hpp"
#include "check/findings/stiffness_contrast.hpp"
#include "check/mechanism/mechanism.hpp"
#include "check/motions/free_parts.hpp"
#include "check/motions/stability.hpp"
#include "check/motions/turning_loads.hpp"
#include "check/motions/unconnected_points.hpp"
#include "check/summaries/rod_lines.hpp"
#include "check/surroundings/surroundings_findings.hpp"
#include "model/body_moments.hpp"
#include "model/parts.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/newton_choice.hpp"
#include "model/settings/scheme_card.hpp"
#include "model/settings/scheme_choice.hpp"
#include "model/ties/ties.hpp"
#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

// "move along x, turn about …", or in short if nothing holds the part at all.
std::string list_motions(const Model& model,
                         const ModelPart& part,
                         const std::vector<UnsupportedMotion>& motions) {
    if (motions.size() == 6) return "move and turn in every direction";
    std::vector<std::string> texts;
    for (const UnsupportedMotion& motion : motions)
        texts.push_back(describe_unsupported_motion(model, part, motion));
    std::string text = texts[0];
    for (std::size_t i = 1; i < texts.size(); ++i) {
        text += (i + 1 == texts.size() ? " and " : ", ") + texts[i];
    }
    return text;
}

// Whether something acts on this part.
bool is_loaded(const Model& model, const ModelPart& part) {
    const auto has_node = [&](int node) { return std::ranges::binary_search(part.nodes, node); };
    const auto has_rod = [&](int rod) { return std::ranges::binary_search(part.rods, rod); };
    const auto pushes = [&](const NodalLoad& load) { return has_node(load.node) && load.acts(); };
    const auto pushes_along = [&](const DistributedLoad& load) { return has_rod(load.rod) && load.acts(); };
    const auto is_bent = [&](int rod) {
        return !model.rods[static_cast<std::size_t>(rod)].starts_free_of_stress();
    };
    const auto moves = [&](const Support& support) {
        return has_node(support.node) && support.moved != std::array<bool, 6>{};
    };
    const auto acts_within = [&](const auto& drive) { return has_rod(drive.rod); };
    const auto has_strained_tie = [&] {
        bool has = false;
        for_each_element_list(model, [&](TieKind kind, const auto& ties) {
            const auto strains = [&](int tie) {
                return is_strained(model, ties[static_cast<std::size_t>(tie)]);
            };
            has = has || std::ranges::any_of(part.ties(kind), strains);
        });
        return has;
    };
    return model.rotation || !model.gravity.is_zero() || std::ranges::any_of(model.loads, pushes) ||
           std::ranges::any_of(model.distributed_loads, pushes_along) ||
           std::ranges::any_of(part.rods, is_bent) || std::ranges::any_of(model.supports, moves) ||
           std::ranges::any_of(model.actuations, acts_within) ||
           std::ranges::any_of(model.tendons, acts_within) || has_strained_tie();
}

// Whether a load that depends on the motion acts on this part.
bool has_load_by_motion(const Model& model, const ModelPart& part) {
    const auto acts = [&](const NodalLoad& load) {
        return load.by_motion && std::ranges::binary_search(part.nodes, load.node);
    };
    const auto acts_along = [&](const DistributedLoad& load) {
        return load.by_motion && std::ranges::binary_search(part.rods, load.rod);
    };
    return std::ranges::any_of(model.loads, acts) || std::ranges::any_of(model.distributed_loads, acts_along);
}

// Whether what acts on a part can hold it in spite of these motions, as gravity, tension and rotation hold
// what hangs on an axis: turns, not all of them about the line of a straight rod. Loads that depend on the
// motion can be springs.
bool can_be_held(const Model& model, const ModelPart& part, const std::vector<UnsupportedMotion>& motions) {
    if (has_load_by_motion(model, part)) return true;
    const auto moves_along = [](const UnsupportedMotion& motion) { return motion.rotation.isZero(0.0); };
    const auto twists = [&](const UnsupportedMotion& motion) { return is_twist(model, part, motion); };
    if (!is_loaded(model, part) || std::ranges::any_of(motions, moves_along)) return false;
    return !std::ranges::all_of(motions, twists);
}

// Equilibrium does not say where a part is that can move without being strained, unless what is around holds
// it: as a current does a towed cable, and the surface what floats. Of what contact can hold at the start of
// a run examine_contact says more.
void find_drifting_parts(const Model& model, bool begins_at_rest, std::vector<Finding>& findings) {
    const char* holds = count_element_ties(model) > 0 ? "supports or springs" : "supports";
    for (const auto& [part, motions] : find_free_parts(model)) {
        const bool is_surrounded = !model.surroundings.is_empty();
        const bool can_touch = can_contact_hold(part, model);
        if (can_touch && begins_at_rest && !is_surrounded) continue;
        if (is_surrounded || can_touch) {
            findings.push_back({Severity::note,
                                fmt::format("{} can {}; in statics, {} to hold it where it is in equilibrium",
                                            name_part(part, model),
                                            list_motions(model, part, motions),
                                            is_surrounded ? "water, wind or the ground have"
                                                          : "contact has from the first step on")});
            continue;
        }
        if (can_be_held(model, part, motions)) {
            findings.push_back({Severity::warning,
                                fmt::format("{} can {}; a static analysis needs {} that prevent it, or loads "
                                            "that hold it",
                                            name_part(part, model),
                                            list_motions(model, part, motions),
                                            holds)});
            continue;
        }
        findings.push_back({Severity::error,
                            fmt::format("{} can {}; a static analysis needs {} that prevent it",
                                        name_part(part, model),
                                        list_motions(model, part, motions),
                                        holds)});
    }
}

// "turns or slides at knee and elbow", or that the whole moves.
std::string describe_moving(const FreeMechanism& mechanism, const Model& model) {
    constexpr std::size_t most = 6;
    if (mechanism.joints.empty())
        return mechanism.whole.has(TieKind::sleeve) ? "what is on sleeves can slide"
                                                    : "it can move as a whole";
    std::string text;
    for (std::size_t i = 0; i < std::min(mechanism.joints.size(), most); ++i)
        text += (i == 0 ? "" : ", ") + model.joints[static_cast<std::size_t>(mechanism.joints[i])].name;
    const bool is_one = mechanism.joints.size() == 1;
    if (mechanism.joints.size() > most) text += fmt::format(" and {} more", mechanism.joints.size() - most);
    return fmt::format("joint{} {} can move", is_one ? "" : "s", text);
}

// Loads can hold them where they are in equilibrium, as gravity holds a pendulum that hangs.
void find_free_joints(const Model& model, std::vector<Finding>& findings) {
    for (const FreeMechanism& free : find_free_mechanisms(model)) {
        findings.push_back(
            {Severity::warning,
             fmt::format(
                 "{} has {} at t = 0: {}; a static analysis needs supports, springs or motors that prevent "
                 "{}, or loads that hold it",
                 name_part(free.whole, model),
                 free.motions == 1 ? "1 free motion" : fmt::format("{} free motions", free.motions),
                 describe_moving(free, model),
                 free.motions == 1 ? "it" : "them")});
    }
}

// Explicit schemes invert no stiffness.
bool solves_equilibria(const AnalysisSettings& analysis) {
    if (!has_steps(analysis)) return false;
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    return !dynamic || !card_of(dynamic->scheme).is_explicit;
}

void warn_of_contrasts(const Model& model,
                       const std::vector<ModelPart>& parts,
                       std::vector<Finding>& findings) {
    for (const StiffnessContrast& contrast : find_stiffness_contrasts(model, parts)) {
        findings.push_back({Severity::warning, describe(contrast, model) + "; expected " + advise(contrast)});
    }
}

// Says which tangent motions take, where the model decides it.
void note_tangent(const Model& model, const AnalysisSettings& analysis, std::vector<Finding>& findings) {
    const TangentChoice choice = choose_tangent(model, analysis);
    if (!choice.reason) return;
    findings.push_back({Severity::note,
                        describe(*choice.reason, model) +
                            "; newton.tangent is \"mixed\", so that steps need not be cut for that"});
}

// Where steps are chosen by errors that friction hides.
void note_friction(const Model& model, const AnalysisSettings& analysis, std::vector<Finding>& findings) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    if (dynamic == nullptr || !dynamic->has_inertia || !dynamic->adaptive) return;
    if (card_of(dynamic->scheme).order <= 2.0) return;
    const std::string rubs = find_friction(model);
    if (rubs.empty()) return;
    findings.push_back(
        {Severity::note,
         rubs + " has friction: where it sticks or slips, errors can be far above the accuracy that "
                "is asked for; integrator = \"generalized-alpha\" keeps nearer to it"});
}

void warn_of_newton_tolerance(const AnalysisSettings& analysis, std::vector<Finding>& findings) {
    const std::optional<double> given = newton_of(analysis).tolerance;
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    if (!given || dynamic == nullptr || !dynamic->adaptive) return;
    if (*given <= tolerable_newton_part * dynamic->adaptive->tolerance) return;
    findings.push_back({Severity::warning,
                        fmt::format("newton.tolerance, {:.3g}, limits the accuracy that adaptive.tolerance, "
                                    "{:.3g}, asks for; expected at most {:.2g}, or none: then it follows",
                                    *given,
                                    dynamic->adaptive->tolerance,
                                    derive_newton_tolerance(analysis))});
}

void describe_parts(const Model& model, const std::vector<ModelPart>& parts, std::vector<Finding>& findings) {
    constexpr std::size_t most = 10;
    if (parts.size() < 2) return;
    std::string text = fmt::format("nothing connects these {} parts: ", parts.size());
    for (std::size_t i = 0; i < std::min(parts.size(), most); ++i) {
        text += (i == 0 ? "" : "; ") + name_part(parts[i], model);
    }
    findings.push_back({Severity::note, parts.size() > most ? text + " …" : text});
}

void find_idle_loads(const Model& model, std::vector<Finding>& findings) {
    for (const NodalLoad& load : model.loads) {
        const bool is_idle =
            std::any_of(model.supports.begin(), model.supports.end(), [&](const Support& support) {
                return support.node == load.node && (!load.has_force() || support.holds_all(0)) &&
                       (!load.has_moment() || support.holds_all(3));
            });
        // What flows through a rod pushes on its ends whether they are held or not.
        const bool is_flow = load.key.ends_with(".fluid.contents.velocity");
        if (!is_idle || is_flow) continue;
        findings.push_back({Severity::warning,
                            fmt::format("{} acts at {}, where a support holds all that it drives; only the "
                                        "reaction feels it",
                                        load.key,
                                        model.nodes[load.node].name)});
    }
}

void note_lack_of_potential(const Model& model, std::vector<Finding>& findings) {
    const std::string load = find_load_without_potential(model);
    if (load.empty()) return;
    const bool has_shapes = !model.contact.between_rods && !model.contact.within_rods;
    findings.push_back({Severity::note,
                        load +
                            ", so it has no potential and the tangent's negative pivots do not count "
                            "unstable shapes: the run reports only where the tangent's determinant changes "
                            "its sign" +
                            (has_shapes ? ". A stage of kind eigenvalues after this one shows whether the "
                                          "structure stays there"
                                        : "")});
}

double compute_mass(const Model& model) {
    double mass = 0.0;
    for (const Rod& rod : model.rods) mass += model.sections[rod.section].mass(0, 0) * rod.length;
    for (const Body& body : model.bodies) mass += body.mass;
    return mass;
}

bool is_pushed_by_fluids(const Surroundings& surroundings) {
    const auto& [water, air, seabed] = surroundings;
    return (water && (!water->current.is_still() || !water->waves.empty())) || (air && !air->wind.is_still());
}

bool any_load(const Model& model) {
    const auto strains = [&](const auto& tie) { return is_strained(model, tie); };
    const auto acts = [](const auto& load) { return load.acts(); };
    const auto is_bent = [](const Rod& rod) { return !rod.starts_free_of_stress(); };
    const auto moves = [](const Support& support) { return support.moved != std::array<bool, 6>{}; };
    const auto is_moved_obstacle = [](const Obstacle& obstacle) { return obstacle.motion.has_value(); };
    return model.rotation || !model.gravity.is_zero() || is_pushed_by_fluids(model.surroundings) ||
           !model.actuations.empty() || !model.tendons.empty() ||
           std::ranges::any_of(model.contact.obstacles, is_moved_obstacle) ||
           any_element_tie(model, strains) || std::ranges::any_of(model.rods, is_bent) ||
           has_joint_drive(model) || std::any_of(model.loads.begin(), model.loads.end(), acts) ||
           std::any_of(model.distributed_loads.begin(), model.distributed_loads.end(), acts) ||
           std::any_of(model.supports.begin(), model.supports.end(), moves);
}

bool any_velocity(const Model& model) {
    return std::any_of(model.nodes.begin(), model.nodes.end(), [](const Node& node) {
        return !node.velocity.isZero(0.0) || !node.angular_velocity.isZero(0.0);
    });
}

void find_missing_causes(const Model& model,
                         const AnalysisSettings& analysis,
                         std::vector<Finding>& findings) {
    if (!model.gravity.is_zero() && compute_mass(model) == 0.0) {
        findings.push_back({Severity::warning, "gravity acts on nothing: the model has no mass"});
    }
    if (any_load(model) || !has_steps(analysis)) return;
    if (!is_timed(analysis)) {
        findings.push_back({Severity::warning, "nothing loads the model: it has no load, gravity or move"});
    } else if (!any_velocity(model)) {
        findings.push_back({Severity::warning,
                            "nothing sets the model in motion: it has no load, gravity, move or velocity"});
    }
}

// Moments that are rounded or roughly known; others are refused by the reader.
void find_odd_bodies(const Model& model, std::vector<Finding>& findings) {
    for (const Body& body : model.bodies) {
        const Vec3 moments = find_symmetric_eigen(body.inertia).values;
        if (!exceed_sum(moments)) continue;
        findings.push_back(
            {Severity::warning,
             fmt::format(
                 "body {} has the principal moments {:.6g}, {:.6g}, {:.6g}, the largest above the sum of the "
                 "others: no body of mass has them, and it is moved as they say; {:.6g} would be the most",
                 body.name,
                 moments[0],
                 moments[1],
                 moments[2],
                 moments[0] + moments[1])});
    }
}

// Of stages of buckling, which look at what acts in the last stage with steps before them.
void examine_buckling(const Model& model,
                      const std::vector<StagePlan>& stages,
                      std::vector<Finding>& findings) {
    Model acting = model;
    bool is_at_reference = true;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        is_at_reference = is_at_reference && !has_steps(stages[i].analysis);
        if (i > 0 && has_steps(stages[i].analysis)) {
            acting = model;
            set_actions(stages[i].actions, acting);
        }
        if (!std::holds_alternative<BucklingSettings>(stages[i].analysis)) continue;
        std::string reason = find_reason_against_factors(acting);
        if (reason.empty() && is_at_reference) reason = find_moved_obstacle(acting);
        if (reason.empty()) continue;
        const std::string prefix = stages[i].name.empty() ? "" : "stage " + stages[i].name + ": ";
        findings.push_back({Severity::error, prefix + reason});
    }
}

}  // namespace

std::vector<Finding> examine_model(const Model& model,
                                   const AnalysisSettings& analysis,
                                   AnalysisStart start) {
    const bool begins_at_rest = start == AnalysisStart::deck;
    const std::vector<ModelPart> parts = find_parts(model);
    std::vector<Finding> findings;
    if (has_steps(analysis) && !needs_inertia(analysis)) {
        find_drifting_parts(model, begins_at_rest, findings);
        find_free_joints(model, findings);
        note_lack_of_potential(model, findings);
    }
    if (std::holds_alternative<SteadySettings>(analysis) && model.rotation) {
        const std::string cause = find_unsteady_action(model, *model.rotation);
        if (!cause.empty()) findings.push_back({Severity::error, cause});
    }
    if (solves_equilibria(analysis)) {
        warn_of_contrasts(model, parts, findings);
        note_tangent(model, analysis, findings);
        warn_of_newton_tolerance(analysis, findings);
        note_friction(model, analysis, findings);
    }
    for (const std::string& sentence : find_unconnected_points(model)) {
        findings.push_back({Severity::warning, sentence});
    }
    for (const std::string& sentence : find_motor_conflicts(model)) {
        findings.push_back({Severity::warning, sentence});
    }
    find_odd_bodies(model, findings);
    if (is_timed(analysis)) {
        for (const std::string& sentence : find_turning_bushings(model))
            findings.push_back({Severity::warning, sentence});
    }
    if (const auto* dynamic = std::get_if<DynamicSettings>(&analysis)) {
        for (const Finding& finding : examine_functions(model, *dynamic, start == AnalysisStart::motion))
            findings.push_back(finding);
    }
    find_idle_loads(model, findings);
    if (const std::string push = find_push_out_of_plane(model); !push.empty())
        findings.push_back({Severity::warning, push});
    for (Finding& finding : examine_surroundings(model, analysis)) findings.push_back(std::move(finding));
    if (begins_at_rest) {
        for (Finding& finding : examine_contact(model, analysis)) findings.push_back(std::move(finding));
        find_missing_causes(model, analysis, findings);
    }
    describe_parts(model, parts, findings);
    return findings;
}

std::vector<Finding> examine_stages(const Model& model, const std::vector<StagePlan>& stages) {
    std::vector<Finding> findings = examine_model(model, stages.front().analysis);
    if (const std::string coarse = describe_coarse_rods(model); !coarse.empty())
        findings.push_back({Severity::warning, coarse});
    const auto is_new = [&](const Finding& finding) {
        return std::none_of(findings.begin(), findings.end(), [&](const Finding& other) {
            return other.message == finding.message;
        });
    };
    const auto leaves_motion = [](const AnalysisSettings& analysis) {
        return is_timed(analysis) || std::holds_alternative<SteadySettings>(analysis);
    };
    AnalysisStart start = AnalysisStart::equilibrium;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (!has_steps(stages[i].analysis)) continue;
        const AnalysisStart own_start = start;
        start = leaves_motion(stages[i].analysis) ? AnalysisStart::motion : AnalysisStart::equilibrium;
        if (i == 0) continue;
        Model own = model;
        set_actions(stages[i].actions, own);
        for (Finding& finding : examine_model(own, stages[i].analysis, own_start)) {
            if (!is_new(finding)) continue;
            finding.message = "stage " + stages[i].name + ": " + finding.message;
            findings.push_back(std::move(finding));
        }
    }
    examine_buckling(model, stages, findings);
    return findings;
}

bool has_error(const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.severity == Severity::error;
    });
}

std::string describe(const Finding& finding) {
    static constexpr std::array<const char*, 3> words{"note", "warning", "error"};
    return fmt::format("{}: {}", words[static_cast<std::size_t>(finding.severity)], finding.message);
}

}  // namespace gxrod
