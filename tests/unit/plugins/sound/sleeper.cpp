#include "../point.hpp"

MATPOINT_PLUGIN("sleeper", "1.2.3") {
    registry.geometry<Point>("sleeper_point");
}
