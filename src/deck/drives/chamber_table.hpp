#pragma once

#include "deck/drives/tendon_path.hpp"

namespace gxrod {

// A closed amount of gas in a chamber.
struct GasTable : TableHead {
    CheckedTimeFunction pressure;
    double ambient = 0.0;
    double exponent = 1.0;
    std::optional<double> volume;
};

// A chamber along a rod: a path as of a tendon, and what fills it and pushes along it.
struct ChamberTable : TendonTable {
    double area = 0.0;
    std::optional<CheckedTimeFunction> pressure, volume;
    std::optional<GasTable> gas;
};

const TableSpec& chamber_table();

// Adds the chambers of the deck to the model's tendons, behind those of the deck, as they act in the current
// stage: a chamber of the area A under the pressure p is a tendon with the tension −p A. A chamber whose
// volume is given is a tendon of a given length; gas is a law in place of a winch.
void build_chambers(BuildContext& context);

}  // namespace gxrod
