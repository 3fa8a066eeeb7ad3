#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "model.hpp"
#include "module.hpp"

namespace gxrod::python {

namespace {

using nb::literals::operator""_a;

nb::dict describe_rods(const BuiltModel& model) {
    nb::dict rods;
    for (const Rod& rod : model.problem.model.rods)
        rods[rod.name.c_str()] =
            nb::make_tuple(rod.nodes, arc_lengths_of_nodes(rod), rod.element_nodes, rod.order);
    return rods;
}

std::vector<std::string> list_inputs(const BuiltModel& model) {
    std::vector<std::string> names;
    for (const std::shared_ptr<Input>& input : model.problem.model.inputs) names.push_back(input->name());
    return names;
}

std::vector<std::string> list_histories(const BuiltModel& model) {
    std::vector<std::string> names;
    for (const HistoryRequest& request : model.problem.output.histories) names.push_back(request.name);
    return names;
}

}  // namespace

void bind_deck(nb::module_& module) {
    nb::class_<Deck>(module, "Deck", "A deck that was read once and is built many times.")
        .def(nb::init<const std::filesystem::path&>(), "path"_a)
        .def(
            "__init__",
            [](Deck* place, std::string text, const std::filesystem::path& file) {
                new (place) Deck(Deck::from_text(std::move(text), file));
            },
            "text"_a,
            "file"_a)
        .def_prop_ro("text", &Deck::text)
        .def_prop_ro("file", &Deck::file);
    nb::class_<BuiltModel>(module, "Model", "A deck that was checked and built.")
        .def(nb::init<const Deck&, const std::vector<std::string>&>(), "deck"_a, "overrides"_a)
        .def_prop_ro("text", [](const BuiltModel& model) { return model.problem.record.text; })
        .def_prop_ro("notes", [](const BuiltModel& model) { return model.problem.notes; })
        .def_prop_ro("nodes", [](const BuiltModel& model) { return model.problem.model.nodes.size(); })
        .def_prop_ro("rods", &describe_rods, "{name: (nodes, arc lengths, nodes of each element, order)}.")
        .def_prop_ro(
            "bodies",
            [](const BuiltModel& model) {
                nb::dict bodies;
                for (const Body& body : model.problem.model.bodies) bodies[body.name.c_str()] = body.node;
                return bodies;
            },
            "{name: node}.")
        .def_prop_ro(
            "sections",
            [](const BuiltModel& model) { return model.problem.model.sections; },
            "Those of the deck, and the means of rods whose section varies.")
        .def_prop_ro("inputs", &list_inputs)
        .def_prop_ro("histories", &list_histories)
        .def("examine", [](const BuiltModel& model) { return check(model.problem); });
}

}  // namespace gxrod::python
