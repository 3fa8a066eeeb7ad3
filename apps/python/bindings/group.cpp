#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>

#include "driven.hpp"
#include "face/simulation_group.hpp"
#include "module.hpp"

namespace gxrod::python {
namespace {

using nb::literals::operator""_a;
using Numbers = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
using Result = nb::ndarray<double, nb::c_contig, nb::device::cpu>;

std::span<const double> span_of(const Numbers& array, std::size_t size) {
    if (array.size() != size) throw std::invalid_argument("arrays do not fit the group");
    return {array.data(), size};
}

// A group of simulations of Python.
struct Group {
    std::vector<Driven*> members;
    std::size_t inputs;
    SimulationGroup group;

    void follow() {
        for (Driven* member : members) member->views.follow(member->nodes());
    }
    // Copies the observations, the times and whether runs have ended into arrays of Python.
    void copy(const Result& seen, const Result& times) const {
        const std::vector<double>& values = group.observations();
        if (seen.size() != values.size() || times.size() != members.size())
            throw std::invalid_argument("arrays do not fit the group");
        std::copy(values.begin(), values.end(), seen.data());
        for (std::size_t i = 0; i < members.size(); ++i) times.data()[i] = members[i]->time();
    }
};

}  // namespace

void bind_group(nb::module_& module) {
    nb::class_<Group>(module, "Group", "Simulations of one deck that threads advance side by side.")
        .def(
            "__init__",
            [](Group* group,
               const std::vector<Driven*>& members,
               const std::vector<std::string>& inputs,
               const std::vector<std::pair<std::size_t, std::size_t>>& observed,
               int threads) {
                SimulationGroup::Plan plan{inputs, {}};
                for (const auto& [history, quantity] : observed) plan.observed.push_back({history, quantity});
                new (group)
                    Group{members,
                          inputs.size(),
                          SimulationGroup({members.begin(), members.end()}, std::move(plan), threads)};
            },
            "members"_a,
            "inputs"_a,
            "observed"_a,
            "threads"_a,
            nb::keep_alive<1, 2>())
        .def(
            "advance",
            [](Group& self, const Numbers& inputs, const Numbers& until) {
                const std::size_t count = self.members.size();
                const auto values = span_of(inputs, count * self.inputs);
                const auto times = span_of(until, count);
                const nb::gil_scoped_release release;
                std::vector<std::string> failures = self.group.advance(values, times);
                self.follow();
                return failures;
            },
            "inputs"_a,
            "until"_a,
            "Advances member i to until[i], unless that is NaN: why its step failed, or \"\".")
        .def(
            "reset",
            [](Group& self, const std::vector<std::size_t>& members) {
                const nb::gil_scoped_release release;
                self.group.reset(members);
                self.follow();
            },
            "members"_a)
        .def(
            "observe",
            [](Group& self, const std::vector<std::size_t>& members) { self.group.observe(members); },
            "members"_a)
        .def("copy",
             &Group::copy,
             "seen"_a,
             "times"_a,
             "Copies the observations [n,width] and the times [n] into arrays.")
        .def("ended",
             [](const Group& self) {
                 std::vector<bool> ended;
                 for (const Driven* member : self.members) ended.push_back(member->finished());
                 return ended;
             })
        .def_prop_ro("width", [](const Group& self) { return self.group.width(); });
}

}  // namespace gxrod::python
