#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "driven.hpp"
#include "module.hpp"
#include "results/restart/restart_form.hpp"
#include "results/tables/step_columns.hpp"
#include "run/summary_json.hpp"

namespace gxrod::python {

namespace {

using nb::literals::operator""_a;
using ReleaseGil = nb::call_guard<nb::gil_scoped_release>;

nb::object copy_array(std::vector<double>&& values, std::size_t columns) {
    auto* kept = new std::vector<double>(std::move(values));
    const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
    const std::size_t rows = columns == 0 ? kept->size() : kept->size() / columns;
    if (columns == 0) return nb::cast(nb::ndarray<nb::numpy, double>(kept->data(), {rows}, owner));
    return nb::cast(nb::ndarray<nb::numpy, double>(kept->data(), {rows, columns}, owner));
}

nb::object copy_whole(const std::vector<std::int64_t>& values) {
    std::vector<double> numbers(values.begin(), values.end());
    return copy_array(std::move(numbers), 0).attr("astype")("int64");
}

nb::dict make_ledger(const Driven& driven) {
    const LedgerRow row = driven.ledger();
    nb::dict ledger;
    for (const LedgerColumn& column : ledger_columns) {
        if (column.is_of_statics) continue;
        const std::array<double, 3> numbers = numbers_of(column, row);
        if (column.width() == 1)
            ledger[column.name] = numbers[0];
        else
            ledger[column.name] = copy_array({numbers.begin(), numbers.end()}, 0);
    }
    return ledger;
}

// Of all steps.
nb::dict make_ledgers(const Driven& driven) {
    nb::dict ledgers;
    for (const LedgerColumn& column : ledger_columns) {
        if (column.is_of_statics) continue;
        const auto width = static_cast<std::size_t>(column.width());
        std::vector<double> values;
        for (const LedgerRow& row : driven.ledgers()) {
            const std::array<double, 3> numbers = numbers_of(column, row);
            values.insert(values.end(), numbers.begin(), numbers.begin() + column.width());
        }
        ledgers[column.name] = copy_array(std::move(values), width == 1 ? 0 : width);
    }
    return ledgers;
}

nb::dict make_elements(Driven& driven) {
    const Snapshot snapshot = driven.stepped_run().take_snapshot(true);
    nb::dict elements;
    const auto add = [&](const char* name, Vec3 SectionValues::*member) {
        std::vector<double> values;
        for (const SectionValues& element : snapshot.elements)
            values.insert(values.end(), (element.*member).begin(), (element.*member).end());
        elements[name] = copy_array(std::move(values), 3);
    };
    add("force", &SectionValues::force);
    add("moment", &SectionValues::moment);
    add("strain", &SectionValues::strain);
    add("curvature", &SectionValues::curvature);
    return elements;
}

// (values, rows, columns) of a matrix on the system's pattern.
nb::tuple make_matrix(const SparsePattern& pattern, const std::vector<double>& values) {
    std::vector<double> entries;
    std::vector<std::int64_t> rows, columns;
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        entries.push_back(values[static_cast<std::size_t>(slot)]);
        rows.push_back(row);
        columns.push_back(column);
    });
    return nb::make_tuple(
        copy_array(std::move(entries), 0), copy_whole(rows), copy_whole(columns), pattern.size());
}

nb::tuple make_matrices(const Driven& driven) {
    const auto [pattern, matrices] = driven.matrices();
    return nb::make_tuple(make_matrix(pattern, matrices.stiffness),
                          make_matrix(pattern, matrices.damping),
                          make_matrix(pattern, matrices.mass));
}

// Of each unknown its node and component, 0 … 5; the latter −1 of multipliers.
nb::object list_unknowns(const Driven& driven) {
    const EquationNumbers& equations = driven.stepped_run().analysis().system().equations();
    std::vector<double> unknowns;
    for (std::int64_t i = 0; i < equations.count(); ++i) {
        const EquationNumbers::Unknown unknown = equations.unknown(i);
        unknowns.insert(unknowns.end(),
                        {static_cast<double>(unknown.node), static_cast<double>(unknown.component)});
    }
    return copy_array(std::move(unknowns), 2).attr("astype")("int64");
}

