#include <vector>

#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "watch/quantities.hpp"

// [output] and [[history]].
namespace gxrod {

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

namespace {

std::vector<KeySpec> history_keys() {
    return {{.name = "name",
             .type = ValueType::text,
             .presence = Presence::required,
             .sentence = "The name of its group in the results: letters, digits, _ and -, each name once."},
            {.name = "at",
             .type = ValueType::point,
             .presence = Presence::required,
             .sentence = "A point of a rod, between nodes too, a body, a spring, a bushing, a joint, a gear, "
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
             .choices = list_quantity_words()}};
}

}  // namespace

const TableSpec& history_table() {
    static const TableSpec table{
        .path = "history",
        .heading = "[[history]]",
        .sentence =
            "Quantities of a point, a spring, a bushing, a joint, a gear, a tendon, an obstacle or a rod "
            "that "
            "touches something, recorded at every "
            "step, and at times of their own if output.history_interval is given.",
        .keys = history_keys(),
        .example =
            "[[history]]\n"
            "name = \"tip\"\n"
            "at   = \"flyer.end\"\n"
            "quantities = [\"position\", \"velocity\"]\n"};
    return table;
}

}  // namespace gxrod
