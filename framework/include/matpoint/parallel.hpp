#pragma once

#include <matpoint/particles.hpp>

#include <functional>

namespace matpoint {

/// Number of threads that parallel_for uses; at least 1.
void set_threads(int count);
int threads();

/// Calls body(0) … body(count - 1), in any order and at the same time on several threads. Results
/// must not depend on the order: tasks that write to the same place belong in different calls.
/// `items` is how many particles the tasks handle in all, or what takes as long (a number at each node of a
/// block): few are not worth waking threads for.
/// An exception in a task is thrown again once all have ended.
void parallel_for(Index count, Index items, const std::function<void(Index)>& body);

}  // namespace matpoint
