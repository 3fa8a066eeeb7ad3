#include "constraints/joints/list_wide_rows.hpp"

#include "constraints/joints/gear_rows.hpp"
#include "constraints/joints/sleeve_rows.hpp"

namespace gxrod {

std::vector<std::unique_ptr<const WideRows>> list_wide_rows(const Model& model) {
    std::vector<std::unique_ptr<const WideRows>> rows;
    for (const Gear& gear : model.gears) rows.push_back(std::make_unique<GearRows>(model, gear));
    for (const Sleeve& sleeve : model.sleeves) rows.push_back(std::make_unique<SleeveRows>(model, sleeve));
    return rows;
}

}  // namespace gxrod
