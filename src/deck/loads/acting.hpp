#pragma once

#include <memory>
#include <optional>
#include <string>

#include "deck/places/build_context.hpp"

// How a load, or the move of a support, acts in the stage at hand.
namespace gxrod {

// The factor of the values of one table, and the stages in which they act.
struct Acting {
    bool is_absent = false;  // does not act in this stage
    bool grows = false;      // a value without t is multiplied by t
    double scale = 1.0;      // of the load case, in the combination that acts
    std::optional<TimeFunction> factor = {};
    // Where t of an earlier stage ended: value and factor keep what they were there; without a factor, a
    // value without t is multiplied by it, as it was in that stage.
    std::shared_ptr<const double> held_at = {};

    // The load factor of a followed limit point, by which the load is multiplied as well.
    std::shared_ptr<const double> limit_load_factor = {};

    TimeFunction apply(const TimeFunction& value) const;
    LineFunction apply(const LineExpression& value) const;
    // The function of a component that depends on the motion; an empty one if it does not act.
    PointFunction apply(const PointFunction& by_motion, bool has_time) const;

  private:
    // By which a value that depends on the motion is multiplied, at the time that acts.
    TimeFunction find_motion_factor(bool has_time) const;
    TimeFunction scale_own(const TimeFunction& own) const;
    LineFunction scale_own(const LineFunction& own) const;
    TimeFunction apply_own(const TimeFunction& value) const;
    LineFunction apply_own(const LineExpression& value) const;
};

// The base of the structs of tables that act in some stages.
struct ActingTable : TableHead {
    std::optional<TableNames> stages;  // all of them if it is not given
    std::optional<StageFunctions> factor;
    std::optional<LoadReference> relative_to;
    std::optional<std::string> load_case;
};

// Describes the key `factor` of the values that `what` names, and its default.
std::string factor_sentence(const std::string& what);
inline constexpr const char* factor_default =
    "1; t in the first stage if that is static and the value has no t";

// Adds the key `case` of a table whose struct is an ActingTable.
template <class T>
void add_load_case(Table<T>& table) {
    table
        .key("case",
             &T::load_case,
             "The name of its load case, by which each [combination.NAME] gives it a factor.")
        .otherwise("none: it acts in all combinations as written")
        .also("load_case loadcase");
}

// Finds how gravity and moves act, which have no factor.
Acting find_acting(const BuildContext& context);
// Finds how a [[load]] acts, or an action from inside.
Acting find_acting(const ActingTable& load, const BuildContext& context);

// Whether a table concerns the stage at hand, going by its key `stages`.
bool acts_in_stage(const ActingTable& table, const BuildContext& context);
// The same of any stage.
bool acts_in_stage(const ActingTable& table, std::size_t stage, const BuildContext& context);

// Faults of `stages` and `factor`: names of stages that the deck does not have, or that look at the state of
// the stage before them and have no loads of their own.
void check_stage_names(const BuildContext& context);

}  // namespace gxrod
