#include <matpoint/boundary_condition.hpp>

#include "plugins.hpp"

namespace matpoint::conformance {
namespace {

using Prescribed = std::array<bool, 3>;

template <class S>
std::shared_ptr<BoundaryCondition<S>> condition(const Json& own) {
    return make<BoundaryCondition<S>>("boundary_condition", own);
}

TEST(Fixed, PrescribesNoMotion) {
    const auto fixed = condition<Solid>({{"type", "fixed"}, {"on", {"x_min"}}});
    for (const int axis : {-1, 0, 1, 2}) EXPECT_EQ(fixed->prescribes(axis), (Prescribed{true, true, true}));
    EXPECT_EQ(fixed->velocity({1, 2, 3}, 4), Eigen::Vector3d::Zero());
}

TEST(Slip, PrescribesTheNormalComponent) {
    const auto face = condition<Solid>({{"type", "slip"}, {"on", {"x_min"}}});
    EXPECT_EQ(face->prescribes(0), (Prescribed{true, false, false}));
    EXPECT_EQ(face->prescribes(2), (Prescribed{false, false, true}));
    EXPECT_EQ(face->velocity({1, 2, 3}, 4), Eigen::Vector3d::Zero());
    const auto region = condition<Solid>({{"type", "slip"}, {"on", Json::object()}, {"axis", "y"}});
    EXPECT_EQ(region->prescribes(-1), (Prescribed{false, true, false}));
}

TEST(Slip, NeedsAnAxisInARegionOnly) {
    const Schema schema = schema_of("boundary_condition", "slip");
    const Json region = Json::object(), faces = {"x_min"};
    EXPECT_TRUE(has_rule(schema, true, "/axis", {{"on", region}}));
    EXPECT_FALSE(has_rule(schema, true, "/axis", {{"on", region}, {"axis", "y"}}));
    EXPECT_TRUE(has_rule(schema, true, "/axis", {{"on", region}, {"axis", "z"}})) << "there is no z in 2D";
    EXPECT_TRUE(has_rule(schema, true, "/axis", {{"on", faces}, {"axis", "y"}}));
    EXPECT_FALSE(has_rule(schema, true, "/axis", {{"on", faces}}));
}

TEST(Velocity, FollowsItsProfilesAndLeavesNullFree) {
    const Json own = {{"type", "velocity"},
                      {"on", {"x_min"}},
                      {"velocity", {nullptr, "2 * x + t", Json{{"times", {0, 2}}, {"values", {0, 10}}}}}};
    const auto moving = condition<Solid>(own);
    EXPECT_EQ(moving->prescribes(0), (Prescribed{false, true, true}));
    EXPECT_EQ(moving->prescribes(-1), (Prescribed{false, true, true}));
    EXPECT_EQ(moving->velocity({3, 0, 0}, 1), Eigen::Vector3d(0, 7, 5));

    const auto plane =
        condition<PlaneStrainSingle>({{"type", "velocity"}, {"on", {"x_min"}}, {"velocity", {1.5, nullptr}}});
    EXPECT_EQ(plane->prescribes(0), (Prescribed{true, false, false}));
    EXPECT_EQ(plane->velocity({0, 0}, 0), Eigen::Vector2f(1.5, 0));
}

}  // namespace
}  // namespace matpoint::conformance
