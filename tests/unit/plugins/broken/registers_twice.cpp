#include "../point.hpp"

MATPOINT_PLUGIN("registers_twice", "0.0.1") {
    registry.geometry<Point>("twin");
    registry.geometry<Point>("twin");
}
