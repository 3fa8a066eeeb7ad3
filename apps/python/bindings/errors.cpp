#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "deck/text/fault.hpp"
#include "face/convergence_error.hpp"
#include "face/unknown_name_error.hpp"
#include "machine/file_error.hpp"
#include "model/evaluation_error.hpp"
#include "module.hpp"
#include "sensitivity/sensitivity_error.hpp"

namespace gxrod::python {

namespace {

// Sets the error of this name of gxrod.errors.
void set_error(const char* name, const nb::object& arguments) {
    const nb::object type = nb::module_::import_("gxrod.errors").attr(name);
    PyErr_SetObject(type.ptr(), arguments.ptr());
}

nb::object list_faults(const DeckError& error) {
    nb::list faults;
    for (const DeckFault& fault : error.faults)
        faults.append(nb::make_tuple(fault.file, fault.line, fault.column, fault.key, fault.message));
    return nb::make_tuple(nb::tuple(faults));
}

nb::object list_failure(const ConvergenceError& error) {
    const std::optional<Failure>& failure = error.failure;
    if (!failure) return nb::str(error.what());
    return nb::make_tuple(error.what(),
                          failure->time,
                          failure->time_step,
                          name_of(failure->outcome),
                          failure->places,
                          advise(*failure));
}

}  // namespace

void bind_errors(nb::module_&) {
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const DeckError& error) {
            set_error("DeckError", list_faults(error));
        } catch (const FileError& error) {
            set_error("FileError", nb::str(error.what()));
        } catch (const EvaluationError& error) {
            set_error("EvaluationError", nb::str(error.what()));
        } catch (const ConvergenceError& error) {
            set_error("ConvergenceError", list_failure(error));
        } catch (const UnknownNameError& error) {
            set_error("UnknownNameError", nb::str(error.what()));
        } catch (const SensitivityError& error) {
            set_error("Error", nb::str(error.what()));
        }
    });
}

}  // namespace gxrod::python
