#include "deck/supports/component_numbers.hpp"

#include "model/model.hpp"

namespace gxrod {
namespace {

TableSpec declare_components(const std::string& path, const char* along, const char* about) {
    Table<ComponentNumbers> table(path, "");
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string axis(1, component_names[i].back());
        table
            .key(
                std::string(component_names[i]),
                [i](auto& components) -> auto& { return components.values[i]; },
                (i < 3 ? "Along " : "About ") + axis + ".")
            .unit(i < 3 ? along : about)
            .at_least(0);
    }
    return table;
}

}  // namespace

TableSpec stiffness_components(const std::string& path) {
    return declare_components(path, "force/length", "force·length/angle");
}

TableSpec damping_components(const std::string& path) {
    return declare_components(path, "force·time/length", "force·length·time/angle");
}

}  // namespace gxrod
