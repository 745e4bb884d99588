#include <matpoint/parallel.hpp>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace matpoint {

namespace {

int thread_count = 1;

tbb::task_arena& arena() {
    static tbb::task_arena workers;
    return workers;
}

}  // namespace

void set_threads(int count) {
    thread_count = std::max(1, count);
    arena().terminate();
    arena().initialize(thread_count);
}

int threads() {
    return thread_count;
}

void parallel_for(Index count, const std::function<void(Index)>& body) {
    if (thread_count == 1 || count < 2) {
        for (Index i = 0; i < count; ++i) body(i);
        return;
    }
    arena().execute([&] { tbb::parallel_for(Index{0}, count, body); });
}

}  // namespace matpoint