// The numbers of a checkpoint, and its lists of rows, in the order of the restart table.
nb::tuple freeze(const Checkpoint& checkpoint) {
    RestartPlace place{checkpoint.record, static_cast<std::uint64_t>(checkpoint.rows), 0};
    std::vector<double> numbers;
    visit_numbers(place, [&](const char*, auto& number) { numbers.push_back(static_cast<double>(number)); });
    nb::list lists;
    visit_lists(place.record, [&](const DatasetLabel&, auto& rows) {
        using Row = typename std::remove_cvref_t<decltype(rows)>::value_type;
        RestartNumbers table = table_of<Row>(rows);
        lists.append(copy_array(std::move(table.values), 0).attr("tobytes")());
    });
    return nb::make_tuple(numbers, lists);
}

void thaw(Checkpoint& checkpoint, const nb::tuple& frozen) {
    new (&checkpoint) Checkpoint();
    const auto numbers = nb::cast<std::vector<double>>(frozen[0]);
    const auto lists = nb::cast<nb::list>(frozen[1]);
    RestartPlace place;
    auto next = numbers.begin();
    visit_numbers(place, [&](const char*, auto& number) {
        number = static_cast<std::remove_cvref_t<decltype(number)>>(*next++);
    });
    std::size_t index = 0;
    visit_lists(place.record, [&](const DatasetLabel&, auto& rows) {
        using Row = typename std::remove_cvref_t<decltype(rows)>::value_type;
        const auto bytes = nb::cast<nb::bytes>(lists[index++]);
        RestartNumbers table{count_columns<Row>()};
        const auto* first = static_cast<const double*>(bytes.data());
        table.values.assign(first, first + bytes.size() / sizeof(double));
        rows = rows_of<Row>(table);
    });
    checkpoint.record = std::move(place.record);
    checkpoint.rows = static_cast<std::int64_t>(place.steps);
}

std::vector<VariedNumber> vary_all(const BuiltModel& model, const std::vector<std::string>& numbers) {
    std::vector<VariedNumber> all;
    for (const std::string& number : numbers) all.push_back(vary(model.deck, number));
    return all;
}

void bind_views(nb::class_<Driven>& type) {
    const auto add = [&](const char* name, StateViews::Quantity quantity) {
        const std::string signature =
            fmt::format("def {}(self, /) -> numpy.typing.NDArray[numpy.float64]", name);
        type.def_prop_ro(
            name,
            [quantity](nb::handle_t<Driven> self) {
                auto& driven = nb::cast<Driven&>(self);
                return driven.views.get(quantity, driven.nodes(), self);
            },
            nb::for_getter(nb::sig(signature.c_str())),
            quantity == StateViews::orientation ? "A read-only view [N,4]: w x y z."
                                                : "A read-only view [N,3], global components.");
    };
    add("position", StateViews::position);
    add("velocity", StateViews::velocity);
    add("acceleration", StateViews::acceleration);
    add("angular_velocity", StateViews::angular_velocity);
    add("angular_acceleration", StateViews::angular_acceleration);
    add("rotation_vector", StateViews::rotation_vector);
    add("orientation", StateViews::orientation);
}

}  // namespace

