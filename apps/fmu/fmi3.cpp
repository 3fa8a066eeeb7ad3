#include "fmi3.hpp"

#include <memory>
#include <string>

#include "face/fmu_run.hpp"

// The library of an FMU: FMI 3.0 for co-simulation, on gxrod::FmuRun.
namespace {

struct Instance {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    std::unique_ptr<gxrod::FmuRun> run;

    void say(fmi3Status status, const std::string& message) const {
        if (log != nullptr)
            log(environment, status, status == fmi3Warning ? "warning" : "error", message.c_str());
    }
};

Instance& instance_of(fmi3Instance instance) { return *static_cast<Instance*>(instance); }

// Calls an action; an exception is logged and becomes a status.
template <class Action>
fmi3Status guard(fmi3Instance instance, const Action& action) {
    if (instance == nullptr) return fmi3Error;
    try {
        action(*instance_of(instance).run);
        return fmi3OK;
    } catch (const std::exception& error) {
        instance_of(instance).say(fmi3Error, error.what());
    } catch (...) {
        instance_of(instance).say(fmi3Error, "an error without a text");
    }
    return fmi3Error;
}

// Values of types that no variable of gxrod has.
fmi3Status refuse(fmi3Instance instance, std::size_t count) {
    if (count == 0) return fmi3OK;
    if (instance != nullptr) instance_of(instance).say(fmi3Error, "all variables of gxrod are Float64");
    return fmi3Error;
}

}  // namespace

FMI3_EXPORT const char* fmi3GetVersion() { return "3.0"; }
FMI3_EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean, std::size_t, const fmi3String*) {
    return fmi3OK;
}

FMI3_EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String /*name*/,
                                                     fmi3String /*token*/,
                                                     fmi3String resources,
                                                     fmi3Boolean /*visible*/,
                                                     fmi3Boolean /*logs*/,
                                                     fmi3Boolean /*event_mode*/,
                                                     fmi3Boolean /*early_return*/,
                                                     const fmi3ValueReference* /*intermediate*/,
                                                     std::size_t /*intermediate_count*/,
                                                     fmi3InstanceEnvironment environment,
                                                     fmi3LogMessageCallback log,
                                                     fmi3IntermediateUpdateCallback /*update*/) {
    auto instance = std::make_unique<Instance>(environment, log, nullptr);
    try {
        instance->run = std::make_unique<gxrod::FmuRun>(resources == nullptr ? "." : resources);
        return instance.release();
    } catch (const std::exception& error) {
        instance->say(fmi3Error, error.what());
        return nullptr;
    }
}
FMI3_EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String,
                                                      fmi3String,
                                                      fmi3String,
                                                      fmi3Boolean,
                                                      fmi3Boolean,
                                                      fmi3InstanceEnvironment,
                                                      fmi3LogMessageCallback) {
    return nullptr;
}
FMI3_EXPORT fmi3Instance fmi3InstantiateScheduledExecution(fmi3String,
                                                           fmi3String,
                                                           fmi3String,
                                                           fmi3Boolean,
                                                           fmi3Boolean,
                                                           fmi3InstanceEnvironment,
                                                           fmi3LogMessageCallback,
                                                           void (*)(),
                                                           void (*)(),
                                                           void (*)()) {
    return nullptr;
}
FMI3_EXPORT void fmi3FreeInstance(fmi3Instance instance) { delete static_cast<Instance*>(instance); }

FMI3_EXPORT fmi3Status fmi3EnterInitializationMode(
    fmi3Instance instance, fmi3Boolean, fmi3Float64, fmi3Float64 start, fmi3Boolean, fmi3Float64) {
    return guard(instance, [&](gxrod::FmuRun& run) { run.begin(start); });
}
FMI3_EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
    return guard(instance, [](gxrod::FmuRun& run) { run.initialize(); });
}
FMI3_EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance) { return fmi3Error; }
FMI3_EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance) { return fmi3OK; }
FMI3_EXPORT fmi3Status fmi3EnterConfigurationMode(fmi3Instance) { return fmi3OK; }
FMI3_EXPORT fmi3Status fmi3ExitConfigurationMode(fmi3Instance) { return fmi3OK; }
FMI3_EXPORT fmi3Status fmi3Terminate(fmi3Instance) { return fmi3OK; }
FMI3_EXPORT fmi3Status fmi3Reset(fmi3Instance instance) {
    return guard(instance, [](gxrod::FmuRun& run) { run.reset(); });
}

FMI3_EXPORT fmi3Status fmi3GetFloat64(fmi3Instance instance,
                                      const fmi3ValueReference* references,
                                      std::size_t count,
                                      fmi3Float64* values,
                                      std::size_t /*value_count*/) {
    return guard(instance, [&](gxrod::FmuRun& run) {
        for (std::size_t i = 0; i < count; ++i) values[i] = run.get(references[i]);
    });
}
FMI3_EXPORT fmi3Status fmi3SetFloat64(fmi3Instance instance,
                                      const fmi3ValueReference* references,
                                      std::size_t count,
                                      const fmi3Float64* values,
                                      std::size_t /*value_count*/) {
    return guard(instance, [&](gxrod::FmuRun& run) {
        for (std::size_t i = 0; i < count; ++i) run.set(references[i], values[i]);
    });
}

