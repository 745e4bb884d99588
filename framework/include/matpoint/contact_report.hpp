#pragma once

#include <array>
#include <string>

namespace matpoint {

/// What a probe or the summary tells of a contact.
struct ContactReport {
    std::array<double, 3> force{};     ///< N, in the last step, on the first body named, or on the tool
    std::array<double, 3> impulse{};   ///< N s, of it since the start
    std::array<double, 3> torque{};    ///< N m, on the tool about its position
    std::array<double, 3> position{};  ///< m, of the tool
    double friction_work = 0;          ///< J, dissipated since the start
    double penetration = 0;            ///< largest overlap so far, over the cell size
    double first_gap = 0;              ///< at the first impulse, over the cell size
    double touched = 0;                ///< 1 once there was one
};

/// Calls visit(name, number) for every number of a report, as checkpoints name them.
template <class Report, class Visit>
void visit_report(Report& report, const Visit& visit) {
    visit("friction_work", report.friction_work);
    visit("penetration", report.penetration);
    visit("first_gap", report.first_gap);
    visit("touched", report.touched);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string axis(1, "xyz"[c]);
        visit("force_" + axis, report.force[c]);
        visit("impulse_" + axis, report.impulse[c]);
        visit("torque_" + axis, report.torque[c]);
        visit("position_" + axis, report.position[c]);
    }
}

}  // namespace matpoint
