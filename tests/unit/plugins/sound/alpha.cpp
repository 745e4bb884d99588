#include "../point.hpp"

MATPOINT_PLUGIN("alpha", "1.2.3") {
    registry.geometry<Point>("alpha_point");
}