#define GXROD_NO_VALUES(TYPE)                                                                            \
    FMI3_EXPORT fmi3Status fmi3Get##TYPE(                                                                \
        fmi3Instance instance, const fmi3ValueReference*, std::size_t count, void*, std::size_t) {       \
        return refuse(instance, count);                                                                  \
    }                                                                                                    \
    FMI3_EXPORT fmi3Status fmi3Set##TYPE(                                                                \
        fmi3Instance instance, const fmi3ValueReference*, std::size_t count, const void*, std::size_t) { \
        return refuse(instance, count);                                                                  \
    }
GXROD_NO_VALUES(Float32)
GXROD_NO_VALUES(Int8)
GXROD_NO_VALUES(UInt8)
GXROD_NO_VALUES(Int16)
GXROD_NO_VALUES(UInt16)
GXROD_NO_VALUES(Int32)
GXROD_NO_VALUES(UInt32)
GXROD_NO_VALUES(Int64)
GXROD_NO_VALUES(UInt64)
GXROD_NO_VALUES(Boolean)
GXROD_NO_VALUES(String)

FMI3_EXPORT fmi3Status fmi3GetBinary(fmi3Instance instance,
                                     const fmi3ValueReference*,
                                     std::size_t count,
                                     std::size_t*,
                                     const void**,
                                     std::size_t) {
    return refuse(instance, count);
}
FMI3_EXPORT fmi3Status fmi3SetBinary(fmi3Instance instance,
                                     const fmi3ValueReference*,
                                     std::size_t count,
                                     const std::size_t*,
                                     const void* const*,
                                     std::size_t) {
    return refuse(instance, count);
}
FMI3_EXPORT fmi3Status fmi3GetClock(fmi3Instance instance,
                                    const fmi3ValueReference*,
                                    std::size_t count,
                                    bool*) {
    return refuse(instance, count);
}
FMI3_EXPORT fmi3Status fmi3SetClock(fmi3Instance instance,
                                    const fmi3ValueReference*,
                                    std::size_t count,
                                    const bool*) {
    return refuse(instance, count);
}

FMI3_EXPORT fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
    return guard(instance, [&](gxrod::FmuRun& run) {
        auto saved = std::make_unique<gxrod::FmuRun::State>(run.save());
        delete static_cast<gxrod::FmuRun::State*>(*state);
        *state = saved.release();
    });
}
FMI3_EXPORT fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
    return guard(instance,
                 [&](gxrod::FmuRun& run) { run.restore(*static_cast<const gxrod::FmuRun::State*>(state)); });
}
FMI3_EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState* state) {
    if (state == nullptr) return fmi3OK;
    delete static_cast<gxrod::FmuRun::State*>(*state);
    *state = nullptr;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status fmi3DoStep(fmi3Instance instance,
                                  fmi3Float64 time,
                                  fmi3Float64 size,
                                  fmi3Boolean /*no_return_before*/,
                                  fmi3Boolean* needs_events,
                                  fmi3Boolean* terminates,
                                  fmi3Boolean* returned_early,
                                  fmi3Float64* reached) {
    *needs_events = *terminates = *returned_early = false;
    return guard(instance, [&](gxrod::FmuRun& run) {
        run.advance(time + size);
        *reached = run.time();
    });
}

// What gxrod does not have, as modelDescription.xml says; no master calls it.
#define GXROD_NOT_THERE(NAME) \
    FMI3_EXPORT fmi3Status fmi3##NAME() { return fmi3Error; }
GXROD_NOT_THERE(GetNumberOfVariableDependencies)
GXROD_NOT_THERE(GetVariableDependencies)
GXROD_NOT_THERE(SerializedFMUStateSize)
GXROD_NOT_THERE(SerializeFMUState)
GXROD_NOT_THERE(DeserializeFMUState)
GXROD_NOT_THERE(GetDirectionalDerivative)
GXROD_NOT_THERE(GetAdjointDerivative)
GXROD_NOT_THERE(GetIntervalDecimal)
GXROD_NOT_THERE(GetIntervalFraction)
GXROD_NOT_THERE(GetShiftDecimal)
GXROD_NOT_THERE(GetShiftFraction)
GXROD_NOT_THERE(SetIntervalDecimal)
GXROD_NOT_THERE(SetIntervalFraction)
GXROD_NOT_THERE(SetShiftDecimal)
GXROD_NOT_THERE(SetShiftFraction)
GXROD_NOT_THERE(EvaluateDiscreteStates)
GXROD_NOT_THERE(UpdateDiscreteStates)
GXROD_NOT_THERE(EnterContinuousTimeMode)
GXROD_NOT_THERE(CompletedIntegratorStep)
GXROD_NOT_THERE(SetTime)
GXROD_NOT_THERE(SetContinuousStates)
GXROD_NOT_THERE(GetContinuousStateDerivatives)
GXROD_NOT_THERE(GetEventIndicators)
GXROD_NOT_THERE(GetContinuousStates)
GXROD_NOT_THERE(GetNominalsOfContinuousStates)
GXROD_NOT_THERE(GetNumberOfEventIndicators)
GXROD_NOT_THERE(GetNumberOfContinuousStates)
GXROD_NOT_THERE(GetOutputDerivatives)
GXROD_NOT_THERE(ActivateModelPartition)
