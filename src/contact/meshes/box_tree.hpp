#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// A box parallel to the axes.
struct Box {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void include(const Vec3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    Vec3 middle() const { return 0.5 * (low + high); }
    // Returns the squared distance of a point; 0 within.
    double squared_distance(const Vec3& point) const {
        return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
    }
    bool contains(const Box& other) const {
        return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
    }
    bool meets(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

// Boxes of fixed things in a tree that is built once. Things are indices of the boxes.
class BoxTree {
  public:
    explicit BoxTree(const std::vector<Box>& boxes);

    // Calls visit(thing) for each thing whose box meets this one.
    template <class Visit>
    void visit_meeting(const Box& box, const Visit& visit) const {
        walk([&](const Box& of_node) { return of_node.meets(box); }, visit);
    }

    // Finds the nearest thing, of equal ones that with the least index; −1 if none is nearer than `within`,
    // which becomes its distance. measure(thing) is the distance of the point from a thing, no less than from
    // its box but for `rounding`: so it is the least of all things to the last bit.
    template <class Measure>
    int find_nearest(const Vec3& point, double rounding, double& within, const Measure& measure) const {
        int nearest = -1;
        struct Entry {
            int node;
            double squared_distance;
        };
        std::array<Entry, most_depth> stack;
        std::size_t size = 0;
        const auto can_hold = [&](double squared) {
            return squared <= (within + rounding) * (within + rounding);
        };
        const auto push = [&](int node) {
            const double squared = nodes_[static_cast<std::size_t>(node)].box.squared_distance(point);
            if (can_hold(squared)) stack[size++] = {node, squared};
        };
        if (!nodes_.empty()) push(0);
        while (size > 0) {
            const Entry entry = stack[--size];
            if (!can_hold(entry.squared_distance)) continue;
            const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
            if (node.count == 0) {
                push(node.first);
                push(node.first + 1);
                if (size > 1 && stack[size - 2].squared_distance < stack[size - 1].squared_distance)
                    std::swap(stack[size - 2], stack[size - 1]);
                continue;
            }
            for (int i = node.first; i < node.first + node.count; ++i)
                take_if_nearer(things_[static_cast<std::size_t>(i)], measure, nearest, within);
        }
        return nearest;
    }

    // Takes a thing as the nearest one if it is.
    template <class Measure>
    static void take_if_nearer(int thing, const Measure& measure, int& nearest, double& within) {
        const double distance = measure(thing);
        if (!(distance < within || (distance == within && thing < nearest))) return;
        within = distance;
        nearest = thing;
    }

  private:
    // A node with two children, next to each other, or with some things.
    struct Node {
        Box box;
        int first = 0;
        int count = 0;  // number of things; 0: children
    };
    static constexpr std::size_t most_depth =
        128;  // more than twice the depth that halving 2³¹ things can take

    void split(int node, int first, int end, const std::vector<Box>& boxes);

    template <class Enters, class Visit>
    void walk(const Enters& enters, const Visit& visit) const {
        std::array<int, most_depth> stack;
        std::size_t size = 0;
        if (!nodes_.empty()) stack[size++] = 0;
        while (size > 0) {
            const Node& node = nodes_[static_cast<std::size_t>(stack[--size])];
            if (!enters(node.box)) continue;
            if (node.count == 0) {
                stack[size++] = node.first + 1;
                stack[size++] = node.first;
                continue;
            }
            for (int i = node.first; i < node.first + node.count; ++i)
                visit(things_[static_cast<std::size_t>(i)]);
        }
    }

    std::vector<Node> nodes_;
    std::vector<int> things_;
};

}  // namespace gxrod
