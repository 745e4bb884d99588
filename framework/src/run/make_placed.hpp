#pragma once

#include "run/assemble.hpp"
#include "run/maker.hpp"

#include <vector>

namespace matpoint {

/// Boundary conditions, and where they hold.
template <class S>
void make_conditions(Maker& maker, std::vector<PlacedCondition<S>>& conditions);
/// Contacts, the bodies that they are between, and the layers of velocity that follow from these.
template <class S>
void make_contacts(Maker& maker, Components<S>& components);
void make_outputs(Maker& maker, std::vector<ScheduledOutput>& outputs);

}  // namespace matpoint
