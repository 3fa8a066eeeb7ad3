#pragma once

#include "deck/drives/tendon_path.hpp"

namespace gxrod {

// A chamber along a rod: a path as of a tendon, and a pressure that pushes along it.
struct ChamberTable : TendonTable {
    double area = 0.0;
    CheckedTimeFunction pressure;
};

const TableSpec& chamber_table();

// Adds the chambers of the deck to the model's tendons, behind those of the deck, as they act in the current
// stage: a chamber of the area A under the pressure p is a tendon with the tension −p A.
void build_chambers(BuildContext& context);

}  // namespace gxrod
