#pragma once

#include <map>
#include <string>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/text/table_files.hpp"

// Joints, gears and sleeves, which are joints of type "sleeve".
namespace gxrod {

// Reads the points of the curves of cams that are in files, by joint. If a file is wrong, adds a fault. Adds
// the files' bytes to `records`.
std::map<std::string, std::vector<PlaneCurve::Point>> read_cam_files(const CheckedTable& deck,
                                                                     const TableFiles& files,
                                                                     FaultList& faults,
                                                                     std::vector<MeshRecord>& records);

// Builds the joints of a deck without motors, springs and friction. Call it after build_bodies.
void build_joints(BuildContext& context);
// Builds motors, springs, friction and limits of joints as they act in the current stage. Call it after
// build_supports.
void build_joint_actions(BuildContext& context);

// Builds the gears of a deck. Call it after build_joints.
void build_gears(BuildContext& context);

// Adds the sleeves to the model, which has its rods.
void build_sleeves(BuildContext& context);
// Builds the actions on them in the current stage.
void build_sleeve_actions(BuildContext& context);

}  // namespace gxrod