void bind_simulation(nb::module_& module) {
    nb::class_<Checkpoint>(module,
                           "Checkpoint",
                           "An accepted state to return to: `sim.save()` makes it, `sim.restore` returns to "
                           "it; it can be pickled.")
        .def("__getstate__", &freeze)
        .def("__setstate__", &thaw)
        .def_prop_ro("time", &Checkpoint::time, "Of the state, on the axis of sim.time.");
    nb::class_<Driven> type(module, "Simulation", "A run that is driven from outside.");
    type.def(
            "__init__",
            [](Driven* place,
               const BuiltModel& model,
               const std::string& results,
               int threads,
               std::vector<std::string> record,
               const std::vector<std::string>& sensitivities) {
                const nb::gil_scoped_release release;
                new (place) Driven(
                    model.deck.build(),
                    Simulation::Options{results, threads, std::move(record), vary_all(model, sensitivities)});
            },
            "model"_a,
            "results"_a,
            "threads"_a,
            "record"_a,
            "sensitivities"_a)
        .def(
            "step",
            [](Driven& driven) { return driven.follow([&] { return driven.step(); }); },
            ReleaseGil(),
            "False if no step was accepted.")
        .def(
            "advance",
            [](Driven& driven, std::optional<double> until, long most_steps) {
                return driven.follow([&] { return driven.advance(until, most_steps); });
            },
            "until"_a.none(),
            "most_steps"_a,
            ReleaseGil(),
            "The number of steps that were accepted.")
        .def("close", &Driven::close, ReleaseGil())
        .def("interrupt", &Driven::interrupt)
        .def("save", &Driven::save)
        .def(
            "restore",
            [](Driven& driven, const Checkpoint& checkpoint) {
                driven.follow([&] { driven.restore(checkpoint); });
            },
            "checkpoint"_a)
        .def("set", &Driven::set, "input"_a, "value"_a, "It counts from the next step on.")
        .def("input", &Driven::input, "name"_a)
        .def(
            "history",
            [](Driven& driven, std::size_t history, std::size_t quantity) {
                return driven.compute(history, quantity);
            },
            "history"_a,
            "quantity"_a)
        .def("derivative", &Driven::differentiate, "number"_a, "history"_a, "quantity"_a)
        .def(
            "gradient",
            [](const Driven& driven,
               const std::vector<std::tuple<std::size_t, std::size_t, std::vector<double>>>& sum,
               const BuiltModel& model,
               const std::vector<std::string>& numbers,
               const std::vector<std::string>& inputs) {
                const nb::gil_scoped_release release;
                std::vector<WeightedQuantity> all;
                for (const auto& [history, quantity, weights] : sum)
                    all.push_back({history, quantity, weights});
                SweptGradient found = driven.find_gradient(all, vary_all(model, numbers), inputs);
                return std::make_tuple(std::move(found.by_numbers), std::move(found.by_inputs));
            },
            "sum"_a,
            "model"_a,
            "numbers"_a,
            "inputs"_a,
            "By the numbers [n]; by the inputs [S,m].")
        .def("quantities", &Driven::list_quantities, "history"_a)
        .def("ledger", &make_ledger, "{name: number or array [3]}.")
        .def(
            "times",
            [](const Driven& driven) { return copy_array(std::vector(driven.times()), 0); },
            nb::sig("def times(self) -> numpy.typing.NDArray[numpy.float64]"),
            "Of each accepted step [S].")
        .def(
            "records",
            [](const Driven& driven, std::size_t history, std::size_t quantity) {
                const int width = driven.width(history, quantity);
                return copy_array(std::vector(driven.records(history, quantity)),
                                  width == 1 ? 0 : static_cast<std::size_t>(width));
            },
            "history"_a,
            "quantity"_a,
            nb::sig("def records(self, history: int, quantity: int) -> numpy.typing.NDArray[numpy.float64]"),
            "[S], [S,3] or [S,4].")
        .def("ledgers", &make_ledgers, "{name: array [S] or [S,3]}.")
        .def("elements", &make_elements, "{name: array [E,3]}, in section axes at the middles.")
        .def("matrices",
             &make_matrices,
             "(values, rows, columns, size) of the tangent, the damping matrix and the mass matrix.")
        .def("unknowns",
             &list_unknowns,
             nb::sig("def unknowns(self) -> numpy.typing.NDArray[numpy.int64]"),
             "Node and component of each [n,2].")
        .def(
            "summary",
            [](const Driven& driven) {
                return describe_summary(driven.summary(), driven.problem().record.name, "")
                    .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
            },
            "As JSON.")
        .def_prop_ro("time", &Driven::time)
        .def_prop_ro("ended", &Driven::finished)
        .def_prop_ro("reason", [](const Driven& driven) { return driven.summary().reason; })
        .def_prop_ro(
            "last_step",
            [](const Driven& driven) {
                const SolverRow& row = driven.last_step();
                return nb::make_tuple(
                    driven.time(), row.time_step, row.newton_iterations, row.rejected_steps);
            },
            nb::for_getter(nb::sig("def last_step(self, /) -> tuple[float, float, int, int]")),
            "Its time, time step, Newton iterations and rejected steps.")
        .def_prop_ro("part_done",
                     [](const Driven& driven) { return driven.stepped_run().stages().part_done(); })
        .def_prop_ro("stage", &Driven::stage);
    bind_views(type);
}

}  // namespace gxrod::python
