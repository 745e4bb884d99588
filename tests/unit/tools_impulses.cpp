// Impulses of a rigid tool: against the conditions that they are the solution of, and conservation laws.

#include "impulses.hpp"

#include <gtest/gtest.h>

#include <random>

namespace matpoint {

class ToolImpulses : public testing::Test {
  protected:
    using Solver = Impulses<2>;
    using Vector = Solver::Vector;

    Motion motion(const Json& own) {
        const Parameters::Context context{
            .space = {Mode::plane_strain, false}, .folder = {}, .registry = nullptr, .scene = &scene_};
        return Motion(own.is_null() ? nullptr : &own, Parameters(own, context), Eigen::Vector3d(0.1, 0.2, 0));
    }

    double any(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    Vector any_vector() { return {any(-1, 1), any(-1, 1)}; }

    /// Points that see some of the nodes each; more points than components of velocity, if so wanted.
    Solver problem(int nodes, int points) {
        Solver solver;
        for (int i = 0; i < nodes; ++i) {
            const double mass = any(0.5, 2);
            Vector ease = Vector::Constant(1 / mass);
            if (i == 0) ease[0] = 0;  // held by a boundary condition
            solver.nodes.push_back({.body = 0, .place = i, .velocity = any_vector(), .ease = ease});
        }
        for (int q = 0; q < points; ++q) {
            const std::size_t begin = solver.parts.size();
            for (int k = 0; k < 3; ++k)
                solver.parts.push_back({(q + k) % nodes, Vector::Constant(any(0.1, 0.5))});
            Vector normal = any_vector();
            normal[1] = std::abs(normal[1]) + 0.2;
            solver.points.push_back({.begin = begin,
                                     .end = solver.parts.size(),
                                     .place = any_vector(),
                                     .normal = normal.normalized(),
                                     .target = any(-0.2, 0.1),
                                     .impulse = any_vector()});
        }
        return solver;
    }

    /// Signorini's and Coulomb's conditions, each within rounding of the velocities.
    void check(const Solver& solver, const Motion& tool, double friction) {
        constexpr double small = 1e-7;
        int pressed = 0, sliding = 0;
        for (const auto& point : solver.points) {
            const Vector w = solver.velocity(point, tool);
            const double over = w.dot(point.normal) - point.target,
                         pressing = point.impulse.dot(point.normal);
            EXPECT_GE(over, -small);
            EXPECT_GE(pressing, 0);
            EXPECT_NEAR(over * pressing, 0, small);
            const Vector across = w - w.dot(point.normal) * point.normal,
                         rubbing = point.impulse - pressing * point.normal;
            EXPECT_LE(rubbing.norm(), friction * pressing * (1 + 1e-12) + 1e-15);
            if (across.norm() > 1e-5 && pressing > 1e-9) {
                EXPECT_NEAR((rubbing + friction * pressing * across.normalized()).norm(), 0, 1e-4 * pressing);
                sliding += friction > 0;
            }
            pressed += pressing > 0;
        }
        pressed_ += pressed;
        sliding_ += sliding;
    }

    Json scene_ = {{"loads", Json::array()}};
    std::mt19937 random_{1};
    int pressed_ = 0, sliding_ = 0;
};

TEST_F(ToolImpulses, ObeyTheConditionsOfContact) {
    for (const double friction : {0.0, 0.2, 0.6})
        for (int k = 0; k < 20; ++k) {
            Solver solver = problem(6, 4);
            Motion tool = motion({{"velocity", {0.1, 0.3}}});
            tool.begin_step(0, 0.1);
            solver.solve(tool, friction);
            check(solver, tool, friction);
        }
    EXPECT_GT(pressed_, 50);
    EXPECT_GT(sliding_, 20);
}

TEST_F(ToolImpulses, OfAToolThatMovesFreelyConserveMomentum) {
    for (int k = 0; k < 20; ++k) {
        Solver solver = problem(6, 4);
        for (auto& node : solver.nodes) node.ease[0] = node.ease[1];
        Motion tool = motion({{"velocity", {0.1, 0.3}}, {"rotation", 0.7}, {"mass", 1.5}, {"inertia", 0.4}});
        const Eigen::Vector3d before = tool.velocity_at(tool.centre());
        const double spin = tool.velocity_at(tool.centre() + Eigen::Vector3d::UnitX())[1] - before[1];
        solver.solve(tool, 0.3);
        check(solver, tool, 0.3);
        EXPECT_GT(pressed_, 0);
        Vector given = Vector::Zero(), of_nodes = Vector::Zero();
        double moment = 0;
        for (const auto& point : solver.points) {
            given += point.impulse;
            const Vector arm = point.place - tool.centre().head<2>();
            moment += arm[0] * point.impulse[1] - arm[1] * point.impulse[0];
        }
        const Eigen::Vector3d after = tool.velocity_at(tool.centre());
        const double turns = tool.velocity_at(tool.centre() + Eigen::Vector3d::UnitX())[1] - after[1];
        EXPECT_NEAR(((after - before).head<2>() * 1.5 + given).norm(), 0, 1e-12);
        EXPECT_NEAR((turns - spin) * 0.4, -moment, 1e-12);
        // What the nodes have is the points' impulses by the same weights that their velocities are read
        // with.
        for (std::size_t q = 0; q < solver.points.size(); ++q)
            for (std::size_t p = solver.points[q].begin; p < solver.points[q].end; ++p)
                of_nodes += solver.parts[p].weight.cwiseProduct(solver.points[q].impulse);
        for (const auto& node : solver.nodes) of_nodes -= node.impulse;
        EXPECT_NEAR(of_nodes.norm(), 0, 1e-12);
    }
}

// Four particles on two nodes: their pressures are not unique, the nodes' motion is.
TEST_F(ToolImpulses, OfMorePointsThanNodesStopAllOfThem) {
    Solver solver;
    for (int i = 0; i < 2; ++i)
        solver.nodes.push_back({.body = 0, .place = i, .velocity = Vector(0, -1 - i), .ease = Vector(1, 1)});
    for (const double at : {0.125, 0.375, 0.625, 0.875}) {
        const std::size_t begin = solver.parts.size();
        solver.parts.push_back({0, Vector::Constant(1 - at)});
        solver.parts.push_back({1, Vector::Constant(at)});
        solver.points.push_back(
            {.begin = begin, .end = begin + 2, .place = Vector(at, 0), .normal = Vector(0, 1), .target = 0});
    }
    Motion rests = motion(nullptr);
    solver.solve(rests, 0);
    for (const auto& point : solver.points) EXPECT_GE(solver.velocity(point, rests)[1], -1e-9);
    // All four at rest: so are the nodes.
    EXPECT_NEAR(solver.nodes[0].velocity[1], 0, 1e-6);
    EXPECT_NEAR(solver.nodes[1].velocity[1], 0, 1e-6);
}

TEST_F(ToolImpulses, AMotionGoesWhereItIsSent) {
    // A quarter turn about a pivot that goes along x; velocity and rotation are quadratic in time.
    Motion tool = motion({{"velocity", {"3*t^2", 0}}, {"rotation", "1.5*pi*t^2"}, {"pivot", {0.5, 0.2}}});
    constexpr int steps = 64;
    for (int k = 0; k < steps; ++k) {
        tool.begin_step(k / double(steps), 1.0 / steps);
        tool.end_step(1.0 / steps);
    }
    EXPECT_NEAR((tool.centre() - Eigen::Vector3d(1.5, 0.2, 0)).norm(), 0, 1e-12);
    const Eigen::Vector3d started = tool.to_start({1.5, 1.2, 0});
    EXPECT_NEAR((started - Eigen::Vector3d(1.5, 0.2, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((tool.from_start({1, 0, 0}) - Eigen::Vector3d(0, 1, 0)).norm(), 0, 1e-12);
}

TEST_F(ToolImpulses, APositionIsThatAtTheEndOfTheStep) {
    Motion tool = motion({{"position", {"0.1 + sin(t)", nullptr}}});
    tool.begin_step(0, 0.25);
    tool.end_step(0.25);
    EXPECT_NEAR(tool.centre()[0], 0.1 + std::sin(0.25), 1e-15);
    EXPECT_EQ(tool.centre()[1], 0.2);
}

TEST_F(ToolImpulses, WhatMovesFreelyFalls) {
    scene_ = {
        {"loads", {{{"type", "gravity"}, {"acceleration", {0, -9.81}}, {"history", {{"type", "step"}}}}}}};
    Motion tool = motion({{"mass", 2}});
    for (int k = 0; k < 100; ++k) {
        tool.begin_step(k * 0.01, 0.01);
        tool.end_step(0.01);
    }
    EXPECT_NEAR(tool.velocity_at(tool.centre())[1], -9.81, 1e-12);
    EXPECT_NEAR(tool.centre()[1], 0.2 - 9.81 / 2 * 1.01, 1e-12);
}

TEST_F(ToolImpulses, AMotionIsRestored) {
    Motion tool = motion({{"velocity", {0.3, "t"}}, {"rotation", 2}});
    tool.begin_step(0.2, 0.1);
    tool.end_step(0.1);
    Motion other = motion({{"velocity", {0.3, "t"}}, {"rotation", 2}});
    other.restore(tool.state());
    for (Motion* one : {&tool, &other}) {
        one->begin_step(0.3, 0.1);
        one->end_step(0.1);
    }
    EXPECT_EQ(tool.state(), other.state());
}

}  // namespace matpoint
