#include "model/model.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

const Quat& Rod::triad_at(int position) const {
    const auto found = std::find(element_nodes.begin(), element_nodes.end(), nodes[position]);
    assert(found != element_nodes.end());
    return triads[found - element_nodes.begin()];
}

void set_line_elements(Rod& rod,
                       const std::vector<double>& arc_length_of_nodes,
                       const std::vector<Quat>& triads_of_nodes) {
    const int elements = (static_cast<int>(rod.nodes.size()) - 1) / rod.order;
    rod.length = arc_length_of_nodes.back();
    for (int e = 0; e < elements; ++e) {
        for (int i = 0; i <= rod.order; ++i) {
            const int position = e * rod.order + i;
            rod.element_nodes.push_back(rod.nodes[position]);
            rod.arc_length.push_back(arc_length_of_nodes[position]);
            rod.triads.push_back(triads_of_nodes[position]);
        }
    }
}

Vec3 find_place(const Model& model, const Anchor& anchor) {
    return anchor.is_ground() ? anchor.arm : Vec3(model.nodes[anchor.node].position + anchor.arm);
}

}  // namespace gxrod
