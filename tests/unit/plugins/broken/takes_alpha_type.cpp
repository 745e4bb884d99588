#include "../point.hpp"

MATPOINT_PLUGIN("takes_alpha_type", "0.0.1") {
    registry.geometry<Point>("alpha_point");
}
