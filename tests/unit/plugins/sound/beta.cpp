#include "../point.hpp"

MATPOINT_PLUGIN("beta", "1.2.3") {
    registry.geometry<Point>("beta_point");
    registry.geometry<Point>("beta_origin");
}
